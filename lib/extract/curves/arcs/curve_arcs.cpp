// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/curve_arcs.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "extract/curves/arcs/arc_places.hpp"
#include "extract/curves/arcs/isolated_zeros.hpp"
#include "extract/curves/arcs/line_ends.hpp"
#include "extract/curves/arcs/separation_polynomial.hpp"
#include "extract/curves/points/cell_rows.hpp"
#include "extract/curves/points/exact_face_points.hpp"
#include "extract/run/assert.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {
namespace {

/// Halvings in which intervals of doubles tell zeros apart, before 150 digits are asked.
constexpr int kDepthInDoubles = 20;

/// Boxes of doubles that are wider, for the size of the tetrahedron, are left to 150 digits.
constexpr double kNarrow = 0x1p-26;

template <class E>
bool is_too_wide(const PlaceBox& box, const LineEnds& ends) {
  double size = 0;
  for (const auto& p : ends.points) size = std::max(size, max_norm(p - ends.points[0]));
  return std::is_same_v<E, FastInterval> && !(max_norm(box.high - box.low) <= kNarrow * size);
}

/// The forms of a line's tetrahedron.
class CellForms {
 public:
  explicit CellForms(const LineEnds& ends) : rows_(ends.scaled), scaled_(&ends.scaled) {
    choose_columns();
  }
  /// See `CellRows::reduce`.
  bool reduce() {
    const bool is_reduced = rows_.reduce();
    if (is_reduced) choose_columns();
    return is_reduced;
  }
  FieldForms<FastInterval, 4> in(const FastInterval&) const {
    return rows_.forms<FastInterval>(columns_);
  }
  FieldForms<MultiprecisionInterval, 4> in(const MultiprecisionInterval&) const {
    return field_forms(coordinate_rows<MultiprecisionInterval>(*scaled_), columns_);
  }

 private:
  void choose_columns() { columns_ = best_columns(rows_.rows<Extended>()); }

  CellRows<4> rows_;
  const std::array<ScaledTensor, 4>* scaled_;
  std::array<std::size_t, 5> columns_{};
};

/// An arc with its directions and weights, for all numbers of enclosures.
template <class E>
struct EnclosedConic {
  ConicArc<E> directions;
  ArcWeights<E> weights;
};

Vector3<FastInterval> direction_of(const LineEnds&, const BoundaryPoint& point, FastInterval) {
  return directions_in<FastInterval>(point.point.box);
}

Vector3<MultiprecisionInterval> direction_of(const LineEnds& ends, const BoundaryPoint& point,
                                             const MultiprecisionInterval&) {
  const auto& c = point.corners;
  const MultiprecisionFace face({ends.scaled[c[0]], ends.scaled[c[1]], ends.scaled[c[2]]});
  return refined(face, point.point.box);
}

/// The one of a conic's two arcs on which the curve enters at its first point; nothing if a sign is
/// not certain.
template <class E>
std::optional<EnclosedConic<E>> conic_of(const LineEnds& ends, const CellForms& cell) {
  int largest = ends.scaled[0].exponent, smallest = largest;
  for (const ScaledTensor& t : ends.scaled) {
    largest = std::max(largest, t.exponent);
    smallest = std::min(smallest, t.exponent);
  }
  if (std::is_same_v<E, FastInterval> && largest - smallest >= kLargestRatio) return std::nullopt;
  const auto forms = cell.in(E(0.0));
  auto directions = conic_arc(forms.across[0], direction_of(ends, ends.begin, E(0.0)),
                              direction_of(ends, ends.end, E(0.0)));
  if (!directions) return std::nullopt;

  ArcWeights<E> weights;
  const auto find_weights = [&] {
    for (std::size_t i = 0; i < 4; ++i) {
      weights[i] = form_along(forms.weight[i], *directions);
      for (E& w : weights[i]) w = times_power(w, ends.scaled[i].exponent - largest);
    }
  };
  find_weights();
  // At the first point three weights have one sign. The fourth one grows from zero to that sign
  // along the arc, or the other arc is the one.
  const auto front_sum = [&] {
    return sign_in((weights[0][0] + weights[1][0]) + (weights[2][0] + weights[3][0]));
  };
  const Verdict sign = front_sum();
  const Verdict entering = sign_in(weights[ends.begin.face][1]);
  if (!is_strict(sign) || !is_strict(entering)) return std::nullopt;
  if (sign != entering) {
    (*directions)[1] = -(*directions)[1];
    find_weights();
  }
  if (sign == Verdict::negative)
    for (auto& polynomial : weights)
      for (E& w : polynomial) w = -w;
  return EnclosedConic<E>{*directions, weights};
}

template <class E>
std::optional<LineSeparation> separation_in(const LineEnds& ends, const CellForms& cell) {
  constexpr int depth = std::is_same_v<E, FastInterval> ? kDepthInDoubles : kZeroDepth;
  const auto conic = conic_of<E>(ends, cell);
  if (!conic) return std::nullopt;
  const auto gradient = space_gradient<E>(ends.points, ends.tensors);
  const ZeroIsolation<E, 9> isolation(separation_along(gradient, conic->directions), depth);
  const IsolatedZeros& found = isolation.zeros();
  LineSeparation result{found.begin, found.end, {}, {}, {}};
  const auto& w = conic->weights;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t k = 4 * i;
    const auto place = place_of<E>({w[0][k], w[1][k], w[2][k], w[3][k]}, ends.points);
    if (!place || is_too_wide<E>(*place, ends)) return std::nullopt;
    result.ends[i] = *place;
  }
  if (!found.open.empty() || found.begin == 0 || found.end == 0)
    result.obstacle = ArcObstacle::not_told_apart;
  else
    TENSORTOPO_ASSERT(found.begin * found.end == (found.simple.size() % 2 == 0 ? 1 : -1),
                      "each simple zero changes the sign");
  for (const DyadicInterval& part : found.simple) {
    const auto hull = hull_of(conic->weights, part, ends.points);
    if (!hull || is_too_wide<E>(box_around(*hull), ends)) return std::nullopt;
    result.zeros.push_back(box_around(*hull));
  }
  return result;
}

