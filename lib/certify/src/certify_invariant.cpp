// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "claims/bracket_search.hpp"
#include "claims/claims.hpp"
#include "claims/critical_simplices.hpp"
#include "claims/surface_topology.hpp"
#include "distances/distance_proof.hpp"
#include "distances/isotopic_tets.hpp"
#include "run/for_each.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/embedded.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Sides of points of an edge, in double with an error bound, in rationals where that leaves it
/// open.
class EdgeForm {
 public:
  EdgeForm(const TetMesh& mesh, const QuadraticLevel& level, const std::array<Index, 2>& ends)
      : form_(level, tensors(mesh, ends)) {}

  /// @param t  of the second vertex, with so few bits that 1 - t is exact
  bool is_above(double t) const {
    const double s = 1 - t;
    const double size = s * form_.size(0) + t * form_.size(1);
    const double value = value_at(s, t, [&](std::size_t i, std::size_t j) { return form_[i][j]; });
    if (size > QuadricForm::kSmallestSize &&
        std::abs(value) > 2 * QuadricForm::kError * size * size)
      return value > 0;
    return value_at(Rational(s), Rational(t),
                    [&](std::size_t i, std::size_t j) { return form_.exact(i, j); }) > 0;
  }

 private:
  static std::array<const SymmetricTensor<double>*, 4> tensors(const TetMesh& mesh,
                                                               const std::array<Index, 2>& ends) {
    const auto *a = &mesh.tensors[as_size(ends[0])], *b = &mesh.tensors[as_size(ends[1])];
    return {a, b, a, b};
  }
  template <class Scalar, class Form>
  static Scalar value_at(const Scalar& s, const Scalar& t, const Form& form) {
    const Scalar mixed = s * t * form(0, 1);
    return s * s * form(0, 0) + mixed + mixed + t * t * form(1, 1);
  }

  QuadricForm form_;
};

/// Also finds out which way the invariant goes at each crossing.
Brackets brackets_of(const TetMesh& mesh, const QuadraticLevel& level, LevelTopology& topology) {
  Brackets brackets(topology.edges.size());
  detail::for_each(brackets.size(), [&](std::size_t e) {
    auto& edge = topology.edges[e];
    const EdgeForm form(mesh, level, edge.vertices);
    std::vector<NearCrossing> crossings;
    bool above = form.is_above(0);
    for (auto& crossing : edge.crossings) {
      above = !above;
      crossing.rising = above;
      crossings.push_back({crossing.weights[1], crossing.rising});
    }
    brackets[e] = find_brackets(crossings, [&](double t) { return form.is_above(t); });
  });
  return brackets;
}

/// With the same vertex for all fans around a crossing, as claims have it.
SurfaceMesh with_originals(SurfaceMesh surface,
                           std::span<const std::array<SurfaceMesh::Index, 2>> copies) {
  std::map<SurfaceMesh::Index, SurfaceMesh::Index> original;
  for (const auto& [vertex, copy] : copies) original[copy] = vertex;
  for (auto& triangle : surface.triangles)
    for (auto& v : triangle)
      if (const auto found = original.find(v); found != original.end()) v = found->second;
  return surface;
}

}  // namespace

CertifiedLevel certify(const TetMesh& mesh, const InvariantLevel& level,
                       const InvariantExtraction& extraction) {
  const SurfaceMesh& surface = extraction.surface;
  const QuadraticLevel form(level);
  CertifiedLevel result;
  result.value = level;
  result.vertices = surface.points.size();
  result.triangles = surface.triangles.size();
  result.on_level = extraction.statistics.vertices_on_level;
  for (const Index tet : extraction.zero_tensor) result.undecided.push_back({tet, "zero_tensor"});
  result.topology =
      extraction.copies.empty()
          ? topology_of(mesh, surface, result.undecided)
          : topology_of(mesh, with_originals(surface, extraction.copies), result.undecided);
  result.topology.copies = extraction.copies;
  const auto& tets = result.topology.tets;
  std::vector<std::string> reasons(tets.size());
  detail::for_each(reasons.size(), [&](std::size_t i) {
    auto vertices = mesh.tets[as_size(tets[i].tet)];
    std::sort(vertices.begin(), vertices.end());
    reasons[i] = critical_reason(mesh, form, vertices);
  });
  std::map<Index, std::string> critical;
  for (std::size_t i = 0; i < reasons.size(); ++i)
    if (!reasons[i].empty()) critical[tets[i].tet] = reasons[i];
  drop_cells(mesh, result, brackets_of(mesh, form, result.topology), [&](Index tet) {
    const auto found = critical.find(tet);
    return found == critical.end() ? std::string() : found->second;
  });
  result.components = components_of(surface);
  result.embedded = is_embedded(surface);
  const auto decided = decided_triangles(mesh, surface, result);
  result.distance = prove_distance(mesh, surface, decided, result.topology, form);
  if (result.embedded)
    result.not_isotopic =
        tets_not_isotopic(mesh, surface, decided, result.topology, result.distance.coarse,
                          moved_places(mesh, surface, result.distance.reach, form));
  return result;
}

}  // namespace tensortopo
