// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A certificate that claims less than an honest one, of fewer tetrahedra, is not refuted: neither
// where these keep their triangles, nor where they lose them.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "forgeries/forgery_trial.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo::test {
namespace {

using Index = SurfaceMesh::Index;

/// Are the first n numbers of the entry, which ascend, vertices of one of these tetrahedra?
bool is_of_one(const TetMesh& mesh, const std::vector<Index>& tets, const Json& entry,
               std::size_t n) {
  return std::any_of(tets.begin(), tets.end(), [&](Index t) {
    auto corners = mesh.tets[as_size(t)];
    std::sort(corners.begin(), corners.end());
    std::vector<Index> simplex;
    for (std::size_t i = 0; i < n; ++i) simplex.push_back(entry[i].get<Index>());
    return std::includes(corners.begin(), corners.end(), simplex.begin(), simplex.end());
  });
}

void keep(Json& list, const std::function<bool(const Json&)>& wanted) {
  Json kept = Json::array();
  for (const Json& entry : list)
    if (wanted(entry)) kept.push_back(entry);
  list = std::move(kept);
}

/// Nothing is claimed about these tetrahedra, distances and what rests on them.
void leave_out(Exhibit& e, const std::set<Index>& out) {
  Json& level = e.certificate["levels"][0];
  std::vector<Index> rest;
  for (Index t = 0; t < static_cast<Index>(e.mesh.tets.size()); ++t)
    if (!out.contains(t)) rest.push_back(t);
  level["undecided"] = Json::array();
  for (const Index t : out) level["undecided"].push_back({t, "budget_exhausted"});
  for (const char* list : {"tets", "cones"})
    keep(level[list], [&](const Json& entry) { return !out.contains(entry[0].get<Index>()); });
  keep(level["edges"], [&](const Json& entry) { return is_of_one(e.mesh, rest, entry, 2); });
  keep(level["faces"], [&](const Json& entry) { return is_of_one(e.mesh, rest, entry, 3); });
  level["distance"] = nullptr;
  for (const char* key : {"isotopic", "stability"}) level.erase(key);
}

/// Takes the triangles out of tetrahedra that are left out, and numbers vertices anew.
class Cut {
 public:
  Cut(Exhibit& e, const std::set<Index>& out)
      : e_(e), level_(e.certificate["levels"][0]), surface_(e.surface) {
    SurfaceMesh kept;
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      if (out.contains(surface_.tet[i])) continue;
      kept.triangles.push_back(surface_.triangles[i]);
      kept.tet.push_back(surface_.tet[i]);
    }
    kept.points = surface_.points;
    surface_ = std::move(kept);
    before_ = surface_.triangles;
  }

  void run() {
    separate();
    name_tips();
    name_crossings();
    number();
    count();
  }

