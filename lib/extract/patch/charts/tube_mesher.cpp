// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/tube_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "extract/level/position.hpp"
#include "extract/patch/charts/inner_vertices.hpp"
#include "extract/patch/fill/turned_loop.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/degenerate_offset.hpp"
#include "extract/topology/regions/arc_loops.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

/// A dominant eigenvector of the degenerate curve.
struct Station {
  Vector3<double> dominant;
  EigenvectorFrame frame;
};

/// Vertices around a tube.
struct Ring {
  Station at;
  TurnedLoop loop;
  Vector3<double> centre{};
  double radius = 0;  ///< the smallest distance of a vertex from the centre

  void measure(const std::vector<Vector3<double>>& places) {
    for (const auto& p : places) centre = centre + (1.0 / static_cast<double>(places.size())) * p;
    radius = std::numeric_limits<double>::infinity();
    for (const auto& p : places) radius = std::min(radius, length(p - centre));
  }
};

template <class Scalar>
class TubeMesher {
 public:
  TubeMesher(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
             const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
             const Level<Scalar>& level, const Sampling& sampling, Patch<Scalar>& out)
      : on_(manifold),
        tet_(tet),
        proved_(proved),
        turn_(sampling.largest_turn()),
        out_(out),
        inner_(manifold, tet, level, out) {
    for (const auto& loop : proved.loops) {
      boundaries_.push_back(loop_vertices(loop, vertices));
      for (const auto& vertex : boundaries_.back()) inner_.take(vertex.position);
    }
  }

  bool mesh() {
    for (std::size_t s = 0; s < proved_.sheets.size(); ++s)
      if (!mesh_a_tube(proved_.sheets[s], proved_.tubes[s])) return false;
    return are_proved_sheets(out_.triangles, boundaries_, proved_.sheets);
  }

  bool mesh_a_tube(const SheetTopology& sheet, const DegenerateArc& arc) {
    const auto& first_boundary = boundaries_[static_cast<std::size_t>(sheet.loops[0])];
    auto last_boundary = boundaries_[static_cast<std::size_t>(sheet.loops[1])];
    // Boundary loops have the sheet on their left: seen along the tube they run opposite ways.
    std::reverse(last_boundary.begin(), last_boundary.end());
    // Frames carried along the curve.
    std::vector<Station> stations;
    const auto& e = arc.dominant;
    for (std::size_t k = 0; k < e.size(); ++k)
      stations.push_back(
          {e[k], k == 0 ? frame_across(e[k]) : frame_across(e[k], stations[k - 1].frame.first)});
    bool clockwise = false;
    auto first = loop_ring(first_boundary, stations.front(), clockwise);
    bool last_clockwise = false;
    const auto last = loop_ring(last_boundary, stations.back(), last_clockwise);
    if (!first || !last || clockwise != last_clockwise) return false;

    double length = 0;
    for (std::size_t k = 1; k < e.size(); ++k)
      length += elementary::acos(std::min(1.0, dot(e[k - 1], e[k])));
    const auto strips = std::max<std::size_t>(
        arc.ends[0].face == arc.ends[1].face ? 2 : 1,
        std::min(static_cast<std::size_t>(std::ceil(length / turn_)), e.size() - 1));
    bool any = false;
    for (std::size_t k = 1; k < strips; ++k) {
      const auto inner = inner_ring(stations[k * (e.size() - 1) / strips], clockwise);
      if (!inner) continue;  // next to a face: the strip is longer there
      const Ring ring = add(*inner);
      join_along_curve(*first, ring, clockwise, detail::kMostSagHalvings);
      first = ring;
      any = true;
    }
    if (!any && arc.ends[0].face == arc.ends[1].face) return false;
    join_along_curve(*first, *last, clockwise, detail::kMostSagHalvings);
    return true;
  }

 private:
  std::optional<Ring> loop_ring(const std::vector<BoundaryVertex>& boundary, const Station& at,
                                bool& clockwise) const {
    auto turned = turned_loop(boundary, at.frame);
    if (!turned) return std::nullopt;
    clockwise = turned->is_clockwise;
    Ring ring{at, std::move(turned->loop)};
    std::vector<Vector3<double>> places;
    for (const auto& v : boundary) places.push_back(v.position);
    ring.measure(places);
    return ring;
  }

  /// A ring whose vertices are not in the patch yet.
  struct InnerRing {
    Ring ring;
    std::vector<InnerVertex<Scalar>> vertices;
  };

