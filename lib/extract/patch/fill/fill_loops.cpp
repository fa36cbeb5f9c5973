// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/fill_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "extract/level/position.hpp"
#include "extract/level/tet_geometry.hpp"
#include "extract/patch/fill/fill_loop.hpp"
#include "extract/patch/fill/small_disc.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/patch/patch.hpp"

namespace tensortopo {

namespace {

using Loop = std::vector<BoundaryVertex>;

constexpr std::size_t kMarks = 4;  // beside four faces, in eight bits

/// Two triangles between an edge of one boundary loop, from `from` on, and an edge of another, up
/// to `to`.
struct Bridge {
  double length;
  std::size_t from, to;

  auto operator<=>(const Bridge&) const = default;
};

constexpr std::size_t kBridges = 6;  // tried one after the other

std::vector<Bridge> shortest_bridges(const Loop& first, const Loop& second) {
  const auto may_join = [](const BoundaryVertex& v, const BoundaryVertex& w) {
    return (v.faces & w.faces) == 0;
  };
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j) {
      const auto &a = first[i], &next = first[(i + 1) % first.size()];
      const auto &last = second[(j + second.size() - 1) % second.size()], &w = second[j];
      if (!may_join(a, w) || !may_join(a, last) || !may_join(next, last)) continue;
      bridges.push_back(
          {length(w.position - a.position) + length(next.position - last.position), i, j});
      if (bridges.size() < 4096) continue;
      std::nth_element(bridges.begin(), bridges.begin() + kBridges, bridges.end());
      bridges.resize(kBridges);
    }
  std::sort(bridges.begin(), bridges.end());
  return bridges;
}

using Triangles = std::vector<std::array<std::int32_t, 3>>;

/// One closed way along both boundary loops and the sides of the bridge, with each vertex once. The
/// diagonal of the bridge and its edges of the boundary loops must not be meshed again: their ends
/// share a mark that stands for a face, if not a face itself.
Loop joined(const Loop& first, const Loop& second, const Bridge& bridge, std::uint8_t mark,
            Triangles& triangles) {
  Loop way;
  way.reserve(first.size() + second.size());
  for (std::size_t k = 1; k <= first.size(); ++k)
    way.push_back(first[(bridge.from + k) % first.size()]);
  for (std::size_t k = 0; k < second.size(); ++k)
    way.push_back(second[(bridge.to + k) % second.size()]);
  auto &next = way.front(), &a = way[first.size() - 1], &w = way[first.size()], &last = way.back();
  triangles.push_back({a.id, next.id, last.id});
  triangles.push_back({a.id, last.id, w.id});
  const bool next_apart = (a.faces & next.faces) == 0, w_apart = (last.faces & w.faces) == 0;
  a.faces |= mark, last.faces |= mark;
  if (next_apart) next.faces |= mark;
  if (w_apart) w.faces |= mark;
  return way;
}

/// By the shortest bridge to any of the other boundary loops, but for the first few.
bool join_nearest(Loop& way, std::vector<Loop>& others, std::size_t skipped, Triangles& triangles) {
  if (others.size() > kMarks) return false;
  std::vector<std::pair<Bridge, std::size_t>> shortest;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto bridges = shortest_bridges(way, others[k]);
    if (skipped < bridges.size()) shortest.push_back({bridges[skipped], k});
  }
  if (shortest.empty()) return false;
  const auto [bridge, k] = *std::min_element(shortest.begin(), shortest.end());
  const auto mark = static_cast<std::uint8_t>(1u << (3 + others.size()));
  way = joined(way, others[k], bridge, mark, triangles);
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
  return true;
}

/// Triangles between boundary loops without a vertex inside.
template <class Scalar>
bool mesh_between(const std::vector<Loop>& boundaries, Patch<Scalar>& out) {
  for (std::size_t skipped = 0; skipped < (boundaries.size() > 1 ? kBridges : 1); ++skipped) {
    Patch<Scalar> patch;
    std::vector<Loop> others(boundaries.begin() + 1, boundaries.end());
    Loop way = boundaries[0];
    while (!others.empty())
      if (!join_nearest(way, others, skipped, patch.triangles)) return false;
    if (!fill_loop(way, patch)) continue;
    out.triangles.insert(out.triangles.end(), patch.triangles.begin(), patch.triangles.end());
    return true;
  }
  return false;
}

