// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "field.hpp"

#include <algorithm>
#include <cmath>

namespace certificate {

Tensor<Ball> enclosure(const Tensor<mpz_class>& m, long& shift) {
  shift = 0;
  for (const mpz_class& x : m)
    shift = std::max(shift, static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)));
  Tensor<Ball> result;
  for (std::size_t k = 0; k < 6; ++k) result[k] = ball_of(m[k], shift);
  return result;
}

Field::Field(const Input& input) : input_(input) {
  for (std::uint32_t v = 0; v < input.tensors.size(); ++v) {
    int lowest = 2000;
    for (const double x : input.tensors[v]) {
      int e = 0;
      std::frexp(x, &e);
      if (x != 0) lowest = std::min(lowest, e - 53);
    }
    exponents_.push_back(lowest == 2000 ? 0 : lowest);
    shifts_.push_back(0);
    balls_.push_back(enclosure(exact(v), shifts_.back()));
  }
}

bool Field::is_zero(std::uint32_t vertex) const {
  const auto& t = input_.tensors[vertex];
  return t[0] == t[1] && t[1] == t[2] && t[3] == 0 && t[4] == 0 && t[5] == 0;
}

Tensor<mpz_class> Field::exact(std::uint32_t vertex) const {
  std::array<mpz_class, 6> t;
  for (std::size_t k = 0; k < 6; ++k) {
    int e = 0;
    const double mantissa = std::frexp(input_.tensors[vertex][k], &e);
    t[k] = std::ldexp(mantissa, 53);  // an integer
    if (t[k] != 0) t[k] <<= static_cast<unsigned long>(e - 53 - exponents_[vertex]);
  }
  return {2 * t[0] - t[1] - t[2], 2 * t[1] - t[0] - t[2], 2 * t[2] - t[0] - t[1],
          3 * t[4], 3 * t[5], 3 * t[3]};
}

}  // namespace certificate
