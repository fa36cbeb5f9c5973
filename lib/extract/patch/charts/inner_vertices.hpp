// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>

#include "extract/patch/charts/manifold_mesher.hpp"

namespace tensortopo {

/// Vertices of the level inside a tetrahedron, found from tensors of its field. No two vertices,
/// those of the boundary loops included, are one point.
template <class Scalar>
class InnerVertices {
 public:
  /// @param out where `add` puts them
  InnerVertices(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                const Level<Scalar>& level, Patch<Scalar>& out)
      : on_(manifold), tet_(tet), level_(level), out_(out) {}

  /// A vertex of a boundary loop is here.
  void take(const Vector3<double>& position) {
    taken_.insert({position.x, position.y, position.z});
  }

  /// Is the point of the field with this tensor, up to a positive factor, inside the tetrahedron?
  bool is_inside(const SymmetricTensor<double>& tensor) const {
    return has_one_sign(on_.lift.weights(tensor));
  }

  /// The vertex at a tensor of the field, brought onto the level; nothing if that is not inside, or
  /// where another vertex is.
  std::optional<InnerVertex<Scalar>> at(const SymmetricTensor<double>& tensor) const;

  /// @return its number as a corner, see `Patch`
  std::int32_t add(const InnerVertex<Scalar>& vertex);

 private:
  bool has_one_sign(const std::array<double, 4>& weights) const;
  std::array<double, 3> place_of(const InnerVertex<Scalar>& vertex) const;

  const TetManifold& on_;
  const TetWithCurves<Scalar>& tet_;
  const Level<Scalar>& level_;
  Patch<Scalar>& out_;
  std::set<std::array<double, 3>> taken_;
};

}  // namespace tensortopo
