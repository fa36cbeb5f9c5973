// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/scaled_field.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "extractor_scalars.hpp"

namespace tensortopo {

namespace {

template <class Scalar>
SymmetricTensor<Scalar> converted(const SymmetricTensor<double>& t) {
  return {Scalar(t.xx), Scalar(t.yy), Scalar(t.zz), Scalar(t.xy), Scalar(t.yz), Scalar(t.xz)};
}

}  // namespace

template <class Scalar>
ScaledField<Scalar>::ScaledField(const TetMesh& m)
    : mesh(&m),
      tensors(m.tensors.size()),
      exponents(m.tensors.size(), 0),
      is_zero(m.tensors.size(), 0) {
  tbb::parallel_for(std::size_t{0}, m.tensors.size(), [&](std::size_t v) {
    using std::ilogb, std::ldexp, std::max;
    // Wider exponents than double's: no difference or scaling can overflow or underflow.
    using Wide = std::conditional_t<std::is_same_v<Scalar, double>, long double, Scalar>;
    const auto d = deviator(converted<Wide>(m.tensors[v]));
    const auto size = [](const Wide& x) { return x < Wide(0) ? Wide(-x) : x; };
    const Wide largest = max({size(d.a), size(d.b), size(d.xy), size(d.yz), size(d.xz)});
    if (!(largest > Wide(0))) {
      is_zero[v] = 1;
      return;
    }
    const int first = -static_cast<int>(ilogb(largest));
    const Wide factor = ldexp(Wide(1), first);
    const Deviator<Scalar> near_one{
        static_cast<Scalar>(factor * d.a), static_cast<Scalar>(factor * d.b),
        static_cast<Scalar>(factor * d.xy), static_cast<Scalar>(factor * d.yz),
        static_cast<Scalar>(factor * d.xz)};
    // sqrt(P) in [1.74, 3.48): P in [3, 12) up to rounding.
    const double norm = std::sqrt(static_cast<double>(norm_form(near_one)));
    const int second = -std::ilogb(norm / 1.74);
    tensors[v] = Scalar(ldexp(Scalar(1), second)) * near_one;
    exponents[v] = first + second;
  });
}

#define TENSORTOPO_INSTANTIATE(Scalar) template struct ScaledField<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
