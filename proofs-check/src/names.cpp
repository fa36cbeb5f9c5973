// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "certificates/step.hpp"
#include "proof_steps/steps.hpp"

namespace proofs {

const char* name(Kind kind) {
  switch (kind) {
    case Kind::identity:
      return "identity";
    case Kind::inequality:
      return "inequality";
    case Kind::count:
      break;
  }
  return "count";
}

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::corrected:
      return "corrected";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

const char* name(Place place) {
  switch (place) {
    case Place::background:
      return "Tensor background";
    case Place::theorem1:
      return "Theorem 1, medium eigenvectors";
    case Place::theorem2:
      return "Theorem 2, complex domain boundary";
    case Place::corollary3:
      return "Corollary 3, nested complex domains";
    case Place::lemma4:
      return "Lemma 4, the boundary by alpha";
    case Place::theorem5:
      return "Theorem 5, bifurcation";
    case Place::loops:
      return "Not in the paper: loops of the complex domain boundary in a tetrahedron";
    case Place::theorem6:
      return "Theorem 6, at most four extrema";
    case Place::quads:
      return "Quad parameterization";
    case Place::faces:
      return "Extraction in faces and tetrahedra";
    case Place::saddle:
      return "Not in the paper: the saddle in space";
    case Place::screen:
      return "Not in the paper: the Lode angle";
    case Place::stability:
      return "Not in the paper: fields close to a field";
    case Place::forms:
      break;
  }
  return "Not in the paper: forms in coordinates";
}

}  // namespace proofs
