// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/a_patches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "baselines/marching.hpp"
#include "extract/level/mode_forms.hpp"
#include "extract/level/segment_root.hpp"

namespace tensortopo::baselines {

namespace {

constexpr std::size_t kDegree = 6;

/// The same bits whichever way the two points are given.
FieldPoint between(const FieldPoint& p, const FieldPoint& q, double t) {
  if (comes_first(q.position, p.position)) return between(q, p, 1 - t);
  return {p.tensor + t * (q.tensor - p.tensor), p.position + t * (q.position - p.position)};
}

/// Corners of a tetrahedron on one side of a patch; the lines go from these to the others.
struct Patch {
  std::size_t apexes = 0;  ///< 1: from a corner to its face; 2: from an edge to the opposite one
  std::array<std::size_t, 4> order{};  ///< apexes first
};

class Patches {
 public:
  Patches(SurfaceMesh::Index tet, const Level<double>& level, const BaselineOptions& options,
          std::vector<SoupTriangle>& out)
      : tet_(tet), level_(level), options_(options), out_(out) {}

  void add(const std::array<FieldPoint, 4>& cell, int halvings) {
    std::array<Deviator<double>, 4> tensors;
    for (std::size_t i = 0; i < 4; ++i) tensors[i] = cell[i].tensor;
    const auto forms = mode_forms(tensors);
    // The neutral surface is where the determinant vanishes: its square would have no signs.
    const auto found = level_.mu_squared == 0
                           ? classify(forms.determinant)
                           : classify(generalized_mode_form(forms, level_.mu_squared));
    if (found.is_empty) return;
    if (found.patch) {
      tessellate(cell, *found.patch);
    } else if (halvings > 0) {
      halve(cell, halvings - 1);
    } else {
      std::array<bool, 4> above;
      for (std::size_t i = 0; i < 4; ++i) above[i] = is_above(cell[i]);
      march(above, tet_, [&](std::size_t i, std::size_t j) { return root(cell[i], cell[j]); },
            out_);
    }
  }

 private:
  struct Class {
    bool is_empty = false;
    std::optional<Patch> patch;
  };

  /// Looks for a layering of the coefficients in which their sign changes once.
  template <class Polynomial>
  static Class classify(const Polynomial& p) {
    Class result;
    bool positive = false, negative = false;
    for (const double c : p.coefficients) (c > 0 ? positive : negative) = true;
    result.is_empty = !(positive && negative);
    if (result.is_empty) return result;
    constexpr std::array<Patch, 7> patches{{{1, {0, 1, 2, 3}},
                                            {1, {1, 0, 3, 2}},
                                            {1, {2, 0, 1, 3}},
                                            {1, {3, 0, 2, 1}},
                                            {2, {0, 1, 2, 3}},
                                            {2, {0, 2, 3, 1}},
                                            {2, {0, 3, 1, 2}}}};
    for (const auto& patch : patches)
      if (changes_once(p, patch)) {
        result.patch = patch;
        break;
      }
    return result;
  }

  template <class Polynomial>
  static bool changes_once(const Polynomial& p, const Patch& patch) {
    enum : unsigned { none = 0, plus = 1, minus = 2 };
    std::array<unsigned, kDegree + 1> layers{};
    for (std::size_t i = 0; i < p.size; ++i) {
      std::size_t layer = 0;
      for (std::size_t k = 0; k < patch.apexes; ++k) layer += p.exponents[i][patch.order[k]];
      const double c = p.coefficients[i];
      layers[layer] |= c > 0 ? plus : c < 0 ? minus : none;
    }
    // One mixed layer at most, one sign before and the other after it.
    unsigned before = none, after = none;
    bool mixed = false;
    for (const auto signs : layers) {
      if (signs == none) continue;
      if (signs == (plus | minus)) {
        if (mixed || after != none) return false;
        mixed = true;
      } else if (!mixed && after == none && (before == none || before == signs)) {
        before = signs;
      } else if (after == none ? signs != before : signs == after) {
        after = signs;
      } else {
        return false;
      }
    }
    return true;
  }

  /// Across the middle of its longest edge.
  void halve(const std::array<FieldPoint, 4>& cell, int halvings) {
    std::size_t a = 0, b = 1;
    double longest = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const auto e = cell[j].position - cell[i].position;
        if (dot(e, e) > longest) longest = dot(e, e), a = i, b = j;
      }
    const FieldPoint middle{0.5 * (cell[a].tensor + cell[b].tensor),
                            0.5 * (cell[a].position + cell[b].position)};
    auto first = cell, second = cell;
    first[b] = second[a] = middle;
    add(first, halvings);
    add(second, halvings);
  }