template <class Scalar>
std::vector<Loop> loops_of(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                           const FaceArcVertices& vertices) {
  const auto loops = static_cast<int>(sheet.loops.size());
  if (loops == 0 || sheet.euler_characteristic != 2 - loops) return {};
  std::vector<Loop> boundaries;
  for (const int loop : sheet.loops)
    boundaries.push_back(loop_vertices(proved.loops[static_cast<std::size_t>(loop)], vertices));
  return boundaries;
}

/// How far a vertex of a collar is from the faces, in weights: at first as far as from half of the
/// way to the next one, and then half as far, so often at most.
constexpr int kCollarHalvings = 40;

/// Steps of Newton's method to the level, and how far they may lead, in heights above the face.
/// What it finds is on the level if its mode is, to within this part of what is left to 1 and
/// roundings.
constexpr int kCollarSteps = 12;
constexpr double kCollarSlant = 8, kCollarResidual = 1e-4, kCollarRounding = 1e-14;

/// Vertices on the level next to those of boundary loops.
template <class Scalar>
class Collars {
 public:
  Collars(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level)
      : tet_(tet), level_(level), geometry_(tet.points, tet.simplex.exponents) {
    using std::ldexp;
    const auto& exponents = tet.simplex.exponents;
    const int least = *std::min_element(exponents.begin(), exponents.end());
    for (std::size_t i = 0; i < 4; ++i) scales_[i] = ldexp(Scalar(1), least - exponents[i]);
  }

  std::optional<InnerVertex<Scalar>> next_to(const BoundaryVertex& v, double height) const {
    for (int k = 0; k < kCollarHalvings; ++k, height /= 2)
      if (auto vertex = at_height(v, height)) return vertex;
    return std::nullopt;
  }

  Vector3<double> position(const InnerVertex<Scalar>& v) const {
    return position_at(v.weights, tet_.simplex.exponents, tet_.points);
  }

  /// Barycentric coordinates, which are those of the tensors given rather than of the scaled ones.
  std::array<double, 4> coordinates(const BoundaryVertex& v) const {
    std::array<double, 4> x;
    for (std::size_t i = 0; i < 4; ++i)
      x[i] = v.faces >> i & 1 ? 0 : geometry_.weight(i, v.position);
    return x;
  }

 private:
  /// On the level and so far from the faces on which the vertex is; the other coordinates follow.
  std::optional<InnerVertex<Scalar>> at_height(const BoundaryVertex& v, double height) const {
    const auto start = coordinates(v);
    std::array<double, 4> free{};  // moves between these keep the height
    double raised = 0, others = 0;
    for (std::size_t i = 0; i < 4; ++i) (v.faces >> i & 1 ? raised : others) += 1;
    std::array<Scalar, 4> x;
    for (std::size_t i = 0; i < 4; ++i) {
      free[i] = v.faces >> i & 1 ? 0 : 1;
      x[i] = Scalar(start[i] + (free[i] > 0 ? -height * raised / others : height));
    }
    for (int step = 0; step < kCollarSteps; ++step) {
      const auto vertex = vertex_at(x);
      const auto at = level_slope(vertex.tensor, level_);
      std::array<Scalar, 4> gradient;
      Scalar mean(0), square(0);
      for (std::size_t i = 0; i < 4; ++i) {
        gradient[i] =
            free[i] > 0 ? scales_[i] * inner(at.slope, thrice(tet_.simplex.tensors[i])) : Scalar(0);
        mean = mean + gradient[i] / Scalar(others);
      }
      for (std::size_t i = 0; i < 4; ++i) {
        gradient[i] = free[i] > 0 ? gradient[i] - mean : Scalar(0);
        square = square + gradient[i] * gradient[i];
      }
      if (!(square > Scalar(0))) return std::nullopt;
      for (std::size_t i = 0; i < 4; ++i) {
        const Scalar by = at.value / square * gradient[i];
        x[i] = x[i] - by;
        if (!(x[i] > Scalar(0))) return std::nullopt;
        if (!(std::abs(static_cast<double>(x[i]) - start[i]) < kCollarSlant * height))
          return std::nullopt;
      }
    }
    const auto vertex = vertex_at(x);
    const auto norm = static_cast<double>(norm_form(vertex.tensor));
    const auto value = static_cast<double>(level_slope(vertex.tensor, level_).value);
    const auto gap = static_cast<double>(Scalar(1) - level_.mu_squared);
    const bool is_found =
        std::abs(value) < (kCollarResidual * gap + kCollarRounding) * norm * std::sqrt(norm);
    return is_found ? std::optional(vertex) : std::nullopt;
  }

