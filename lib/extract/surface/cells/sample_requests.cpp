// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/sample_requests.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

namespace {

/// From a sample of a curve to one that is asked for next to it, at least, in radians.
constexpr double kLeastTurn = 0x1p-20;

}  // namespace

template <class Scalar>
std::vector<std::size_t> add_requested_samples(const SurfaceInput<Scalar>& input,
                                               const VertexSides& sides, const TetComplex& cells,
                                               std::span<const std::size_t> asking,
                                               const MeshingStates<Scalar>& states,
                                               CellMeshes<Scalar>& meshes) {
  const auto& level = input.level;
  // All that is asked for, face by face.
  struct Wanted {
    std::size_t face;
    int arc;
    Scalar place;
    bool is_needed;  ///< this very point
    auto key() const { return std::tie(face, arc, place); }
  };
  std::vector<Wanted> wanted;
  for (const auto t : asking)
    for (const auto& request : states[t]->requests)
      if (request.arc >= 0 && !meshes.cells[t].unresolved)
        wanted.push_back({as_size(cells.tet_faces[t][static_cast<std::size_t>(request.face)]),
                          request.arc, request.place,
                          meshes.cells[t].mesher == Mesher::subdivision});
  std::sort(wanted.begin(), wanted.end(),
            [](const Wanted& a, const Wanted& b) { return a.key() < b.key(); });
  std::vector<std::size_t> first;  // of each face
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (i == 0 || wanted[i].face != wanted[i - 1].face) first.push_back(i);
  std::vector<char> changed(first.size(), 0);
  parallel_stage(input.options, "tetrahedra", first.size(), 64, [&](std::size_t k) {
    const auto f = wanted[first[k]].face;
    const auto face = input.field.template simplex<3>(cells.faces[f], sides.above).tensors;
    // The two neighbours, and the face itself, often cut the curve at the same point, and an edge
    // of the face may be cut there too. Merging samples along a curve changes no topology; samples
    // between which no eigenvector turns by more than rounding shows would be in no order.
    const auto same = [&](const CurvePoint<Scalar>& p, const CurvePoint<Scalar>& q, bool exactly) {
      const auto differ = [](const Vector3<double>& d, double limit) {
        return dot(d, d) > limit * limit;
      };
      if (!differ(vector_cast<double>(Vector3<Scalar>{p.weights[0] - q.weights[0],
                                                      p.weights[1] - q.weights[1],
                                                      p.weights[2] - q.weights[2]}),
                  0x1p-40))
        return true;
      return !exactly &&
             !differ(cross(vector_cast<double>(p.medium), vector_cast<double>(q.medium)),
                     kLeastTurn) &&
             !differ(cross(vector_cast<double>(dominant_eigenvector(p.tensor, level)),
                           vector_cast<double>(dominant_eigenvector(q.tensor, level))),
                     kLeastTurn);
    };
    for (std::size_t i = first[k]; i < wanted.size() && wanted[i].face == f; ++i) {
      const Scalar& place = wanted[i].place;
      auto& arc = meshes.boundary.arcs[f][static_cast<std::size_t>(wanted[i].arc)];
      const auto point = point_on_arc(arc, face, place, level);
      auto after = std::lower_bound(arc.samples.begin(), arc.samples.end(), place,
                                    [](const auto& s, const Scalar& x) { return s.place < x; });
      const Scalar last(static_cast<double>(arc.pieces.size()));
      const auto neighbour = [&](bool next) {
        if (next && after != arc.samples.end()) return *after;
        if (!next && after != arc.samples.begin()) return *std::prev(after);
        return arc.closed ? (next ? arc.samples.front() : arc.samples.back())
                          : point_on_arc(arc, face, next ? last : Scalar(0), level);
      };
      const bool exactly = wanted[i].is_needed;
      if (same(neighbour(false), point, exactly) || same(neighbour(true), point, exactly)) continue;
      arc.samples.insert(after, point);
      changed[k] = 1;
    }
  });
  std::vector<std::size_t> faces;
  for (std::size_t k = 0; k < first.size(); ++k)
    if (changed[k]) faces.push_back(wanted[first[k]].face);
  return faces;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                    \
  template std::vector<std::size_t> add_requested_samples(                \
      const SurfaceInput<Scalar>&, const VertexSides&, const TetComplex&, \
      std::span<const std::size_t>, const MeshingStates<Scalar>&, CellMeshes<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
