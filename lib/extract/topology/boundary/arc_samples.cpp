// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/arc_samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/segment_root.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/degenerate_offset.hpp"

namespace tensortopo {

namespace {

template <class Scalar>
CurvePoint<Scalar> point_on_piece(const ArcPiece<Scalar>& piece,
                                  const std::array<Deviator<Scalar>, 3>& face,
                                  const Scalar& fraction, const Level<Scalar>& level) {
  const auto& corners = piece.corners();
  const auto& tensors = piece.tensors(face);
  std::array<Scalar, 3> base;
  for (std::size_t i = 0; i < 3; ++i)
    base[i] = piece.begin[i] + fraction * (piece.end[i] - piece.begin[i]);
  if (fraction > Scalar(0) && fraction < Scalar(1)) {
    // Both ends of the line through the triangle.
    Scalar down(0), up(0);
    bool first = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if (piece.direction[i] == Scalar(0)) continue;
      const Scalar k = -base[i] / piece.direction[i];
      if (piece.direction[i] > Scalar(0)) {
        if (first || k > down) down = k;
        first = false;
      }
    }
    first = true;
    for (std::size_t i = 0; i < 3; ++i)
      if (piece.direction[i] < Scalar(0)) {
        const Scalar k = -base[i] / piece.direction[i];
        if (first || k < up) up = k;
        first = false;
      }
    // Of sum one, so that neither end outweighs the other: the root is as exact as its parameter.
    const auto at = [&](const Scalar& k) {
      std::array<Scalar, 3> w;
      Scalar total(0);
      for (std::size_t i = 0; i < 3; ++i) {
        w[i] = base[i] + k * piece.direction[i];
        total = total + w[i];
      }
      for (auto& x : w) x = x / total;
      return w;
    };
    const auto lower = at(down), upper = at(up);
    const Scalar root = segment_root(tensor_at(tensors, lower), tensor_at(tensors, upper), level);
    for (std::size_t i = 0; i < 3; ++i) base[i] = lower[i] + root * (upper[i] - lower[i]);
    for (auto& w : base)
      if (w < Scalar(0)) w = Scalar(0);
  }
  CurvePoint<Scalar> point;
  point.tensor = tensor_at(tensors, base);
  Scalar total(0);
  for (std::size_t i = 0; i < 3; ++i) {
    point.weights[i] = Scalar(0);
    for (std::size_t c = 0; c < 3; ++c)
      point.weights[i] = point.weights[i] + base[c] * Scalar(corners[c][i]);
    total = total + point.weights[i];
  }
  for (auto& w : point.weights) w = w / total;
  point.medium = medium_eigenvector(point.tensor, level);
  return point;
}

/// How a polygon turns around, by its area with sign: positive counter-clockwise.
template <class Scalar>
int turn_of(const std::vector<CurvePoint<Scalar>>& polygon, const std::vector<char>& keep) {
  Scalar area(0);
  const auto& origin = polygon[0].weights;
  std::array<Scalar, 2> last{};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!keep[i]) continue;
    const auto& w = polygon[i].weights;
    const std::array<Scalar, 2> next{w[1] - origin[1], w[2] - origin[2]};
    area = area + last[0] * next[1] - last[1] * next[0];
    last = next;
  }
  return area > Scalar(0) ? 1 : area < Scalar(0) ? -1 : 0;
}

template <class Scalar>
class Sampler {
 public:
  Sampler(const std::array<Deviator<Scalar>, 3>& face, const Level<Scalar>& level,
          const SampleTurns& turns)
      : face_(face),
        level_(level),
        turn_(turns.medium),
        wide_turn_(turns.tensor),
        is_near_degenerate_(is_near_degenerate(level)) {}

  void sample(FaceArc<Scalar>& arc) {
    if (needs_none(arc)) return;
    std::vector<CurvePoint<Scalar>> points;
    points.reserve(2 * arc.pieces.size() + 1);
    for (std::size_t p = 0; p < arc.pieces.size(); ++p) {
      const auto& piece = arc.pieces[p];
      auto a = at(piece, p, Scalar(0)), b = at(piece, p, Scalar(1));
      points.push_back(a);
      between(piece, p, a, b, 0, points);
      if (p + 1 == arc.pieces.size()) points.push_back(b);
    }
    if (arc.closed) points.pop_back();  // the last point is the first
    given(arc, points);
  }

 private:
  CurvePoint<Scalar> at(const ArcPiece<Scalar>& piece, std::size_t index, const Scalar& fraction) {
    auto point = point_on_piece(piece, face_, fraction, level_);
    point.place = Scalar(static_cast<double>(index)) + fraction;
    return point;
  }

