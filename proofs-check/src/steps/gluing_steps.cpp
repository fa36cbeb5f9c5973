// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The topology of a generalized mode surface: the sphere without the complex domain, its boundary
// glued by the antipodal map, on a sphere made of squares.
#include "certificates/step.hpp"
#include "steps/glued_cube.hpp"

namespace proofs {
namespace {

void is_surface(Checks& c, const GluedSurface& surface, const Polynomial& euler_characteristic) {
  c.that(surface.closed, "not a closed surface");
  c.that(surface.connected, "not connected");
  c.that(surface.orientable, "not orientable");
  c.equal(static_cast<int>(surface.euler_characteristic()), euler_characteristic);
}

void two_loops(Checks& c) { is_surface(c, glue_antipodes(3, {{1, 1}}), c.k(0)); }
void four_loops(Checks& c) { is_surface(c, glue_antipodes(7, {{1, 3}, {5, 3}}), c.k(-2)); }

void no_loops(Checks& c) {
  // The sphere itself, so that the count is known to count.
  is_surface(c, glue_antipodes(3, {}), c.k(2));
}

}  // namespace

std::vector<Step> gluing_steps() {
  const Place place = Place::theorem5;
  return {
      claim(place, "gluing-none", Kind::count,
            "nothing removed: a closed orientable surface of Euler characteristic 2, the sphere",
            no_loops),
      claim(place, "gluing-before-bifurcation", Kind::count,
            "one pair of antipodal disks removed, their boundaries glued by the antipodal map: a "
            "closed connected orientable surface of Euler characteristic 0, a torus",
            two_loops),
      claim(place, "gluing-after-bifurcation", Kind::count,
            "two pairs: Euler characteristic -2, a double torus", four_loops),
  };
}

}  // namespace proofs