 private:
  std::vector<Index> all_triangles() const {
    std::vector<Index> all(surface_.triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
    return all;
  }

  /// Classes of the corners of triangles that common edges join.
  UnionFind joined(const std::vector<Index>& triangles) const {
    std::map<std::array<Index, 2>, std::array<std::uint32_t, 2>> sides;
    UnionFind corners(3 * before_.size());
    for (const Index i : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& t = before_[as_size(i)];
        const auto low = static_cast<std::uint32_t>(3 * as_size(i) +
                                                    (t[k] < t[(k + 1) % 3] ? k : (k + 1) % 3)),
                   high = static_cast<std::uint32_t>(3 * as_size(i) +
                                                     (t[k] < t[(k + 1) % 3] ? (k + 1) % 3 : k));
        const auto [known, is_new] =
            sides.try_emplace({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])},
                              std::array{low, high});
        if (is_new) continue;
        corners.unite(known->second[0], low), corners.unite(known->second[1], high);
      }
    return corners;
  }

  /// Each fan around a vertex has one of its own; the first keeps what there is.
  void separate() {
    UnionFind fans = joined(all_triangles());
    std::map<Index, std::uint32_t> first;
    std::map<std::uint32_t, Index> made;
    for (std::size_t i = 0; i < before_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t fan = fans.find(static_cast<std::uint32_t>(3 * i + k));
        const Index v = before_[i][k];
        if (first.try_emplace(v, fan).first->second == fan) continue;
        const auto [known, is_new] =
            made.try_emplace(fan, static_cast<Index>(surface_.points.size()));
        if (is_new)
          surface_.points.push_back(surface_.points[as_size(v)]),
              copies_[v].push_back(known->second);
        surface_.triangles[i][k] = known->second;
      }
  }

  /// A sheet of a cone has the tips of its triangles.
  void name_tips() {
    std::set<Index> tips;
    for (const Json& cone : level_["cones"])
      for (std::size_t s = 1; s < cone.size(); ++s)
        for (std::size_t k = cone[s].size() == 3 ? 2 : 1; k < cone[s].size(); ++k)
          tips.insert(cone[s][k].get<Index>());
    for (Json& cone : level_["cones"]) {
      UnionFind pieces(3 * before_.size());
      std::map<std::array<Index, 2>, std::uint32_t> known;
      for (std::uint32_t i = 0; i < before_.size(); ++i)
        for (std::size_t k = 0; k < 3 && surface_.tet[i] == cone[0].get<Index>(); ++k) {
          const auto [low, high] = std::minmax(before_[i][k], before_[i][(k + 1) % 3]);
          if (tips.contains(low) && tips.contains(high)) continue;
          pieces.unite(known.try_emplace({low, high}, i).first->second, i);
        }
      const auto holds = [&](std::uint32_t i, Index v) {
        return std::find(before_[i].begin(), before_[i].end(), v) != before_[i].end();
      };
      for (std::size_t s = 1; s < cone.size(); ++s)
        for (std::size_t k = cone[s].size() == 3 ? 2 : 1; k < cone[s].size(); ++k)
          for (std::uint32_t i = 0; i < before_.size(); ++i)
            for (std::uint32_t j = 0; j < before_.size(); ++j) {
              const Index tip = cone[s][k].get<Index>();
              if (surface_.tet[i] != cone[0] || surface_.tet[j] != cone[0] || !holds(i, tip) ||
                  !holds(j, cone[s][0].get<Index>()) || pieces.find(i) != pieces.find(j))
                continue;
              const auto at =
                  std::find(before_[i].begin(), before_[i].end(), tip) - before_[i].begin();
              cone[s][k] = surface_.triangles[i][static_cast<std::size_t>(at)];
              i = j = static_cast<std::uint32_t>(before_.size());
            }
    }
  }

  /// Each crossing lists the vertices that triangles have for it; the first is what it was.
  void name_crossings() {
    for (Json& edge : level_["edges"])
      for (std::size_t n = 2; n < edge.size(); ++n) {
        std::vector<Index> all;
        for (std::size_t k = 2; k < edge[n].size(); ++k) {
          const Index v = edge[n][k].get<Index>();
          all.push_back(v);
          all.insert(all.end(), copies_[v].begin(), copies_[v].end());
        }
        std::erase_if(all, [&](Index v) { return !is_used(v); });
        std::sort(all.begin(), all.end());
        const Index name = edge[n][2].get<Index>();
        if (all.empty()) all = {name};
        for (auto& triangle : surface_.triangles)
          std::replace(triangle.begin(), triangle.end(), all[0], name);
        all[0] = name;
        edge[n].erase(edge[n].begin() + 2, edge[n].end());
        for (const Index v : all) edge[n].push_back(v);
      }
  }

  bool is_used(Index v) const {
    return std::any_of(surface_.triangles.begin(), surface_.triangles.end(),
                       [&](const auto& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
  }

  void number() {
    std::vector<Vector3<double>> points;
    std::vector<Index> named(surface_.points.size(), -1);
    for (const auto& triangle : surface_.triangles)
      for (const Index v : triangle) named[as_size(v)] = 0;
    for (std::size_t v = 0; v < named.size(); ++v)
      if (named[v] == 0)
        named[v] = static_cast<Index>(points.size()), points.push_back(surface_.points[v]);
    surface_.points = std::move(points);
    for (auto& triangle : surface_.triangles)
      for (Index& v : triangle) v = named[as_size(v)];
    const auto rename = [&](Json& v) { v = named[v.get<std::size_t>()]; };
    for (Json& edge : level_["edges"])
      for (std::size_t n = 2; n < edge.size(); ++n)
        for (std::size_t k = 2; k < edge[n].size(); ++k) rename(edge[n][k]);
    for (Json& face : level_["faces"]) {
      for (Json& arc : face[3]) rename(arc[0]), rename(arc[1]);
      for (Json& v : face[4]) rename(v);
    }
    for (Json& tet : level_["tets"])
      for (std::size_t s = 1; s < tet.size(); ++s)
        for (std::size_t l = 1; l < tet[s].size(); ++l)
          for (std::size_t k = 0; k < tet[s][l].size(); k += 2) rename(tet[s][l][k]);
    for (Json& cone : level_["cones"])
      for (std::size_t s = 1; s < cone.size(); ++s)
        for (Json& v : cone[s]) rename(v);
  }

  void count() {
    const SurfaceInvariants known = surface_invariants(surface_);
    std::vector<Index> first(known.parts.size(), static_cast<Index>(surface_.points.size()));
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i)
      for (const Index v : surface_.triangles[i])
        first[as_size(known.component[i])] = std::min(first[as_size(known.component[i])], v);
    Json components = Json::array();
    for (std::size_t c = 0; c < first.size(); ++c)
      components.push_back({{"euler_characteristic", known.parts[c].euler_characteristic},
                            {"boundary_loops", known.parts[c].boundary_loops},
                            {"orientable", true},
                            {"triangles", known.parts[c].triangles},
                            {"first_vertex", first[c]}});
    std::sort(components.begin(), components.end(),
              [](const Json& a, const Json& b) { return a["first_vertex"] < b["first_vertex"]; });
    level_["components"] = components;
    level_["vertices"] = {0, surface_.points.size()};
    level_["triangles"] = {0, surface_.triangles.size()};
    e_.certificate["surface"]["vertices"] = surface_.points.size();
    e_.certificate["surface"]["triangles"] = surface_.triangles.size();
    level_.erase("embedded");  // two vertices may be at one place
    e_.rehash();
  }

  Exhibit& e_;
  Json& level_;
  SurfaceMesh& surface_;
  std::vector<std::array<Index, 3>> before_;  ///< triangles with the vertices that there were
  std::map<Index, std::vector<Index>> copies_;
};

