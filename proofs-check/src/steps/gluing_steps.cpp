// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The topology of a generalized mode surface: the sphere without the complex domain, its boundary
// glued by the antipodal map, on a sphere made of squares.
#include <map>
#include <tuple>

#include "certificates/step.hpp"
#include "steps/common/boundary_edges.hpp"
#include "steps/common/glued_cube.hpp"

namespace proofs {
namespace {

int whole(const Polynomial& number) { return static_cast<int>(number.constant().get_d()); }

void is_closed_surface(Checks& c, const GluedSurface& surface, const Polynomial& euler) {
  c.equal(surface.boundary_edges, 0);
  c.that(surface.is_manifold, "not a surface");
  c.equal(surface.components, c.k(1));
  c.equal(surface.orientable ? 1 : 0, c.k(1));
  c.equal(static_cast<int>(surface.euler_characteristic()), euler);
}

/// Closed curves of the boundary on the sphere, from how often it meets the edges m_x = 0 and
/// m_y = 0 of the triangle of squares: each octant has a copy of one arc, whose two ends are on the
/// planes x = 0 and y = 0, or both on one of them.
int loops(Checks& c, int on_first, int on_second) {
  c.equal(on_first + on_second, c.k(2));
  using End = std::tuple<int, int, int, int, int>;  // the plane, which end on it, three signs
  std::map<End, int> part;
  int fresh = 0;
  const auto join = [&](const End& u, const End& v) {
    for (const End& end : {u, v})
      if (part.count(end) == 0) part[end] = fresh++;
    const int kept = part[u], gone = part[v];
    for (auto& [end, number] : part)
      if (number == gone) number = kept;
  };
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) {
        std::vector<End> ends;
        for (int i = 0; i < on_first; ++i) ends.push_back({0, i, 0, y, z});
        for (int i = 0; i < on_second; ++i) ends.push_back({1, i, x, 0, z});
        if (ends.size() == 2) join(ends[0], ends[1]);
      }
  std::map<int, int> sizes;
  for (const auto& [end, number] : part) ++sizes[number];
  return static_cast<int>(sizes.size());
}

/// Pairs of antipodal loops. No loop is its own antipode: each is on one side of the plane z = 0,
/// which it does not meet.
int pairs_of_loops(Checks& c, const std::array<int, 3>& crossings) {
  c.equal(crossings[2], c.k(0));
  return loops(c, crossings[0], crossings[1]) / 2;
}

// The discs that are left out of the sphere, one of each pair.
void glued_pairs(Checks& c, int pairs, const std::vector<TopSquare>& discs,
                 const Polynomial& euler) {
  c.equal(pairs, static_cast<int>(discs.size()));
  is_closed_surface(c, glue_opposites(7, discs, whole(c.k(0))), euler);
}

void two_loops(Checks& c) {
  const int pairs = pairs_of_loops(c, crossings_above_bifurcation(c));
  c.equal(pairs, c.k(1));
  glued_pairs(c, pairs, {{1, 3}}, c.k(0));
}
void four_loops(Checks& c) {
  const int pairs = pairs_of_loops(c, crossings_below_bifurcation(c));
  c.equal(pairs, c.k(2));
  glued_pairs(c, pairs, {{1, 3}, {5, 3}}, c.k(-2));
}

void no_loops(Checks& c) {
  // The sphere itself, so that the count is known to count.
  is_closed_surface(c, glue_opposites(3, {}, 0), c.k(2));
}

/// The same without gluing: the squares put back.
void loop_in_one_sheet(Checks& c) {
  // Three holes for face curves beside the pair of discs, all in one part of the sphere.
  const std::vector<TopSquare> discs{{1, 3}};
  const auto holes = [](const std::array<int, 3>& low, std::size_t axis) {
    return axis == 0 && low[1] == 3 && (low[2] == 1 || low[2] == 3 || low[2] == 5) && low[0] == 0;
  };
  const GluedSurface with = glue_opposites(7, discs, 0, holes),
                     without = glue_opposites(7, {}, 0, holes);
  c.equal(static_cast<int>(with.euler_characteristic() - without.euler_characteristic()), c.k(-2));
  c.equal(without.components, c.k(1));
  c.equal(with.components, c.k(1));
  c.equal(with.orientable ? 1 : 0, c.k(1));
  c.equal(with.boundary_loops, c.k(3));
  c.equal(without.boundary_loops, c.k(3));
  // 2 - 2 h - 3 with h = 1.
  c.equal(static_cast<int>(with.euler_characteristic()),
          c.k(2) - c.k(2) * c.k(1) - with.boundary_loops);
}

void loop_between_sheets(Checks& c) {
  // A band around the sides is left out: two sheets with one of the discs each.
  const std::vector<TopSquare> discs{{1, 3}};
  const auto band = [](const std::array<int, 3>& low, std::size_t axis) {
    return axis != 2 && low[2] == 3;
  };
  const GluedSurface with = glue_opposites(7, discs, 0, band),
                     without = glue_opposites(7, {}, 0, band);
  c.equal(static_cast<int>(with.euler_characteristic() - without.euler_characteristic()), c.k(-2));
  c.equal(without.components, c.k(2));
  c.equal(with.components, c.k(1));
  c.equal(with.orientable ? 1 : 0, c.k(1));
  c.equal(with.boundary_loops, c.k(2));
  c.equal(without.boundary_loops, c.k(2));
  c.equal(static_cast<int>(with.euler_characteristic()), c.k(2) - with.boundary_loops);
}

}  // namespace

std::vector<Step> gluing_steps() {
  return {
      claim(Place::theorem5, "gluing-none", Kind::count,
            "nothing removed: a closed orientable surface of Euler characteristic 2, the sphere",
            no_loops),
      claim(Place::theorem5, "gluing-before-bifurcation", Kind::count,
            "the boundary meets m_x = 0 and m_y = 0 once each: eight arcs, two loops; one pair of "
            "antipodal discs removed, their boundaries glued by the antipodal map: a closed "
            "connected orientable surface of Euler characteristic 0, a torus",
            two_loops),
      claim(
          Place::theorem5, "gluing-after-bifurcation", Kind::count,
          "it meets m_y = 0 twice: four loops, two pairs: Euler characteristic -2, a double torus",
          four_loops),
      claim(Place::loops, "loop-in-one-sheet", Kind::count,
            "a pair of antipodal discs in one sheet removed and glued: Euler characteristic 2 "
            "less, the same boundary, one handle more (an example with three boundary loops)",
            loop_in_one_sheet),
      claim(Place::loops, "loop-between-sheets", Kind::count,
            "in two sheets: Euler characteristic 2 less, the same boundary, one sheet less and no "
            "handle: a tube joins them (an example of two discs)",
            loop_between_sheets),
  };
}

}  // namespace proofs
