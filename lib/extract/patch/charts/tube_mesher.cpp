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
#include "extract/patch/patch_check.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/regions/arc_loops.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

/// A straight strip between two rings leaves the curve by at most so many radii of the tube: else it
/// is halved, if about so many halvings are enough, each of which leaves a quarter of the distance.
constexpr double kLargestSag = 0.5;
constexpr int kMostStripHalvings = 8;

/// Two vectors that span the plane across a dominant eigenvector.
struct Frame {
  Vector3<double> first, second;
};

Frame frame_next_to(const Vector3<double>& e, const Vector3<double>& near) {
  const auto across = near - dot(near, e) * e;
  const auto first = unit(across);
  return {first, cross(e, first)};
}

/// A dominant eigenvector of the degenerate curve.
struct Station {
  Vector3<double> dominant;
  Frame frame;
};

/// Vertices around a tube. Angles are twice those of the medium eigenvector: one turn around the
/// tube is 2 pi.
struct Ring {
  Station at;
  std::vector<std::int32_t> corners;
  std::vector<double> angles;  ///< ascending, within one turn
  Vector3<double> centre{};
  double radius = 0;  ///< the smallest distance of a vertex from the centre

  void measure(const std::vector<Vector3<double>>& places) {
    for (const auto& p : places) centre = centre + (1.0 / static_cast<double>(places.size())) * p;
    radius = std::numeric_limits<double>::infinity();
    for (const auto& p : places) radius = std::min(radius, length(p - centre));
  }
};

/// The difference of two angles in [-pi, pi].
double step(double from, double to) { return std::remainder(to - from, 2 * std::numbers::pi); }

/// Triangles between two rings that run the same way.
void join(const Ring& lower, const Ring& upper,
          std::vector<std::array<std::int32_t, 3>>& triangles) {
  const std::size_t n = lower.corners.size(), m = upper.corners.size();
  std::size_t start = 0;
  for (std::size_t j = 1; j < m; ++j)
    if (std::abs(step(lower.angles[0], upper.angles[j])) <
        std::abs(step(lower.angles[0], upper.angles[start])))
      start = j;
  const double offset = step(lower.angles[0], upper.angles[start]);
  const auto low = [&](std::size_t i) {
    return lower.angles[i % n] - lower.angles[0] + (i >= n ? 2 * std::numbers::pi : 0);
  };
  const auto high = [&](std::size_t j) {
    const std::size_t k = start + j;
    return offset + upper.angles[k % m] - upper.angles[start] +
           2 * std::numbers::pi * static_cast<double>(k / m);
  };
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    const auto a = lower.corners[i % n], b = upper.corners[(start + j) % m];
    if (j == m || (i < n && low(i + 1) + low(i) < high(j + 1) + high(j))) {
      triangles.push_back({a, lower.corners[(i + 1) % n], b});
      ++i;
    } else {
      triangles.push_back({upper.corners[(start + j + 1) % m], b, a});
      ++j;
    }
  }
}

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
    const Vector3<double> axis =
        std::abs(e[0].x) < 0.6 ? Vector3<double>{1, 0, 0} : Vector3<double>{0, 1, 0};
    for (std::size_t k = 0; k < e.size(); ++k)
      stations.push_back({e[k], frame_next_to(e[k], k == 0 ? axis : stations[k - 1].frame.first)});
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
      join_along_curve(*first, ring, clockwise, kMostStripHalvings);
      first = ring;
      any = true;
    }
    if (!any && arc.ends[0].face == arc.ends[1].face) return false;
    join_along_curve(*first, *last, clockwise, kMostStripHalvings);
    return true;
  }

 private:
  /// A boundary loop with its angles, which are mirrored if it runs clockwise.
  std::optional<Ring> loop_ring(const std::vector<BoundaryVertex>& boundary, const Station& at,
                                bool& clockwise) const {
    std::vector<double> angles;
    for (const auto& v : boundary)
      angles.push_back(2 *
                       elementary::atan2(dot(v.medium, at.frame.second), dot(v.medium, at.frame.first)));
    const std::size_t n = boundary.size();
    double turned = 0;
    for (std::size_t i = 0; i < n; ++i) turned += step(angles[i], angles[(i + 1) % n]);
    if (std::abs(std::abs(turned) - 2 * std::numbers::pi) > 1) return std::nullopt;
    clockwise = turned < 0;
    Ring ring;
    ring.at = at;
    std::vector<Vector3<double>> places;
    double angle = clockwise ? -angles[0] : angles[0];
    for (std::size_t i = 0; i < n; ++i) {
      ring.corners.push_back(boundary[i].id);
      ring.angles.push_back(angle);
      places.push_back(boundary[i].position);
      const double forward = step(angles[i], angles[(i + 1) % n]);
      if (clockwise ? !(forward < 0) : !(forward > 0)) return std::nullopt;
      angle += std::abs(forward);
    }
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
    return {e, frame_next_to(e, a.frame.first + b.frame.first)};
  }

  /// Strips between two rings, as many as the curve between them bends.
  void join_along_curve(const Ring& lower, const Ring& upper, bool clockwise, int halvings) {
    const auto inner = inner_ring(between(lower.at, upper.at), clockwise);
    const double sag =
        inner ? length(inner->ring.centre - 0.5 * (lower.centre + upper.centre)) / inner->ring.radius
              : 0;
    if (!(sag > kLargestSag) || sag > std::ldexp(kLargestSag, 2 * halvings))
      return join(lower, upper, out_.triangles);
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
      ring.angles.push_back(2 * angle);
    }
    ring.measure(places);
    return result;
  }

  /// The ring, with its vertices in the patch.
  Ring add(const InnerRing& inner) {
    Ring ring = inner.ring;
    for (const auto& vertex : inner.vertices) ring.corners.push_back(inner_.add(vertex));
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