  InnerVertex<Scalar> vertex_at(const std::array<Scalar, 4>& x) const {
    InnerVertex<Scalar> vertex;
    for (std::size_t i = 0; i < 4; ++i) vertex.weights[i] = scales_[i] * x[i];
    vertex.tensor = tensor_at(tet_.simplex.tensors, vertex.weights);
    return vertex;
  }

  const TetWithCurves<Scalar>& tet_;
  const Level<Scalar>& level_;
  TetGeometry geometry_;
  std::array<Scalar, 4> scales_;  ///< weights of the scaled tensors over coordinates
};

double largest_difference(const std::array<double, 4>& u, const std::array<double, 4>& v) {
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, std::abs(u[i] - v[i]));
  return largest;
}

/// The strip between a boundary loop and its collar, which takes the boundary loop's place.
template <class Scalar>
bool add_collar(const Collars<Scalar>& collars, Loop& boundary, Patch<Scalar>& out) {
  const std::size_t n = boundary.size();
  Loop inner(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto here = collars.coordinates(boundary[i]);
    const double height =
        std::min(largest_difference(here, collars.coordinates(boundary[(i + 1) % n])),
                 largest_difference(here, collars.coordinates(boundary[(i + n - 1) % n]))) /
        2;
    const auto vertex = collars.next_to(boundary[i], height);
    if (!vertex) return false;
    out.inner.push_back(*vertex);
    inner[i] = boundary[i];
    inner[i].id = -static_cast<std::int32_t>(out.inner.size());
    inner[i].faces = 0;
    inner[i].position = collars.position(*vertex);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = boundary[i], &b = boundary[(i + 1) % n], &c = inner[i], &d = inner[(i + 1) % n];
    if (length(d.position - a.position) < length(b.position - c.position)) {
      out.triangles.push_back({a.id, b.id, d.id});
      out.triangles.push_back({a.id, d.id, c.id});
    } else {
      out.triangles.push_back({a.id, b.id, c.id});
      out.triangles.push_back({b.id, d.id, c.id});
    }
  }
  boundary = std::move(inner);
  return true;
}

}  // namespace

template <class Scalar>
bool fill_loops(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                const FaceArcVertices& vertices, Patch<Scalar>& out) {
  const auto boundaries = loops_of(proved, sheet, vertices);
  return !boundaries.empty() && mesh_between(boundaries, out);
}

template <class Scalar>
bool fill_with_collars(const TetWithCurves<Scalar>& tet, const CellTopology<Scalar>& proved,
                       const SheetTopology& sheet, const FaceArcVertices& vertices,
                       const Level<Scalar>& level, Patch<Scalar>& out) {
  auto boundaries = loops_of(proved, sheet, vertices);
  if (boundaries.empty()) return false;
  const Collars<Scalar> collars(tet, level);
  Patch<Scalar> patch = out;
  for (auto& boundary : boundaries)
    if (!add_collar(collars, boundary, patch)) return false;
  if (!mesh_between(boundaries, patch)) return false;
  out = std::move(patch);
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                       \
  template bool fill_loops(const CellTopology<Scalar>&, const SheetTopology&,                \
                           const FaceArcVertices&, Patch<Scalar>&);                          \
  template bool fill_with_collars(const TetWithCurves<Scalar>&, const CellTopology<Scalar>&, \
                                  const SheetTopology&, const FaceArcVertices&,              \
                                  const Level<Scalar>&, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
