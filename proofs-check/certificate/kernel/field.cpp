// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "field.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

namespace certificate {

Tensor<Ball> enclosure(const Tensor<mpz_class>& m, long& shift) {
  shift = 0;
  for (const mpz_class& x : m)
    shift = std::max(shift, static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)));
  Tensor<Ball> result;
  for (std::size_t k = 0; k < m.size(); ++k) result[k] = ball_of(m[k], shift);
  return result;
}

Field::Field(const Input& input, Multiples multiples, const ForAll& for_all)
    : input_(input), multiples_(std::move(multiples)) {
  const std::size_t count = input.tensors.size();
  exponents_.resize(count), shifts_.resize(count), is_zero_.resize(count), balls_.resize(count);
  for_all(count, [&](std::size_t v) {
    int lowest = multiples_.one == 0 ? INT_MAX : 0;
    for (const double x : input.tensors[v])
      if (x != 0) lowest = std::min(lowest, std::ilogb(x) - 52);
    exponents_[v] = lowest == INT_MAX ? 0 : lowest;
    const Tensor<mpz_class> t = exact(static_cast<std::uint32_t>(v));
    balls_[v] = enclosure(t, shifts_[v]);
    is_zero_[v] = std::all_of(t.begin(), t.end(), [](const auto& x) { return x == 0; });
  }, "tensors");
}

Tensor<mpz_class> Field::exact(std::uint32_t vertex) const {
  std::array<mpz_class, 6> t;
  for (std::size_t k = 0; k < 6; ++k) {
    int e = 0;
    const double mantissa = std::frexp(input_.tensors[vertex][k], &e);
    t[k] = std::ldexp(mantissa, 53);  // an integer
    if (t[k] != 0) t[k] <<= static_cast<unsigned long>(e - 53 - exponents_[vertex]);
    t[k] *= multiples_.tensor;
  }
  return {
      2 * t[0] - t[1] - t[2], 2 * t[1] - t[0] - t[2], 2 * t[2] - t[0] - t[1],
      3 * t[4], 3 * t[5], 3 * t[3],
      multiples_.trace ? mpz_class(t[0] + t[1] + t[2]) : 0,
      multiples_.one << static_cast<unsigned long>(multiples_.one == 0 ? 0 : -exponents_[vertex])};
}

}  // namespace certificate
