// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/special_cell.hpp"

#include <algorithm>
#include <bit>

#include "extract/curves/points/certified_zero.hpp"
#include "extract/curves/special/pencil_points.hpp"
#include "extract/curves/special/plane_directions.hpp"
#include "extract/curves/special/special_full_cell.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

namespace {

template <std::size_t Vertices>
using Row = std::array<Rational, Vertices>;

/// Which tensors are independent, and how the others depend on them.
template <std::size_t Vertices>
struct Relations {
  std::vector<std::size_t> independent;
  std::vector<Row<Vertices>> kernel;  ///< a basis of the weights that make zero
};

template <std::size_t Vertices>
Relations<Vertices> relations_of(const std::array<Covector<Rational>, Vertices>& rows) {
  struct Reduced {
    Covector<Rational> row;
    Row<Vertices> made_of;
    std::size_t pivot = 0;
  };
  std::vector<Reduced> basis;
  Relations<Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i) {
    Reduced next{rows[i], {}};
    next.made_of[i] = 1;
    for (const Reduced& former : basis) {
      const Rational factor = next.row[former.pivot] / former.row[former.pivot];
      if (factor == 0) continue;
      for (std::size_t k = 0; k < 5; ++k) next.row[k] = next.row[k] - factor * former.row[k];
      for (std::size_t k = 0; k < Vertices; ++k)
        next.made_of[k] = next.made_of[k] - factor * former.made_of[k];
    }
    while (next.pivot < 5 && next.row[next.pivot] == 0) ++next.pivot;
    if (next.pivot == 5) {
      result.kernel.push_back(next.made_of);
    } else {
      result.independent.push_back(i);
      basis.push_back(std::move(next));
    }
  }
  return result;
}

/// The isotropic point, if it is in the interior.
template <std::size_t Vertices>
std::optional<SpecialPoint> zero_point(const Row<Vertices>& kernel) {
  int positive = 0, negative = 0;
  for (const Rational& k : kernel) {
    positive += k > 0;
    negative += k < 0;
  }
  constexpr int count = static_cast<int>(Vertices);
  if (positive != count && negative != count) return std::nullopt;
  Rational sum = 0;
  for (const Rational& k : kernel) sum = sum + k;
  SpecialPoint point;
  point.support = kAllVertices<Vertices>;
  for (std::size_t i = 0; i < Vertices; ++i)
    point.weights[i] = to_extended(Rational(kernel[i] / sum));
  return point;
}

template <std::size_t Vertices>
std::array<Deviator<Rational>, Vertices> exact_tensors(
    const std::array<ScaledTensor, Vertices>& tensors) {
  std::array<Deviator<Rational>, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i) result[i] = exact_deviator<Rational>(tensors[i]);
  return result;
}

/// The directions that all degenerate tensors of a cell have; nothing if not separated.
template <std::size_t Vertices>
std::optional<PlaneDirections> all_directions(const std::array<ScaledTensor, Vertices>& tensors,
                                              const std::vector<std::size_t>& independent) {
  PlaneDirections result;
  result.settled = true;
  const auto tensor = [&](std::size_t i) {
    return exact_deviator<Rational>(tensors[independent[i]]);
  };
  if (independent.size() == 1) {
    if (const auto kind = kind_of(tensor(0)); kind.degenerate)
      result.points.push_back(kind.direction);
  } else if (independent.size() == 2) {
    auto points = pencil_directions(tensor(0), tensor(1));
    if (!points) return std::nullopt;
    result.points = std::move(*points);
  } else {
    result = plane_directions(
        {tensors[independent[0]], tensors[independent[1]], tensors[independent[2]]});
  }
  if (!result.settled) return std::nullopt;
  return result;
}

/// A cell in which the tensor is constant along one direction, or along rays from a zero: the curve
/// consists of straight lines, one for each direction of the dominant eigenvector.
template <std::size_t Vertices>
SpecialCell straight_lines(const std::array<ScaledTensor, Vertices>& tensors,
                           const Relations<Vertices>& relations,
                           std::span<const SpecialPoint> boundary) {
  SpecialCell cell;
  // Also for the cells around this one.
  const auto own_zero = zero_point<Vertices>(relations.kernel[0]);
  if (own_zero) cell.points.push_back(*own_zero);
  if (std::none_of(boundary.begin(), boundary.end(),
                   [](const auto& p) { return p.direction.has_value(); }))
    return cell;
  const auto directions = all_directions(tensors, relations.independent);
  if (!directions) {
    cell.obstacle = CurveObstacle::points_not_told_apart;
    return cell;
  }
  cell.axis = directions->axis;
  struct Stop {
    std::size_t index;
    unsigned support;
  };
  std::vector<std::vector<Stop>> stops(directions->points.size());
  std::optional<Stop> zero;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Stop stop{i, boundary[i].support};
    if (!boundary[i].direction) {
      zero = stop;
    } else if (const auto k = position_in(directions->points, *boundary[i].direction)) {
      stops[*k].push_back(stop);
    } else if (!directions->axis) {
      cell.obstacle = CurveObstacle::points_not_told_apart;
      return cell;
    }
  }
  if (own_zero) zero = Stop{boundary.size(), own_zero->support};
  for (auto& ends : stops) {
    if (ends.empty()) continue;
    if (zero) ends.push_back(*zero);
    // Two points in one face of the cell are joined there, if at all.
    if (ends.size() != 2 || (ends[0].support | ends[1].support) != kAllVertices<Vertices>) continue;
    cell.pieces.push_back({{ends[0].index, ends[1].index}, {}, false});
  }
  return cell;
}

