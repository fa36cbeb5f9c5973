// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/critical_gaps.hpp"

#include <cstddef>

#include "interval_lines.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo {
namespace {

using namespace detail;
using Tensor = IntervalTensor;

/// Parts of an edge, or of the line of tensors orthogonal to a face, are halved so often at least
/// before a critical point is believed to be there (or to be beyond the level), and so often at
/// most.
constexpr int kFirstDepth = 14, kBeyondDepth = 24, kLastDepth = 48;
/// An enclosure of a gap is narrow if its ends differ by less than this factor.
constexpr double kNarrow = 1.25;
constexpr int kMostParts = 4000;

/// Looks at one critical point after the other and keeps what they leave of the gaps.
class Clearing {
 public:
  Clearing(const ModeValue& mode, double widest)
      : sign_(mode.sign()), open_(widest), own_(gap_of(mode)) {}

  CriticalGaps gaps() const { return {open_, none_beyond_}; }
  const Range& own() const { return own_; }

  bool vertex(const Tensor& t) {
    if (has_other_sign(determinant_form(t))) return true;
    return take(degenerate_gap(t), kLastDepth) == Answer::settled;
  }

  bool edge(const Tensor& from, const Tensor& to) {
    const Tensor step = to - from;
    const Line line(from, step);
    Polynomial q_part = times(line.norm, derivative(line.determinant));
    Polynomial p_part = times(derivative(line.norm), line.determinant);
    for (auto& c : q_part) c *= Range(2);
    for (auto& c : p_part) c *= Range(3);
    const Polynomial increase = minus(q_part, p_part);
    parts_ = 0;
    return search(Range(0, 1), 0, [&](const Range& x, int depth) {
      if (is_not_zero(range_of(increase, x))) return Answer::settled;
      if (has_other_sign(range_of(line.determinant, x))) return Answer::settled;
      return take(degenerate_gap(from + x * step), depth);
    });
  }

  bool face(const std::array<Tensor, 3>& corners) {
    const auto own = spread_out(corners);
    const auto complement = orthogonal_pair(own);
    const Tensor n1 = orthogonal_to({own[0], own[1], own[2], complement[1]});
    const Tensor n2 = orthogonal_to({own[0], own[1], own[2], complement[0]});
    const Range gram = norm_form(n1) * norm_form(n2) - norm_form(n1, n2) * norm_form(n1, n2);
    if (!(gram.inf() > 0)) return false;
    std::array<SymmetricTensor<Range>, 3> dual;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto others = spread_out(std::array{corners[i == 0 ? 1 : 0], corners[i == 2 ? 1 : 2]});
      Tensor d = orthogonal_to({others[0], others[1], complement[0], complement[1]});
      const Range side = norm_form(corners[i], d);
      if (!is_not_zero(side)) return false;
      if (side.sup() < 0) d = Range(-1) * d;
      dual[i] = thrice(d);
    }
    return half_of_face(n1, n2, dual) && half_of_face(n2, n1, dual);
  }

  bool inside(const std::array<Tensor, 4>& corners) {
    const auto own = spread_out(corners);
    const Tensor n = orthogonal_to(own);
    const Range p = norm_form(n);
    if (!(p.inf() > 0)) return false;
    const Range q = determinant_form(n);
    const auto m = thrice(n), mm = square(m);
    for (std::size_t i = 0; i < 4; ++i) {
      const Tensor d = dual_tensor(corners, i, n);
      const Range side = norm_form(corners[i], d);
      const auto k = thrice(d);
      const Range weight = p * inner(mm, k) - q * inner(m, k);
      if (is_outside(side * weight)) return true;
    }
    return take(Range(2) * q * q / (p * p * p), kLastDepth) == Answer::settled;
  }

 private:
  enum class Answer { settled, divide };

  /// Part of what is orthogonal to a face: the tensors a + x b, |x| <= 1. The critical tensor that
  /// belongs to N is G = N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N if it is orthogonal to all of
  /// them, and |mode G|^2 = 1 - mode(N)^2.
  bool half_of_face(const Tensor& a, const Tensor& b,
                    const std::array<SymmetricTensor<Range>, 3>& dual) {
    const Line line(a, b);
    const Polynomial cubic = line.critical_cubic();
    std::array<Polynomial, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) weights[i] = line.critical_weight(dual[i]);
    parts_ = 0;
    return search(Range(-1, 1), 0, [&](const Range& x, int depth) {
      if (is_not_zero(range_of(cubic, x))) return Answer::settled;
      const Range p = range_of(line.norm, x), q = range_of(line.determinant, x);
      for (const auto& w : weights)
        if (is_outside(range_of(w, x))) return Answer::settled;
      return take(Range(2) * CGAL::square(q) / (p * p * p), depth);
    });
  }

  template <class Look>
  bool search(const Range& x, int depth, const Look& look) {
    if (++parts_ > kMostParts) return false;
    if (look(x, depth) == Answer::settled) return true;
    if (depth >= kLastDepth) return false;
    const double m = middle(x);
    return search(Range(x.inf(), m), depth + 1, look) && search(Range(m, x.sup()), depth + 1, look);
  }

  /// What a critical value with this gap, if there is one, leaves free; divided further while that
  /// is vague.
  Answer take(const Range& gap, int depth) {
    if (gap.inf() >= open_) return Answer::settled;
    if (depth < kFirstDepth) return Answer::divide;
    if (gap.sup() < own_.inf()) {
      if (depth < kBeyondDepth) return Answer::divide;
      none_beyond_ = false;
      return Answer::settled;
    }
    if (!(gap.inf() > own_.sup())) return Answer::divide;
    if (depth < kLastDepth && gap.sup() > kNarrow * gap.inf()) return Answer::divide;
    open_ = gap.inf();
    return Answer::settled;
  }

  bool has_other_sign(const Range& determinant) const {
    return sign_ > 0 ? determinant.sup() < 0 : determinant.inf() > 0;
  }

  /// Whether a weight of a critical tensor G puts the point outside. The mode of such a tensor is
  /// negative: G itself counts for negative modes, -G for positive ones.
  bool is_outside(const Range& weight) const {
    return sign_ > 0 ? weight.inf() > 0 : weight.sup() < 0;
  }

  int sign_;
  double open_;
  Range own_;
  bool none_beyond_ = true;
  int parts_ = 0;
};

}  // namespace

std::optional<CriticalGaps> critical_gaps(const std::array<SymmetricTensor<double>, 4>& tensors,
                                          const ModeValue& mode, double widest) {
  const UpwardRounding upward;
  std::array<Tensor, 4> t;
  for (std::size_t i = 0; i < 4; ++i) t[i] = normalized(deviator_enclosure(tensors[i]));
  Clearing clearing(mode, widest);
  if (mode.sign() == 0 || !(clearing.own().sup() < widest)) return std::nullopt;
  for (const auto& corner : t)
    if (!clearing.vertex(corner)) return std::nullopt;
  if (!clearing.inside(t)) return std::nullopt;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (!clearing.edge(t[i], t[j])) return std::nullopt;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Tensor, 3> face;
    for (std::size_t j = 0, k = 0; j < 4; ++j)
      if (j != i) face[k++] = t[j];
    if (!clearing.face(face)) return std::nullopt;
  }
  return clearing.gaps();
}

}  // namespace tensortopo