  bool is_above(const FieldPoint& p) const { return level_function(p.tensor, level_) > 0; }

  Vector3<double> root(const FieldPoint& p, const FieldPoint& q) const {
    const bool swapped = comes_first(q.position, p.position);
    const auto &from = swapped ? q : p, &to = swapped ? p : q;
    const double t = segment_root(from.tensor, to.tensor, is_above(to), level_);
    return from.position + t * (to.position - from.position);
  }

  /// A line of the patch: from its apex to its foot.
  struct Line {
    FieldPoint apex, foot;
    bool apex_above = false, foot_above = false;
    bool meets() const { return apex_above != foot_above; }
  };

  Line line(const FieldPoint& apex, const FieldPoint& foot) const {
    return {apex, foot, is_above(apex), is_above(foot)};
  }

  /// Where the surface leaves the patch between two lines of which one meets it: through the face
  /// or edge in which apex or foot moves from one side to the other.
  Vector3<double> end(const Line& p, const Line& q) const {
    return p.apex_above != q.apex_above ? root(p.apex, q.apex) : root(p.foot, q.foot);
  }

  /// The part of the surface over a triangle of neighbouring lines.
  void add_triangle(const std::array<const Line*, 3>& lines) {
    std::array<Vector3<double>, 4> polygon;
    std::size_t n = 0;
    Vector3<double> towards_apex{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Line &p = *lines[i], &q = *lines[(i + 1) % 3];
      if (p.meets()) {
        polygon[n++] = root(p.apex, p.foot);
        const double sign = p.apex_above ? 1 : -1;
        towards_apex += sign * (p.apex.position - p.foot.position);
      }
      if (p.meets() != q.meets()) polygon[n++] = end(p, q);
    }
    if (n < 3) return;
    const auto normal = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    if (dot(normal, towards_apex) < 0)
      std::reverse(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(n));
    for (std::size_t k = 2; k < n; ++k)
      out_.push_back({{polygon[0], polygon[k - 1], polygon[k]}, tet_});
  }

  void tessellate(const std::array<FieldPoint, 4>& cell, const Patch& patch) {
    const auto n = static_cast<std::size_t>(std::max(1, options_.samples));
    const double step = 1.0 / static_cast<double>(n);
    const auto &a = cell[patch.order[0]], &b = cell[patch.order[1]], &c = cell[patch.order[2]],
               &d = cell[patch.order[3]];
    std::vector<Line> grid((n + 1) * (n + 1));
    const auto at = [&](std::size_t i, std::size_t j) -> Line& { return grid[i * (n + 1) + j]; };
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; j <= n; ++j) {
        const double u = step * static_cast<double>(i), v = step * static_cast<double>(j);
        if (patch.apexes == 2)
          at(i, j) = line(between(a, b, u), between(c, d, v));
        else if (i + j <= n)
          at(i, j) = line(a, foot(b, c, d, u, v));
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const bool triangular = patch.apexes == 1;
        if (!triangular || i + j < n) add_triangle({&at(i, j), &at(i + 1, j), &at(i, j + 1)});
        if (!triangular || i + j + 1 < n)
          add_triangle({&at(i + 1, j), &at(i + 1, j + 1), &at(i, j + 1)});
      }
  }

  static FieldPoint foot(const FieldPoint& b, const FieldPoint& c, const FieldPoint& d, double u,
                         double v) {
    if (v == 0) return between(b, c, u);
    if (u == 0) return between(b, d, v);
    if (u + v == 1) return between(c, d, v);
    return {b.tensor + u * (c.tensor - b.tensor) + v * (d.tensor - b.tensor),
            b.position + u * (c.position - b.position) + v * (d.position - b.position)};
  }

  SurfaceMesh::Index tet_;
  const Level<double>& level_;
  const BaselineOptions& options_;
  std::vector<SoupTriangle>& out_;
};

}  // namespace

void add_a_patches(const std::array<FieldPoint, 4>& corners, SurfaceMesh::Index tet,
                   const Level<double>& level, const BaselineOptions& options,
                   std::vector<SoupTriangle>& out) {
  Patches(tet, level, options, out).add(corners, options.halvings);
}

}  // namespace tensortopo::baselines
