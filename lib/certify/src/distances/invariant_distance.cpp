// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "distances/distance_proof.hpp"
#include "distances/reach_search.hpp"

namespace tensortopo {

namespace {

using Weights = std::array<double, 4>;

/// The level of an invariant in one tetrahedron.
class QuadricInCell : public detail::CellInSpace {
 public:
  QuadricInCell(const TetMesh& mesh, const QuadraticLevel& level, TetMesh::Index tet)
      : CellInSpace(mesh, tet, {}), form_(level, tensors_of(mesh, tet)) {
    // Errors of the weights count as those of the form do.
    error_ = QuadricForm::kError * (1 + geometry().weight_error() / 0x1p-53);
  }

  detail::MovingCorner corner(const SurfaceMesh& surface, SurfaceMesh::Index vertex) const {
    return CellInSpace::corner(surface, vertex,
                               [&](const Weights& weights) { return gradient(weights); });
  }

  double distance(const Weights& weights) const {
    const auto g = gradient(weights);
    return std::abs(polar(weights, weights)) / length(g);
  }

  template <std::size_t Count>
  bool is_on_side(const std::array<Weights, Count>& corners, Verdict side) const {
    for (const Weights& corner : corners)
      for (const double w : corner)
        if (!(w >= 0)) return false;
    const int sign = side == Verdict::positive ? 1 : -1;
    const auto has_sign = [&](const Weights& v, const Weights& w) {
      const double size = size_at(v) * size_at(w);
      return size > QuadricForm::kSmallestSize && sign * polar(v, w) > error_ * size;
    };
    return detail::is_proved_in_parts(
        corners, detail::kCuts, [&](const Weights& c) { return has_sign(c, c); },
        [&](const auto& part) {
          for (std::size_t i = 0; i < part.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
              if (!has_sign(part[i], part[j])) return false;
          return true;
        });
  }

 private:
  static std::array<const SymmetricTensor<double>*, 4> tensors_of(const TetMesh& mesh,
                                                                  TetMesh::Index tet) {
    std::array<const SymmetricTensor<double>*, 4> result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = &mesh.tensors[as_size(mesh.tets[as_size(tet)][i])];
    return result;
  }
  double polar(const Weights& v, const Weights& w) const {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) sum += v[i] * w[j] * form_[i][j];
    return sum;
  }
  double size_at(const Weights& w) const {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += w[i] * form_.size(i);
    return sum;
  }
  Vector3<double> gradient(const Weights& w) const {
    Vector3<double> sum{};
    for (std::size_t i = 0; i < 4; ++i) {
      double slope = 0;
      for (std::size_t j = 0; j < 4; ++j) slope += 2 * w[j] * form_[i][j];
      sum += slope * geometry().weight_gradient(i);
    }
    return sum;
  }

  QuadricForm form_;
  double error_ = 0;
};

struct InvariantCells {
  const TetMesh& mesh;
  const QuadraticLevel& level;

  QuadricInCell at(TetMesh::Index tet) const { return {mesh, level, tet}; }
  /// Tetrahedra with a zero tensor are undecided, if the level is an anisotropy's.
  bool is_undefined_at(TetMesh::Index) const { return false; }
};

}  // namespace

DistanceClaim prove_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             std::span<const std::size_t> triangles, const LevelTopology& topology,
                             const QuadraticLevel& level) {
  return detail::distance_claim(mesh, surface, triangles, topology, InvariantCells{mesh, level}, 0);
}

MovedPlaces moved_places(const TetMesh& mesh, const SurfaceMesh& surface,
                         std::span<const int> reach, const QuadraticLevel& level) {
  return detail::places_moved(mesh, surface, reach, InvariantCells{mesh, level});
}

}  // namespace tensortopo
