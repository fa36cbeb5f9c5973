// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/describe_vertices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "extract/level/level_in_tet.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "tensortopo/mesh/complete_normals.hpp"

namespace tensortopo {

namespace {

/// The field and its gradient at vertices of the triangles of one tetrahedron after the other.
template <class Scalar>
class GradientsInTet {
 public:
  using Index = TetMesh::Index;
  struct At {
    Deviator<double> tensor;   ///< up to a factor
    Vector3<double> gradient;  ///< of the mode: of unit length, or zero
  };

  GradientsInTet(const ScaledField<Scalar>& field, const TetMesh& mesh)
      : field_(field), mesh_(mesh) {}

  void enter(Index tet) {
    if (tet == tet_) return;
    tet_ = tet;
    known_ = 0;
    const auto& v = mesh_.tets[as_size(tet)];
    // An isotropic vertex must not decide on the scale.
    std::size_t other = 0;
    while (field_.is_zero[as_size(v[other])]) ++other;
    std::array<Deviator<Scalar>, 4> tensors;
    std::array<int, 4> exponents;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
      tensors[i] = field_.tensors[as_size(v[i])];
      exponents[i] = field_.exponents[as_size(v[field_.is_zero[as_size(v[i])] ? other : i])];
      points[i] = mesh_.points[as_size(v[i])];
    }
    tensors_ = rounded(tensors);
    space_.emplace(points, exponents);
  }

  /// Of the surface's vertex v at the point x, in the tetrahedron entered last. Valid until the
  /// next call.
  const At& at(Index v, const Vector3<double>& x) {
    // Triangles of a small patch have their vertices in common.
    const std::size_t first = known_ < kept_.size() ? 0 : known_ - kept_.size();
    for (std::size_t i = known_; i-- > first;)
      if (vertices_[i % kept_.size()] == v) return kept_[i % kept_.size()];
    const std::size_t place = known_++ % kept_.size();
    vertices_[place] = v;
    At& result = kept_[place];
    result.tensor = space_->balanced_tensor(x, tensors_);
    result.gradient = unit_or_zero(space_->gradient(mode_slope(result.tensor), tensors_));
    return result;
  }

 private:
  const ScaledField<Scalar>& field_;
  const TetMesh& mesh_;
  Index tet_ = -1;
  std::array<Deviator<double>, 4> tensors_;
  std::optional<TetGeometry> space_;
  std::array<At, 8> kept_;
  std::array<Index, 8> vertices_{};
  std::size_t known_ = 0;
};

}  // namespace

template <class Scalar>
void describe_vertices(const SurfaceInput<Scalar>& input, const std::vector<char>& is_apex,
                       SurfaceMesh& surface) {
  const auto& mesh = input.mesh;
  const auto level = make_level<double>(input.level.value);
  const std::size_t count = surface.points.size(), triangles = surface.triangles.size();
  surface.normal.assign(count, {0, 0, 0});
  surface.mode.assign(count, input.level.value.approx());
  surface.residual.assign(count, 0);
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first_triangle(count, kNone);
  for (std::size_t i = 0; i < triangles; ++i)
    for (const auto v : surface.triangles[i])
      if (first_triangle[as_size(v)] == kNone) first_triangle[as_size(v)] = i;

  // Normals: the field is only continuous across faces, so a shared vertex gets the mean of the
  // unit gradients in the tetrahedra whose triangles meet there, however many each of them has; at
  // an isotropic vertex each triangle counts. Sums are made in the order of the triangles, a block
  // at a time.
  constexpr std::size_t kBlock = 1 << 14;
  std::vector<std::array<Vector3<double>, 3>> gradients(std::min(kBlock, triangles));
  std::vector<TetMesh::Index> last_tet(count, -1);
  for (std::size_t first = 0; first < triangles; first += kBlock) {
    const std::size_t size = std::min(kBlock, triangles - first);
    parallel_ranges(input.options, "stitch", size, 1024, [&](std::size_t begin, std::size_t end) {
      GradientsInTet<Scalar> inside(input.field, mesh);
      for (std::size_t i = begin; i != end; ++i) {
        const auto& corners = surface.triangles[first + i];
        inside.enter(surface.tet[first + i]);
        Vector3<double> sum{0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k) {
          const auto v = as_size(corners[k]);
          gradients[i][k] = {0, 0, 0};
          if (is_apex[v]) continue;
          const auto& at = inside.at(corners[k], surface.points[v]);
          gradients[i][k] = at.gradient;
          sum += gradients[i][k];
          if (first_triangle[v] != first + i) continue;
          surface.residual[v] = mode_difference(at.tensor, level);
        }
        // The gradient's direction is the same along a ray.
        for (std::size_t k = 0; k < 3; ++k)
          if (is_apex[as_size(corners[k])]) gradients[i][k] = unit_or_zero(sum);
      }
    });
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = as_size(surface.triangles[first + i][k]);
        const auto last = std::exchange(last_tet[v], surface.tet[first + i]);
        if (is_apex[v] || last != surface.tet[first + i]) surface.normal[v] += gradients[i][k];
      }
  }
  parallel_stage(input.options, "stitch", count, 1024,
                 [&](std::size_t v) { surface.normal[v] = unit_or_zero(surface.normal[v]); });
  complete_normals(surface);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                   \
  template void describe_vertices(const SurfaceInput<Scalar>&, const std::vector<char>&, \
                                  SurfaceMesh&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