/// Whether tensors that two independent ones span have one of the kind sought in the interior of
/// their cone.
bool is_in_open_cone(const std::array<ScaledTensor, 4>& tensors,
                     std::span<const SpecialPoint> boundary) {
  const auto rows = coordinate_rows<Rational>(tensors);
  for (const SpecialPoint& point : boundary) {
    if (!point.direction) continue;
    if (std::popcount(point.support) != 1) return true;
    // At a vertex: then there are others on both sides.
    const auto v = static_cast<std::size_t>(std::countr_zero(point.support));
    for (std::size_t c = 0; c < 5; ++c)
      for (std::size_t d = 0; d < c; ++d) {
        bool left = false, right = false;
        for (const auto& row : rows) {
          const Rational turn = rows[v][c] * row[d] - rows[v][d] * row[c];
          left = left || turn > 0;
          right = right || turn < 0;
        }
        if (left && right) return true;
      }
  }
  return false;
}

/// A cell in which the curve's place is taken by surfaces or more.
template <std::size_t Vertices>
std::optional<CurveObstacle> more_than_curves(const std::array<ScaledTensor, Vertices>& tensors,
                                              std::size_t rank,
                                              std::span<const SpecialPoint> boundary,
                                              std::span<const SpecialCell* const> faces) {
  if (Vertices < 3) return std::nullopt;
  if (rank == 0 && Vertices == 4) return CurveObstacle::no_deviator_in_cell;
  if (rank == 1)
    for (const SpecialPoint& point : boundary)
      if (point.direction) return CurveObstacle::degenerate_throughout;
  if constexpr (Vertices == 4) {
    if (rank == 2 && is_in_open_cone(tensors, boundary))
      return CurveObstacle::degenerate_on_a_surface;
    for (const SpecialCell* face : faces)
      if (face && face->obstacle == CurveObstacle::degenerate_throughout)
        return CurveObstacle::degenerate_on_a_surface;
  }
  return std::nullopt;
}

SpecialCell curve_in_full_edge(const std::array<ScaledTensor, 2>& tensors, bool linear) {
  SpecialCell cell;
  const auto t = exact_tensors(tensors);
  auto points = degenerate_points_between(t[0], t[1]);
  if (!points) {
    cell.obstacle = CurveObstacle::points_not_told_apart;
    return cell;
  }
  for (auto& found : *points) {
    if (found.linear != linear) continue;
    SpecialPoint point;
    point.support = kAllVertices<2>;
    point.weights = {found.weights[0], found.weights[1], 0, 0};
    point.dominant = rounded_direction(found.direction);
    point.direction = std::move(found.direction);
    cell.points.push_back(std::move(point));
  }
  return cell;
}

}  // namespace

template <std::size_t Vertices>
SpecialCell special_cell(const std::array<ScaledTensor, Vertices>& tensors, bool linear,
                         std::span<const SpecialPoint> boundary, double largest_turn,
                         std::span<const SpecialCell* const> faces,
                         std::span<const ExactDirection> crossings) {
  const auto relations = relations_of(coordinate_rows<Rational>(tensors));
  const std::size_t rank = relations.independent.size();
  if (rank == Vertices) {
    if constexpr (Vertices == 2) return curve_in_full_edge(tensors, linear);
    if constexpr (Vertices == 3)
      return curve_in_full_face(tensors, linear, boundary, largest_turn, crossings);
    if constexpr (Vertices == 4)
      return curve_in_full_tet(tensors, linear, boundary, largest_turn, faces);
  }
  if (rank + 1 < Vertices) {
    SpecialCell cell;
    cell.obstacle = more_than_curves(tensors, rank, boundary, faces);
    return cell;
  }
  SpecialCell cell = straight_lines(tensors, relations, boundary);
  // With a common eigenvector the directions across it fill a cone, which every face with
  // independent tensors meets in a curve.
  if (!cell.obstacle && cell.axis)
    for (const SpecialCell* face : faces)
      if (face && std::any_of(face->pieces.begin(), face->pieces.end(),
                              [](const SpecialPiece& piece) { return piece.across_axis; }))
        cell.obstacle = CurveObstacle::degenerate_on_a_surface;
  return cell;
}

template SpecialCell special_cell<2>(const std::array<ScaledTensor, 2>&, bool,
                                     std::span<const SpecialPoint>, double,
                                     std::span<const SpecialCell* const>,
                                     std::span<const ExactDirection>);
template SpecialCell special_cell<3>(const std::array<ScaledTensor, 3>&, bool,
                                     std::span<const SpecialPoint>, double,
                                     std::span<const SpecialCell* const>,
                                     std::span<const ExactDirection>);
template SpecialCell special_cell<4>(const std::array<ScaledTensor, 4>&, bool,
                                     std::span<const SpecialPoint>, double,
                                     std::span<const SpecialCell* const>,
                                     std::span<const ExactDirection>);

}  // namespace tensortopo
