// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/degenerate_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "interval_tensors.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {
namespace {

using namespace detail;
using Vector = Vector3<Range>;

/// How often a side of the square of directions is divided at most, and where: not in the middle,
/// so that what is symmetric is not met exactly.
constexpr int kLastDepth = 60;
constexpr double kDivision = 0.4921875;
constexpr int kMostParts = 4000;
/// Eigenvectors that are given along an arc.
constexpr int kStepsOfSide = 32;

/// The cone of vectors e with e N e = 0, one of each pair +-e: e = x f + y g + z h with z > 0 for
/// every direction (x, y).
class Cone {
 public:
  bool build(const IntervalTensor& n) {
    const Deviator<double> rounded = middle(n);
    const auto system = eigen_decomposition(to_tensor(rounded));
    // The eigenvalue that is alone with its sign.
    const std::size_t alone = system.values[1] > 0 ? 2 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& v = system.vectors[(alone + 1 + i) % 3];
      frame_[i] = {Range(v.x), Range(v.y), Range(v.z)};
    }
    n_ = thrice(n);
    if (form(frame_[2], frame_[2]).sup() < 0) n_ = Range(-1) * n_;
    h_ = form(frame_[2], frame_[2]);
    const Range f = form(frame_[0], frame_[0]), g = form(frame_[1], frame_[1]);
    const Range mixed = form(frame_[0], frame_[1]);
    return h_.inf() > 0 && f.sup() < 0 && (f * g - CGAL::square(mixed)).inf() > 0 &&
           is_not_zero(dot(frame_[0], cross(frame_[1], frame_[2])));
  }

  /// e and its derivative for the direction that runs along one side of the square |x|, |y| <= 1.
  std::pair<Vector, Vector> at(int side, const Range& s) const {
    const Range one(side < 2 ? 1 : -1), zero(0);
    // Counter-clockwise: (1, s), (-s, 1), (-1, -s), (s, -1).
    const bool upright = side % 2 == 0;
    const Range x = upright ? one : -(one * s), y = upright ? one * s : one;
    const Range dx = upright ? zero : -one, dy = upright ? one : zero;
    const Vector flat = x * frame_[0] + y * frame_[1], step = dx * frame_[0] + dy * frame_[1];
    const Range b = form(flat, frame_[2]), c = form(flat, flat);
    Range inside = CGAL::square(b) - h_ * c;  // positive, since c is negative
    if (inside.inf() < 0) inside = Range(0, inside.sup());
    const Range z = (CGAL::sqrt(inside) - b) / h_;
    const Vector e = flat + z * frame_[2];
    const Range dz = -form(e, step) / form(e, frame_[2]);
    return {e, step + dz * frame_[2]};
  }

 private:
  Range form(const Vector& u, const Vector& v) const { return dot(u, n_ * v); }

  SymmetricTensor<Range> n_;
  std::array<Vector, 3> frame_;
  Range h_;
};

/// The conic from place to place, in the order in which it runs.
class Walk {
 public:
  Walk(const std::array<IntervalTensor, 4>& corners, const ModeValue& mode)
      : corners_(corners), sign_(mode.sign()), gap_(gap_of(mode)) {}