  /// The point of the curve about in the middle between two.
  Station between(const Station& a, const Station& b) const {
    const auto& n = on_.characteristic.tensor;
    auto e = unit(a.dominant + b.dominant);
    for (int newton = 0; newton < 2; ++newton) {
      const auto slope = n * e;
      e = unit(e - (0.5 * dot(e, slope) / dot(slope, slope)) * slope);
    }
    return {e, frame_across(e, a.frame.first + b.frame.first)};
  }

  /// Strips between two rings, as many as the curve between them bends.
  void join_along_curve(const Ring& lower, const Ring& upper, bool clockwise, int halvings) {
    const auto inner = inner_ring(between(lower.at, upper.at), clockwise);
    const double sag = inner ? length(inner->ring.centre - 0.5 * (lower.centre + upper.centre)) /
                                   inner->ring.radius
                             : 0;
    if (detail::sag_halvings(sag, halvings) == 0)
      return join_loops(lower.loop, upper.loop, out_.triangles);
    const Ring middle = add(*inner);
    join_along_curve(lower, middle, clockwise, halvings - 1);
    join_along_curve(middle, upper, clockwise, halvings - 1);
  }

  std::optional<InnerRing> inner_ring(const Station& at, bool clockwise) {
    const int count = std::max(4, static_cast<int>(std::ceil(std::numbers::pi / turn_)));
    const auto& e = at.dominant;
    InnerRing result;
    Ring& ring = result.ring;
    ring.at = at;
    std::vector<Vector3<double>> places;
    for (int k = 0; k < count; ++k) {
      const double angle = std::numbers::pi * k / count, side = clockwise ? -1 : 1;
      const auto v = elementary::cos(angle) * at.frame.first +
                     (side * elementary::sin(angle)) * at.frame.second;
      // One of the two tensors with this medium eigenvector is next to e.
      auto tensor = on_.manifold.tensor_at(v);
      const auto other = on_.manifold.tensor_at(-v);
      if (dot(e, other * e) > dot(e, tensor * e)) tensor = other;
      const auto vertex = inner_.at(tensor);
      if (!vertex) return std::nullopt;
      result.vertices.push_back(*vertex);
      places.push_back(position_at(vertex->weights, tet_.simplex.exponents, tet_.points));
      ring.loop.angles.push_back(2 * angle);
    }
    ring.measure(places);
    return result;
  }

  /// The ring, with its vertices in the patch.
  Ring add(const InnerRing& inner) {
    Ring ring = inner.ring;
    for (const auto& vertex : inner.vertices) ring.loop.corners.push_back(inner_.add(vertex));
    return ring;
  }

  const TetManifold& on_;
  const TetWithCurves<Scalar>& tet_;
  const CellTopology<Scalar>& proved_;
  double turn_;
  Patch<Scalar>& out_;
  InnerVertices<Scalar> inner_;
  std::vector<std::vector<BoundaryVertex>> boundaries_;
};

}  // namespace

template <class Scalar>
bool mesh_tubes(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
                const Level<Scalar>& level, const Sampling& sampling, Patch<Scalar>& out) {
  Patch<Scalar> patch;
  if (!TubeMesher<Scalar>(manifold, tet, proved, vertices, level, sampling, patch).mesh())
    return false;
  out = std::move(patch);
  return true;
}

template <class Scalar>
bool mesh_tube(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
               const CellTopology<Scalar>& proved, const SheetTopology& sheet,
               const FaceArcVertices& vertices, const Level<Scalar>& level,
               const Sampling& sampling, Patch<Scalar>& out) {
  if (sheet.loops.size() != 2 || sheet.euler_characteristic != 0) return false;
  for (auto& [arc, loops] : detail::arcs_between_loops(tet, level, proved.loops)) {
    if (loops[0] == loops[1] ||
        !std::is_permutation(loops.begin(), loops.end(), sheet.loops.begin(), sheet.loops.end()))
      continue;
    SheetTopology along = sheet;
    along.loops = {loops[0], loops[1]};
    Patch<Scalar> patch = out;
    if (!TubeMesher<Scalar>(manifold, tet, proved, vertices, level, sampling, patch)
             .mesh_a_tube(along, arc))
      continue;
    out = std::move(patch);
    return true;
  }
  return false;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                   \
  template bool mesh_tubes(const TetManifold&, const TetWithCurves<Scalar>&,             \
                           const CellTopology<Scalar>&, const FaceArcVertices&,          \
                           const Level<Scalar>&, const Sampling&, Patch<Scalar>&);       \
  template bool mesh_tube(const TetManifold&, const TetWithCurves<Scalar>&,              \
                          const CellTopology<Scalar>&, const SheetTopology&,             \
                          const FaceArcVertices&, const Level<Scalar>&, const Sampling&, \
                          Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