std::vector<Exhibit> honest_ones(Random& random) {
  std::vector<Exhibit> result;
  for (const Exhibit& e : honest_exhibits())
    if (e.certificate["levels"].size() == 1 && e.mesh.tets.size() > 1) result.push_back(e);
  for (const char* mode : {"0", "1/4"}) result.push_back(exhibit(two_tets_at_an_edge(), {mode}));
  for (int i = 0; i < trials(8, 4); ++i) {
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, static_cast<std::uint64_t>(random.integer(0, 1000000)));
    for (auto& tensor : mesh.tensors)
      if (random.integer(0, 3) == 0) tensor = {1, 1, 1, 0, 0, 0};
    result.push_back(exhibit(mesh, {random.integer(0, 1) == 0 ? "0" : "-1/2"}));
  }
  return result;
}

TEST(FewerClaims, AreNotRefuted) {
  Random random(20261127);
  Court court("fewer");
  Compared kept("claims less, triangles kept", 20), cut("claims less, triangles cut", 20);
  for (const Exhibit& honest : honest_ones(random)) {
    const std::string all = court.verdict(honest);
    EXPECT_TRUE(all == "certified" || all == "undecided") << court.report();
    for (int i = 0; i < trials(6, 3); ++i) {
      std::set<Index> out;
      for (Index t = 0; t < static_cast<Index>(honest.mesh.tets.size()); ++t)
        if (random.integer(0, 2) == 0) out.insert(t);
      if (out.empty()) out.insert(0);
      Exhibit less = honest;
      leave_out(less, out);
      EXPECT_EQ(court.verdict(less), "undecided") << court.report();
      ++kept;
      Cut(less, out).run();
      EXPECT_EQ(court.verdict(less), "undecided") << court.report();
      ++cut;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