  /// Of most arcs, in one triangle from one edge to another: `between` would give none, and the
  /// ends stay.
  bool needs_none(const FaceArc<Scalar>& arc) {
    if (arc.closed || arc.pieces.size() != 1 || arc.begin.edge == arc.end.edge) return false;
    const auto& piece = arc.pieces[0];
    const auto a = at(piece, 0, Scalar(0)), b = at(piece, 0, Scalar(1));
    if (!is_close(a, b)) return false;
    const auto m = at(piece, 0, Scalar(1) / Scalar(2));
    return is_close(a, m) && is_close(m, b);
  }

  bool is_close(const CurvePoint<Scalar>& a, const CurvePoint<Scalar>& b) const {
    if (!(line_cosine(a.medium, b.medium) > turn_)) return false;
    const Scalar product = norm_form(a.tensor, b.tensor);
    return product > Scalar(0) &&
           product * product >
               wide_turn_ * wide_turn_ * norm_form(a.tensor) * norm_form(b.tensor) &&
           (!is_near_degenerate_ || !sags(a, b));
  }

  /// Whether the chord leaves the level by too much; not if it would take too many samples to mend
  /// that.
  bool sags(const CurvePoint<Scalar>& a, const CurvePoint<Scalar>& b) const {
    const auto ends = rounded(std::array{a.tensor, b.tensor});
    return detail::sag_halvings(detail::sag_of_chord(ends[0], ends[1], level_.sign)) > 0;
  }

  void between(const ArcPiece<Scalar>& piece, std::size_t index, const CurvePoint<Scalar>& a,
               const CurvePoint<Scalar>& b, int depth, std::vector<CurvePoint<Scalar>>& points) {
    if (depth > 12 || (depth > 0 && is_close(a, b))) return;
    const Scalar middle = (a.place + b.place) / Scalar(2) - Scalar(static_cast<double>(index));
    const auto m = at(piece, index, middle);
    // A piece may leave for far away between ends that are close.
    if (depth == 0 && is_close(a, b) && is_close(a, m) && is_close(m, b)) return;
    between(piece, index, a, m, depth + 1, points);
    points.push_back(m);
    between(piece, index, m, b, depth + 1, points);
  }

  /// Drops samples (mostly ends of pieces) that are closer than they need be.
  void given(FaceArc<Scalar>& arc, const std::vector<CurvePoint<Scalar>>& points) {
    const std::size_t n = points.size();
    std::vector<char> keep(n, 1);
    std::size_t kept = n, last = 0;
    const std::size_t least = arc.closed ? 3 : arc.begin.edge == arc.end.edge ? 3 : 2;
    for (std::size_t i = 1; i < n && kept > least; ++i) {
      if (i + 1 == n && !arc.closed) break;
      if (is_close(points[last], points[(i + 1) % n]))
        keep[i] = 0, --kept;
      else
        last = i;
    }
    // The polygon of all points turns as the loop does: it goes through the same triangles. Few
    // points of a thin loop that bends may turn the other way.
    if (const std::vector<char> all(n, 1);
        arc.closed && turn_of(points, keep) != turn_of(points, all))
      keep = all;
    if (!arc.closed && kept == 2 && least == 3) {  // one piece, both ends on one edge
      arc.samples.push_back(at(arc.pieces[0], 0, Scalar(1) / Scalar(2)));
      return;
    }
    for (std::size_t i = 0; i < n; ++i)
      if (keep[i] && (arc.closed || (i > 0 && i + 1 < n))) arc.samples.push_back(points[i]);
    // A loop is never one piece, since a monotone triangle holds none, but it may be two.
    for (std::size_t p = 0; arc.closed && arc.samples.size() < 3 && p < arc.pieces.size(); ++p) {
      arc.samples.push_back(at(arc.pieces[p], p, Scalar(1) / Scalar(2)));
      std::sort(arc.samples.begin(), arc.samples.end(),
                [](const auto& a, const auto& b) { return a.place < b.place; });
    }
  }

  const std::array<Deviator<Scalar>, 3>& face_;
  const Level<Scalar>& level_;
  Scalar turn_, wide_turn_;  ///< cosines: of the medium eigenvector, of the whole tensor
  bool is_near_degenerate_;
};

}  // namespace

template <class Scalar>
void sample_arc(FaceArc<Scalar>& arc, const std::array<Deviator<Scalar>, 3>& face,
                const Level<Scalar>& level, const SampleTurns& turns) {
  Sampler<Scalar>(face, level, turns).sample(arc);
}

