// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/scaled_field.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

template <class Scalar>
ScaledField<Scalar>::ScaledField(const TetMesh& m)
    : mesh(&m),
      tensors(m.tensors.size()),
      exponents(m.tensors.size(), 0),
      is_zero(m.tensors.size(), 0) {
  tbb::parallel_for(std::size_t{0}, m.tensors.size(), [&](std::size_t v) {
    using std::ilogb, std::ldexp, std::max;
    // Wider exponents than double's: no difference or scaling can overflow or underflow.
    using Wide = std::conditional_t<std::is_same_v<Scalar, double>, Extended, Scalar>;
    const auto d = deviator(tensor_cast<Wide>(m.tensors[v]));
    const auto size = [](const Wide& x) { return x < Wide(0) ? Wide(-x) : x; };
    const Wide largest = max({size(d.a), size(d.b), size(d.xy), size(d.yz), size(d.xz)});
    if (!(largest > Wide(0))) {
      is_zero[v] = 1;
      return;
    }
    const int first = -static_cast<int>(ilogb(largest));
    const Wide factor = ldexp(Wide(1), first);
    const auto near_one = tensor_cast<Scalar>(factor * d);
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