  std::optional<std::vector<DegenerateArc>> arcs() {
    const IntervalTensor n = orthogonal_to(spread_out(corners_));
    if (!cone_.build(n)) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
      const IntervalTensor d = dual_tensor(corners_, i, n);
      const Range side = norm_form(corners_[i], d);
      if (!is_not_zero(side)) return std::nullopt;
      dual_[i] = (Range(sign_) / side) * thrice(d);
    }
    for (int side = 0; side < 4; ++side)
      if (!walk(side, Range(-1, 1), 0)) return std::nullopt;
    return paired();
  }

 private:
  struct Crossing {
    int face;
    bool entering;
    int side;
    Range part;
  };

  Range weight(std::size_t i, const Vector& e, const Vector& f) const {
    return dot(e, dual_[i] * f);
  }

  /// The vectors over a part of a side with their derivative, and that in its middle.
  struct Part {
    Range offset;  ///< from the middle
    Vector at_middle, e, step;
  };

  Part part_of(int side, const Range& s) const {
    const Range m(middle(s));
    auto [e, step] = cone_.at(side, s);
    return {s - m, cone_.at(side, m).first, e, step};
  }

  /// Weight i over a part, by the mean value theorem, and its derivative there.
  std::pair<Range, Range> weight_over(std::size_t i, const Part& part) const {
    const Range slope = Range(2) * weight(i, part.e, part.step);
    return {weight(i, part.at_middle, part.at_middle) + slope * part.offset, slope};
  }

  Range weight_at(std::size_t i, int side, double s) const {
    const Vector e = cone_.at(side, Range(s)).first;
    return weight(i, e, e);
  }

  bool walk(int side, const Range& s, int depth) {
    if (++parts_ > kMostParts || depth > kLastDepth) return false;
    int open = -1;
    bool rises = false, divide = false;
    const Part part = part_of(side, s);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [w, slope] = weight_over(i, part);
      if (w.sup() < 0) return stay(false);
      if (w.inf() > 0) continue;
      if (open >= 0 || !is_not_zero(slope)) divide = true;
      open = static_cast<int>(i);
      rises = slope.inf() > 0;
    }
    if (open < 0) return stay(true);
    if (!divide) {
      const auto i = static_cast<std::size_t>(open);
      const Range first = weight_at(i, side, s.inf()), last = weight_at(i, side, s.sup());
      if (is_not_zero(first) && is_not_zero(last)) {
        const bool in_first = first.inf() > 0, in_last = last.inf() > 0;
        if (!stay(in_first)) return false;
        if (in_first == in_last) return true;
        crossings_.push_back({open, rises, side, s});
        return stay(in_last);
      }
    }
    const double cut = s.inf() + kDivision * (s.sup() - s.inf());
    return walk(side, Range(s.inf(), cut), depth + 1) && walk(side, Range(cut, s.sup()), depth + 1);
  }

  /// From the last part to this one nothing changes unless a crossing was noted.
  bool stay(bool inside) {
    if (known_ && inside_ != inside &&
        (crossings_.empty() || crossings_.back().entering != inside || noted_ == crossings_.size()))
      return false;
    noted_ = crossings_.size();
    if (!known_) first_inside_ = inside;
    known_ = true;
    inside_ = inside;
    return true;
  }

  std::optional<std::vector<DegenerateArc>> paired() {
    // The conic is closed: it ends as it began.
    if (first_inside_ != inside_ || crossings_.size() % 2 != 0) return std::nullopt;
    if (crossings_.empty() && inside_) return std::nullopt;
    std::vector<DegenerateArc> arcs;
    const std::size_t n = crossings_.size();
    for (std::size_t k = 0; k < n; ++k) {
      auto& from = crossings_[k];
      auto& to = crossings_[(k + 1) % n];
      if (from.entering == to.entering) return std::nullopt;
      if (!from.entering) continue;
      const auto first = end_at(from), last = end_at(to);
      if (!first || !last) return std::nullopt;
      arcs.push_back({{*first, *last}, dominant_along(from, to)});
    }
    return arcs;
  }

  /// Unit vectors on the cone from one crossing to the next.
  std::vector<Vector3<double>> dominant_along(const Crossing& from, const Crossing& to) const {
    const auto place = [](const Crossing& c) { return c.side + (middle(c.part) + 1) / 2; };
    const double first = place(from), last = place(to) > first ? place(to) : place(to) + 4;
    const int steps = std::max(2, static_cast<int>(std::ceil((last - first) * kStepsOfSide)));
    std::vector<Vector3<double>> result;
    for (int k = 0; k <= steps; ++k) {
      const double at = first + (last - first) * k / steps, side = std::floor(at);
      const Vector e = cone_.at(static_cast<int>(side) % 4, Range(2 * (at - side) - 1)).first;
      const Vector3<double> v{middle(e.x), middle(e.y), middle(e.z)};
      result.push_back(unit(v));
    }
    return result;
  }

  /// Narrows the part down until the end is found.
  std::optional<DegenerateEnd> end_at(Crossing& c) const {
    const auto face = static_cast<std::size_t>(c.face);
    for (int depth = 0; depth < kLastDepth; ++depth) {
      if (const auto end = end_within(c)) return end;
      const double cut = middle(c.part);
      const Range w = weight_at(face, c.side, cut);
      if (!is_not_zero(w)) return std::nullopt;
      const bool before = (w.inf() > 0) == c.entering;
      c.part = before ? Range(c.part.inf(), cut) : Range(cut, c.part.sup());
    }
    return std::nullopt;
  }

  /// The middle of the part, if the mode is beyond the level all the way to its other places.
  std::optional<DegenerateEnd> end_within(const Crossing& c) const {
    DegenerateEnd end;
    end.face = c.face;
    IntervalTensor t = Range(0) * corners_[0];
    const Part part = part_of(c.side, c.part);
    for (std::size_t i = 0; i < 4; ++i) {
      if (static_cast<int>(i) == c.face) continue;
      const Range w = weight_over(i, part).first;
      end.weights[i] = middle(weight_at(i, c.side, middle(c.part)));
      if (!(end.weights[i] > 0)) return std::nullopt;
      t = t + CGAL::hull(w, Range(end.weights[i])) * corners_[i];
    }
    if (!(degenerate_gap(t).sup() < gap_.inf()) ||
        (sign_ > 0 ? determinant_form(t).inf() <= 0 : determinant_form(t).sup() >= 0))
      return std::nullopt;
    return end;
  }

  const std::array<IntervalTensor, 4>& corners_;
  int sign_;
  Range gap_;
  Cone cone_;
  std::array<SymmetricTensor<Range>, 4> dual_;
  std::vector<Crossing> crossings_;
  std::size_t noted_ = 0;
  bool known_ = false, inside_ = false, first_inside_ = false;
  int parts_ = 0;
};

}  // namespace

std::optional<std::vector<DegenerateArc>> degenerate_arcs(
    const std::array<SymmetricTensor<double>, 4>& tensors, const std::array<int, 4>& exponents,
    const ModeValue& mode) {
  const UpwardRounding upward;
  std::array<IntervalTensor, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    // In two steps: 2^1074 is not a double, and differences of large components may overflow.
    const int half = exponents[i] / 2;
    const Range first(std::ldexp(1.0, half)), second(std::ldexp(1.0, exponents[i] - half));
    corners[i] = second * deviator(first * tensor_cast<Range>(tensors[i]));
  }
  if (mode.sign() == 0) return std::nullopt;
  return Walk(corners, mode).arcs();
}

}  // namespace tensortopo