template <class E>
std::optional<EnclosedArc> arc_in(const LineEnds& ends, const CellForms& cell, int depth) {
  const auto conic = conic_of<E>(ends, cell);
  if (!conic) return std::nullopt;
  EnclosedArc result;
  for (std::uint64_t i = 0; i < std::uint64_t{1} << depth; ++i) {
    const auto hull = hull_of(conic->weights, {i, depth}, ends.points);
    if (!hull || is_too_wide<E>(hull->front(), ends) || is_too_wide<E>(hull->back(), ends))
      return std::nullopt;
    if (i == 0) result.points.push_back(hull->front());
    result.points.push_back(hull->back());
    result.hulls.push_back(*hull);
  }
  return result;
}

/// What `in_doubles` finds, by rows as they are and then reduced, or else `in_digits`.
/// @param is_done  whether what doubles found is good enough
template <class InDoubles, class IsDone, class InDigits>
auto found_in_tiers(const LineEnds& ends, const InDoubles& in_doubles, const IsDone& is_done,
                    const InDigits& in_digits) {
  CellForms cell(ends);
  for (const bool is_reduced : {false, true}) {
    if (is_reduced && !cell.reduce()) break;
    const FastIntervalScope scope;
    auto found = in_doubles(cell);
    if (found && is_done(*found)) return found;
  }
  return in_digits(cell);
}

void require_line(const CurveMesh& curves, std::size_t line) {
  if (line >= curves.lines.size())
    throw std::invalid_argument("curves: there is no line " + std::to_string(line) + ", but " +
                                std::to_string(curves.lines.size()) + " lines");
}

}  // namespace

struct CurveArcs::Source {
  LineFinder finder;
};

CurveArcs::CurveArcs(const TetMesh& mesh, Degeneracy kind, const CurveMesh& curves)
    : curves_(&curves), source_(new Source{LineFinder(mesh, kind)}) {}

CurveArcs::~CurveArcs() = default;

LineSeparation CurveArcs::separation(std::size_t line) const {
  require_line(*curves_, line);
  const FloatingPointEnvironment environment;
  const auto ends = source_->finder.find(*curves_, line);
  if (!ends) return {0, 0, {}, {}, ArcObstacle::special_position};
  auto result = found_in_tiers(
      *ends, [&](const CellForms& cell) { return separation_in<FastInterval>(*ends, cell); },
      [](const LineSeparation& found) { return !found.obstacle; },
      [&](const CellForms& cell) { return separation_in<MultiprecisionInterval>(*ends, cell); });
  if (!result) return {0, 0, {}, {}, ArcObstacle::not_told_apart};
  if (ends->is_reversed) {
    std::swap(result->begin, result->end);
    std::swap(result->ends[0], result->ends[1]);
    std::reverse(result->zeros.begin(), result->zeros.end());
  }
  return *result;
}

std::optional<EnclosedArc> CurveArcs::enclosed(std::size_t line, int depth) const {
  require_line(*curves_, line);
  if (depth < 0 || depth > kDeepest)
    throw std::invalid_argument("depth: an integer from 0 to " + std::to_string(kDeepest) +
                                " belongs here, not " + std::to_string(depth));
  const FloatingPointEnvironment environment;
  const auto ends = source_->finder.find(*curves_, line);
  if (!ends) return std::nullopt;
  auto result = found_in_tiers(
      *ends, [&](const CellForms& cell) { return arc_in<FastInterval>(*ends, cell, depth); },
      [](const EnclosedArc&) { return true; },
      [&](const CellForms& cell) { return arc_in<MultiprecisionInterval>(*ends, cell, depth); });
  if (result && ends->is_reversed) {
    std::reverse(result->points.begin(), result->points.end());
    std::reverse(result->hulls.begin(), result->hulls.end());
    for (auto& hull : result->hulls) std::reverse(hull.begin(), hull.end());
  }
  return result;
}

CurveSeparation curve_separation(const CurveArcs& arcs, const ExtractOptions& options) {
  const CurveMesh& curves = arcs.curves();
  CurveSeparation result;
  result.lines.resize(curves.lines.size());
  parallel_stage(options, "separation", curves.lines.size(), 32,
                 [&](std::size_t line) { result.lines[line] = arcs.separation(line); });
  struct Ends {
    std::array<std::size_t, 2> lines{};
    std::array<int, 2> signs{};
    PlaceBox place{};
    std::size_t count = 0;
  };
  std::vector<Ends> at(curves.points.size());
  const auto add = [&](CurveMesh::Index v, std::size_t line, int sign, const PlaceBox& place) {
    Ends& ends = at[as_size(v)];
    if (ends.count == 0) ends.place = place;
    if (ends.count < 2) ends.lines[ends.count] = line, ends.signs[ends.count] = sign;
    ++ends.count;
  };
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    add(curves.lines[i].front(), i, result.lines[i].begin, result.lines[i].ends[0]);
    add(curves.lines[i].back(), i, result.lines[i].end, result.lines[i].ends[1]);
  }
  for (std::size_t v = 0; v < at.size(); ++v)
    if (at[v].count == 2 && at[v].signs[0] * at[v].signs[1] < 0)
      result.jumps.push_back({static_cast<CurveMesh::Index>(v), at[v].lines, at[v].place});
  return result;
}

}  // namespace tensortopo
