// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// How the pieces of several tetrahedra meet at an edge of the mesh.
#include <algorithm>

#include "surface/pieces.hpp"

namespace certificate {

/// Sheets that a stretch of larger modes around an edge between tips has at its ends are joined
/// there, and no others.
void Pieces::compare_folds() const {
  const Folds folds(c_);
  const auto edges_of = [&](const Fold& fold) -> const std::vector<BoundaryEdge>& {
    const auto name = vertices_.vertex.find(fold.cone->sheets[fold.sheet].crossings[0]);
    if (name != vertices_.vertex.end())
      if (const auto found = folds_.find({fold.cone->tet, name->second}); found != folds_.end())
        return found->second;
    throw Wrong("no sheet at the crossing in tetrahedron " +
                std::to_string(c_.input.cells[fold.cone->tet]));
  };
  for (const ConeTopology& cone : c_.topology.cones) {
    if (!cone.is_decided()) continue;
    for (std::size_t k = 0; cone.tips.size() == 2 && k < cone.sheets.size(); ++k) {
      const std::vector<BoundaryEdge>& own = edges_of({&cone, k});
      Face last{};
      const Fold other = folds.beyond({&cone, k}, last);
      bool same = true;
      if (other.cone != nullptr && !other.cone->is_decided()) continue;
      if (other.cone != nullptr) {
        const std::vector<BoundaryEdge>& there = edges_of(other);
        same = std::equal(own.begin(), own.end(), there.rbegin(), there.rend(),
                          [](const BoundaryEdge& a, const BoundaryEdge& b) {
                            return a.from == b.to && a.to == b.from;
                          });
      } else {
        std::sort(last.begin(), last.end());
        for (const auto& [face, tet] : tets_at(last))
          if (c_.left_out[tet]) same = false;
        // What is left out may be joined to anything, or nothing.
        same = !same || std::all_of(own.begin(), own.end(),
                                    [](const BoundaryEdge& e) { return e.across == kNone; });
      }
      if (!same) throw Wrong("sheets joined otherwise in tetrahedron " +
                             std::to_string(c_.input.cells[cone.tet]));
    }
  }
}

/// Around an edge of the mesh tetrahedra that are not left out fall into groups that are joined
/// through faces. All triangles of a group that have a crossing of that edge have one vertex for
/// it; and each vertex that the certificate gives a crossing is that of a group, or of triangles
/// around the edge in what is left out, which may have any.
void Pieces::compare_fans() const {
  if (vertices_.original.empty()) return;
  std::map<MeshCrossing, std::map<std::size_t, Number>> used;  // by tetrahedra
  std::set<Number> seen;
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    for (const std::uint32_t v : c_.surface.triangles[c_.triangles.first + t]) {
      const auto crossing = vertices_.crossing.find(v);
      if (crossing == vertices_.crossing.end()) continue;
      const auto& tet = c_.input.tets[tets_[t]];
      const auto& edge = crossing->second.edge;
      const bool is_around = std::all_of(edge.begin(), edge.end(), [&](Vertex end) {
        return std::find(tet.begin(), tet.end(), end) != tet.end();
      });
      if (is_around) seen.insert(v);
      if (c_.left_out[tets_[t]]) continue;
      if (!is_around)
        throw Wrong("vertex " + std::to_string(v) + ", a crossing's, beside another edge");
      if (used[crossing->second].emplace(tets_[t], v).first->second != v)
        throw Wrong("two vertices of a crossing in one tetrahedron, one of them " +
                    std::to_string(v));
    }
  }
  for (const auto& [v, crossing] : vertices_.crossing)
    if (!seen.contains(v))
      throw Wrong("vertex " + std::to_string(v) + " of a crossing is that of no triangles around its edge");
  for (const auto& [crossing, by_tet] : used)
    for (const auto& [tet, v] : by_tet)
      for (std::size_t i = 0; i < 4; ++i) {
        const Vertex opposite = c_.input.tets[tet][i];
        if (opposite == crossing.edge[0] || opposite == crossing.edge[1]) continue;
        for (const auto& [face, other] : tets_at(without(c_.input.tets[tet], i)))
          if (const auto there = by_tet.find(other); there != by_tet.end() && there->second != v)
            throw Wrong("vertices " + std::to_string(v) + " and " + std::to_string(there->second) +
                        " of a crossing beside one face of the mesh");
      }
}

}  // namespace certificate