template <class Scalar>
CurvePoint<Scalar> point_on_arc(const FaceArc<Scalar>& arc,
                                const std::array<Deviator<Scalar>, 3>& face, const Scalar& place,
                                const Level<Scalar>& level) {
  auto index = static_cast<std::size_t>(static_cast<double>(place));
  if (index >= arc.pieces.size()) index = arc.pieces.size() - 1;
  auto point = point_on_piece(arc.pieces[index], face, place - Scalar(static_cast<double>(index)),
                              arc.level != nullptr ? *arc.level : level);
  point.place = place;
  return point;
}

namespace {

template <class Scalar>
Scalar determinant(const std::array<std::array<Scalar, 3>, 3>& rows) {
  const auto& [x, y, z] = rows;
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
         x[2] * (y[0] * z[1] - y[1] * z[0]);
}

/// Barycentric coordinates of a place in a triangle by Cramer's rule, from its weights in the face
/// and those of the corners, or from the scalar products of its tensor with theirs. Where the field
/// nearly vanishes triangles are too small for weights to tell places in them apart, but the
/// tensors do; where these nearly depend on each other it is the other way round.
template <class Scalar>
std::array<Scalar, 3> coordinates_in(const ArcPiece<Scalar>& piece,
                                     const std::array<Deviator<Scalar>, 3>& face,
                                     const std::array<Scalar, 3>& weights,
                                     const Deviator<Scalar>& tensor) {
  using Rows = std::array<std::array<Scalar, 3>, 3>;
  const auto& corners = piece.corners();
  const auto& tensors = piece.tensors(face);
  Rows rows, products;
  std::array<Scalar, 3> right = weights;
  Scalar size(1), norms(1);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      rows[i][k] = Scalar(corners[i][k]);
      products[i][k] = norm_form(tensors[i], tensors[k]);
    }
    size = size * (rows[i][0] + rows[i][1] + rows[i][2]);
    norms = norms * products[i][i];
  }
  const Scalar area = determinant(rows);
  if (determinant(products) * size > (area < Scalar(0) ? Scalar(-area) : area) * norms) {
    rows = products;
    for (std::size_t k = 0; k < 3; ++k) right[k] = norm_form(tensor, tensors[k]);
  }
  std::array<Scalar, 3> local;
  for (std::size_t i = 0; i < 3; ++i) {
    Rows changed = rows;
    changed[i] = right;
    local[i] = determinant(changed);
  }
  const Scalar whole = local[0] + local[1] + local[2];
  for (auto& l : local) l = l / whole;
  return local;
}

}  // namespace

template <class Scalar>
std::pair<int, Scalar> locate_on_arcs(std::span<const FaceArc<Scalar>> arcs,
                                      const std::array<Deviator<Scalar>, 3>& face,
                                      const std::array<Scalar, 3>& weights,
                                      const Deviator<Scalar>& tensor) {
  int best_arc = -1;
  Scalar best_place(0), best_margin(0);
  for (std::size_t a = 0; a < arcs.size(); ++a)
    for (std::size_t p = 0; p < arcs[a].pieces.size(); ++p) {
      const auto& piece = arcs[a].pieces[p];
      const auto local = coordinates_in(piece, face, weights, tensor);
      Scalar margin = std::min(local[0], std::min(local[1], local[2]));
      // Across the direction, how far along from begin to end: begin + f (end - begin), the
      // direction and the place are in one line.
      const Scalar at_begin = determinant<Scalar>({local, piece.begin, piece.direction});
      const Scalar at_end = determinant<Scalar>({local, piece.end, piece.direction});
      if (at_begin == at_end) continue;
      Scalar f = at_begin / (at_begin - at_end);
      // Several arcs may cross one triangle side by side: it is the one that the line meets.
      if (f < Scalar(0)) margin = std::min(margin, f), f = Scalar(0);
      if (f > Scalar(1)) margin = std::min(margin, Scalar(1) - f), f = Scalar(1);
      if (best_arc >= 0 && !(margin > best_margin)) continue;
      best_arc = static_cast<int>(a);
      best_margin = margin;
      best_place = Scalar(static_cast<double>(p)) + f;
    }
  return {best_arc, best_place};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                            \
  template void sample_arc(FaceArc<Scalar>&, const std::array<Deviator<Scalar>, 3>&,              \
                           const Level<Scalar>&, const SampleTurns&);                             \
  template CurvePoint<Scalar> point_on_arc(const FaceArc<Scalar>&,                                \
                                           const std::array<Deviator<Scalar>, 3>&, const Scalar&, \
                                           const Level<Scalar>&);                                 \
  template std::pair<int, Scalar> locate_on_arcs(                                                 \
      std::span<const FaceArc<Scalar>>, const std::array<Deviator<Scalar>, 3>&,                   \
      const std::array<Scalar, 3>&, const Deviator<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
