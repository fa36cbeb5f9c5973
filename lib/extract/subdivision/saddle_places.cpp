// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/saddle_places.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "extract/level/mode_shape.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo::detail {

namespace {

using Eigen::Matrix3d;
using Tensors = std::array<Matrix3d, 4>;

/// A place this much of the bend away from the level or from having no slope is one of a saddle,
/// and it is inside if it has as much of every corner.
constexpr double kFlat = 1.0 / 1024, kInside = 1.0 / 1024;

/// Newton iterations begin at the places of a lattice and end where the bits end that a place can
/// have.
constexpr int kLattice = 12, kSteps = 30, kBits = 40;
constexpr double kLongestStep = 0.25;

/// From a start inside an edge or a face, the first `Corners` of a tetrahedron.
template <int Corners, class Coordinates = Eigen::Matrix<double, Corners - 1, 1>>
std::optional<Coordinates> flat_place(const Tensors& tensors, Coordinates x, double mu) {
  constexpr int kFree = Corners - 1;
  std::array<Matrix3d, 3> along;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = tensors[i + 1] - tensors[0];
    longest = std::max(longest, along[i].norm());
  }
  for (int step = 0; step < kSteps; ++step) {
    Matrix3d tensor = tensors[0];
    for (int i = 0; i < kFree; ++i) tensor += x[i] * along[static_cast<std::size_t>(i)];
    const auto shape = mode_shape(tensor, along);
    const Eigen::Matrix<double, kFree, kFree> hessian =
        shape.hessian.template topLeftCorner<kFree, kFree>();
    Coordinates move = hessian.fullPivLu().solve(-shape.slope.template head<kFree>());
    if (move.norm() > kLongestStep) move *= kLongestStep / move.norm();
    x += move;
    const double inside = std::min(x.minCoeff(), 1 - x.sum());
    if (!(inside > -kLongestStep)) return std::nullopt;
    if (std::ldexp(move.norm(), kBits) > 1) continue;
    // Next to a zero of the field all is steep, and all of that within a short way.
    const double way = std::min(1.0, tensor.norm() / longest);
    const double slope = kFlat * shape.hessian.norm() * way;
    if (!(inside > kInside) || !(shape.slope.norm() < slope) ||
        !(std::abs(shape.mode - mu) < slope * way))
      return std::nullopt;
    return x;
  }
  return std::nullopt;
}

/// The first that is found in the edge or face of the first `Corners` corners in this order.
template <int Corners>
std::optional<std::array<std::int64_t, 4>> flat_place_in(const Tensors& corners,
                                                         const std::array<std::size_t, 4>& order,
                                                         double mu) {
  const Tensors tensors{corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]]};
  const auto whole = [](double weight) {
    return static_cast<std::int64_t>(std::round(std::ldexp(weight, kBits)));
  };
  for (int i = 1; i < kLattice; ++i)
    for (int j = 1; j < (Corners == 3 ? kLattice - i : 2); ++j) {
      Eigen::Matrix<double, Corners - 1, 1> start;
      start[0] = static_cast<double>(i) / kLattice;
      if constexpr (Corners == 3) start[1] = static_cast<double>(j) / kLattice;
      const auto x = flat_place<Corners>(tensors, start, mu);
      if (!x) continue;
      std::array<std::int64_t, 4> shares{};
      shares[order[0]] = whole(1 - x->sum());
      for (int k = 1; k < Corners; ++k)
        shares[order[static_cast<std::size_t>(k)]] = whole((*x)[k - 1]);
      return shares;
    }
  return std::nullopt;
}

}  // namespace

template <class Scalar>
std::vector<std::array<std::int64_t, 4>> saddle_places(const LevelSimplex<Scalar, 4>& simplex,
                                                       const Level<Scalar>& level) {
  const auto deviators = rounded(simplex.tensors);
  Tensors corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = matrix_of(deviators[i]);
  const double mu = level.value.approx();
  std::vector<std::array<std::int64_t, 4>> places;
  for (std::size_t e = 0; e < 6; ++e) {
    std::array<std::size_t, 4> order;
    for (std::size_t k = 0; k < 4; ++k)
      order[k] = static_cast<std::size_t>(kTetEdges[k < 2 ? e : 5 - e][k % 2]);
    if (const auto place = flat_place_in<2>(corners, order, mu)) places.push_back(*place);
  }
  for (std::size_t f = 0; f < 4; ++f) {
    const auto in_face = [&](const auto& place) { return place[f] == 0; };
    if (std::any_of(places.begin(), places.end(), in_face)) continue;  // on an edge of it
    const std::array<std::size_t, 4> order{(f + 1) % 4, (f + 2) % 4, (f + 3) % 4, f};
    if (const auto place = flat_place_in<3>(corners, order, mu)) places.push_back(*place);
  }
  return places;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                            \
  template std::vector<std::array<std::int64_t, 4>> saddle_places(const LevelSimplex<Scalar, 4>&, \
                                                                  const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
