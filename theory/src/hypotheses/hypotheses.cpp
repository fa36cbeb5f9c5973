// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "hypotheses/hypotheses.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "hypotheses/needed.hpp"
#include "plane/checks.hpp"

namespace tensortopo::theory {
namespace {

// A hypothesis that the correction adds: the witness against the paper lacks it.
constexpr auto kCorrection = nullptr;

struct Entry {
  std::string id;
  std::string hypothesis;  ///< may be empty
  Outcome (*without)();    ///< kCorrection: the paper's wording at its witness
  std::string unneeded{};  ///< hypotheses without such a field
};

const std::string kExact = "rational eigenvectors and parameters keep signs exact";
const std::string kUnique = "rank 4 makes the characteristic tensor one";

std::vector<Entry> entries() {
  return {
      {"mode-range", "trace 0", identity_as_a_tensor, "the zero tensor has no mode"},
      {"mode-extremes", "trace 0", equal_pair_with_trace, "the zero tensor has no mode"},
      {"eigenvalues-of-mode", "trace 0", identity_as_a_tensor,
       "norm 1: of another norm the numbers are to be multiplied by it"},
      {"mode-parameter", "s <= 1, for an increasing mode", parameter_beyond_one},
      {"discriminant", "trace 0", discriminant_with_trace},
      {"lode-screen", "trace 0", lode_angles_with_trace, kExact},
      {"degree-six-equation", "T is not 0", zero_tensor, kExact},
      {"mode-not-polynomial", "not all of one tensor", line_of_one_tensor},
      {"lasting-features", "a persistence of more than 2 b", maxima_that_do_not_last,
       "nine tensors on a path: the trial's size"},
      {"points-of-vectors", "weights of a sum other than 0", kCorrection},
      {"medium-eigenvector-count", "A(v) is no multiple of the identity", kCorrection,
       kUnique + "; " + kExact},
      {"dominant-eigenvector", "", kCorrection, kExact},
      {"antipodal-matrix", "", kCorrection,
       kUnique + ", but the identity is one of matrices: it needs no field; " + kExact},
      {"complex-domain-vectors", "mode mu or farther from 0", kCorrection, kUnique + "; " + kExact},
      {"boundary-degree", "", kCorrection, kUnique},
      {"real-domain", "rank 4", two_orthogonal_tensors, kExact},
      {"signed-root", "", kCorrection, kUnique + "; " + kExact},
      {"tensor-of-vector", "v is no singularity", isotropic_across_vector, kExact},
      {"tensor-on-boundary", "s > 0", vanishing_boundary_tensor},
      {"shared-face", "not both sigma 0", kCorrection, kExact},
      {"crossing-test", "a turn by less than a right angle", kCorrection,
       "a constant dominant eigenvector makes the curve rational"},
      {"neutral-lift", "", kCorrection, kExact + "; three eigenvalues: not known to be needed"},
      {"complex-domain-nesting", "characteristic determinant other than 0, for proper subsets",
       kCorrection, kUnique + "; " + kExact},
      {"boundary-parameter", "l1 and l2 differ", kCorrection, kUnique + "; " + kExact},
      {"bifurcation-mode", "characteristic determinant other than 0", boundary_of_one_point,
       kUnique + "; " + kExact},
      {"singularities", "l1 and l2 differ, for two pairs", singularities_that_coincide,
       kUnique + "; " + kExact},
      {"quad-parameterization", "", kCorrection, kUnique + "; " + kExact},
      {"straight-boundary", "", kCorrection, kExact},
      {"singularity-lines", "projective space", kCorrection, kUnique + "; " + kExact},
      {"stereographic-delaunay", "the pole outside of the empty cap", kCorrection,
       "rational points keep signs exact"},
      {"degenerate-curve-circle", "characteristic determinant other than 0", kCorrection},
      {"neutral-surface-topology", "characteristic eigenvalues that differ", kCorrection},
      {"bifurcation-topology", "mu other than mu0", level_through_the_saddle,
       "at some distance from mu0: the trial's budget"},
      {"bifurcation-surface", "characteristic determinant other than 0", degenerate_saddle},
      {"neutral-surface-orientability", "projective space", kCorrection},
      {"no-closed-component", "", kCorrection,
       "a field that does not vanish in the tetrahedron, and three eigenvalues for mu = 0: not "
       "known to be needed"},
      {"interior-boundary-loop", "", kCorrection,
       "without eigenvalues that differ, none of them 0, and mu < mu0 there are no two loops; "
       "that a loop is inside is what is spoken of"},
      {"planar-extrema", "isolated critical points", kCorrection},
      {"planar-critical-pairs", "isolated critical points", kCorrection},
      {"planar-critical-pairs", "simple ones, for two or four degenerate points",
       three_degenerate_points},
      {"complement-pencil", "N is not degenerate", dual_of_degenerate_tensor,
       "rational N and T keep signs exact"},
      {"planar-redundancy", "w is not 0", third_equation_fails},
      {"planar-spurious-solutions", "no critical point with w = 0", kCorrection,
       "an orthogonal basis is what the paper has"},
      {"planar-points-at-infinity", "weights of a sum other than 0", kCorrection},
      {"loop-encloses-extremum", "", kCorrection,
       "critical points apart, for the count of extrema and saddles, and a rational parameter keep "
       "the trial exact; without them the extremum is still inside"},
  };
}

}  // namespace

void add_hypotheses(std::vector<Statement>& all) {
  for (Entry& entry : entries()) {
    const auto found = std::ranges::find(all, entry.id, &Statement::id);
    Statement& s = *found;
    if (!entry.hypothesis.empty()) {
      const auto without =
          entry.without != nullptr ? std::function<Outcome()>(entry.without) : s.paper_at_witness;
      s.needed.push_back({std::move(entry.hypothesis), without});
    }
    if (!entry.unneeded.empty()) s.unneeded = std::move(entry.unneeded);
  }
}

}  // namespace tensortopo::theory
