// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Every kind of claim, surface and field, altered in the ways that an error or a forger would.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <utility>

#include "forgery_trial.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::test {
namespace {

TEST(Forgeries, HonestExhibitsAreCertified) {
  Court court("honest");
  ASSERT_GE(honest_exhibits().size(), 4u);
  for (const Exhibit& e : honest_exhibits()) {
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    EXPECT_FALSE(e.surface.triangles.empty());
  }
}

TEST(Forgeries, Crossings) {
  Trial trial("crossings");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "edges", judge);
    for (std::size_t e = 0; e < level["edges"].size(); ++e) {
      for (std::size_t k = 2; k < level["edges"][e].size(); ++k) {
        Json forged = level;
        forged["edges"][e].erase(k);
        judge(forged, "crossing left out");
        forged = level;
        forged["edges"][e].push_back(level["edges"][e][k]);
        judge(forged, "crossing doubled");
        const Json& next = level["edges"][(e + 1) % level["edges"].size()];
        if (next[2][2] != level["edges"][e][k][2]) {
          forged = level;
          std::swap(forged["edges"][e][k][2],
                    forged["edges"][(e + 1) % level["edges"].size()][2][2]);
          judge(forged, "vertices exchanged");
        }
        if (level["edges"][e][k][0].is_string()) continue;
        for (const std::int64_t step : {-1, 1}) {
          forged = level;
          Json& i = forged["edges"][e][k][0];
          i = i.get<std::int64_t>() + step;
          judge(forged, "crossing in the interval beside");
        }
      }
    }
  });
}

TEST(Forgeries, Curves) {
  Trial trial("curves");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "faces", judge);
    for (std::size_t f = 0; f < level["faces"].size(); ++f) {
      const Json& arcs = level["faces"][f][3];
      for (const std::size_t list : {3u, 4u}) {
        for (std::size_t i = 0; i < level["faces"][f][list].size(); ++i) {
          Json forged = level;
          forged["faces"][f][list].erase(i);
          judge(forged, "curve left out");
          forged = level;
          if (list == 4) {
            forged["faces"][f][4][i] = forged["faces"][f][4][i].get<int>() + 1;
          } else {
            forged["faces"][f][3][i][1] = forged["faces"][f][3][i][1].get<int>() + 1;
          }
          judge(forged, "curve of another vertex");
        }
      }
      for (std::size_t i = 1; i < arcs.size(); ++i) {
        for (const std::size_t end : {0u, 1u}) {
          Json forged = level;
          Json& found = forged["faces"][f][3];
          std::swap(found[0][1], found[i][end]);
          for (Json& arc : found)
            if (arc[0] > arc[1]) std::swap(arc[0], arc[1]);
          std::sort(found.begin(), found.end());
          judge(forged, "arcs that exchange ends");
        }
      }
      Json forged = level;
      forged["faces"][f][4] = level["faces"][f][4];
      forged["faces"][f][4].push_back(level["vertices"][0].get<int>() +
                                      level["vertices"][1].get<int>() - 1);
      judge(forged, "a closed curve more");
    }
  });
}

TEST(Forgeries, Sheets) {
  Trial trial("sheets");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "tets", judge);
    for (std::size_t t = 0; t < level["tets"].size(); ++t) {
      const Json& tet = level["tets"][t];
      for (std::size_t s = 1; s < tet.size(); ++s) {
        const auto forge = [&](const std::string& what, const std::function<void(Json&)>& change) {
          Json forged = level;
          change(forged["tets"][t]);
          if (forged != level) judge(forged, what);
        };
        for (const int step : {-2, -1, 1, 2})
          forge("Euler characteristic", [&](Json& x) { x[s][0] = x[s][0].get<int>() + step; });
        forge("sheet left out", [&](Json& x) { x.erase(s); });
        forge("sheet doubled", [&](Json& x) { x.push_back(tet[s]); });
        if (s + 1 < tet.size())
          forge("sheets merged", [&](Json& x) {
            for (std::size_t l = 1; l < tet[s + 1].size(); ++l) x[s].push_back(tet[s + 1][l]);
            std::sort(x[s].begin() + 1, x[s].end());
            x[s][0] = x[s][0].get<int>() + x[s + 1][0].get<int>() - 2;
            x.erase(s + 1);
          });
        for (std::size_t l = 1; l < tet[s].size(); ++l) {
          if (tet[s].size() > 2)
            forge("sheet split", [&](Json& x) {
              x[s].erase(l);
              x.push_back({1, tet[s][l]});
              std::sort(x.begin() + 1, x.end(),
                        [](const Json& a, const Json& b) { return a[1][0] < b[1][0]; });
            });
          forge("loop left out", [&](Json& x) { x[s].erase(l); });
          forge("face of an arc", [&](Json& x) { x[s][l][1] = x[s][l][1] == 0 ? 1 : 0; });
          // A closed curve has no direction to claim.
          if (tet[s][l].size() < 4) continue;
          forge("loop reversed",
                [&](Json& x) { std::reverse(x[s][l].begin() + 1, x[s][l].end()); });
          forge("loop from elsewhere",
                [&](Json& x) { std::rotate(x[s][l].begin(), x[s][l].begin() + 2, x[s][l].end()); });
        }
      }
    }
  });
}

TEST(Forgeries, ComponentsModesAndCounts) {
  Trial trial("components");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "components", judge);
    for (std::size_t i = 0; i < level["components"].size(); ++i) {
      for (const char* key :
           {"euler_characteristic", "boundary_loops", "triangles", "first_vertex"})
        for (const int step : {-2, -1, 1, 2}) {
          Json forged = level;
          forged["components"][i][key] = forged["components"][i][key].get<int>() + step;
          judge(forged, key);
        }
      Json forged = level;
      forged["components"][i]["orientable"] = false;
      judge(forged, "orientable");
    }
    for (const char* key : {"vertices", "triangles"})
      for (const std::size_t which : {0u, 1u})
        for (const int step : {-1, 1}) {
          Json forged = level;
          forged[key][which] = forged[key][which].get<int>() + step;
          judge(forged, "ranges");
        }
    Json forged = level;
    forged["on_level"] = level["on_level"].get<int>() + 1;
    judge(forged, "on_level");
    for (const Json& tet : level["tets"]) {
      forged = level;
      forged["undecided"].push_back({tet[0], "budget_exhausted"});
      judge(forged, "undecided, but with claims");
      forged["tets"].erase(std::find(forged["tets"].begin(), forged["tets"].end(), tet));
      judge(forged, "undecided without being so");
      forged = level;
      forged["undecided"].push_back({1000000, "zero_deviator_inside"});
      judge(forged, "undecided, and not there");
    }
  });
}

/// Another mode has other crossings. If it is so near that the intervals hold those as well, all
/// claims may hold for it, too; at a vertex that is on the level there is no such mode.
TEST(Forgeries, OtherModes) {
  Trial trial("modes");
  for (Exhibit e : honest_exhibits()) {
    Json& level = e.certificate["levels"][0];
    if (!level.contains("mode")) continue;
    const std::string mode = level["mode"];
    const std::string other = mode == "0"                ? "1/10000"
                              : mode == "1/4"            ? "2501/10000"
                              : mode.substr(0, 1) == "-" ? mode.substr(1)
                                                         : "-" + mode;
    level["mode"] = other;
    trial.expect_not_certified(e, mode + " as " + other);
  }
  // A vertex with mode exactly 0: no change of mode or tensor is too small.
  const TetTensors tensors{
      {{1, 0, -1, 0, 0, 0}, {2, 1, 1, 0, 0, 0}, {2, 1, 0.5, 0, 0, 0}, {1, 1, -3, 0, 0, 0}}};
  const TetMesh mesh = reference_tet_mesh(tensors);
  const Exhibit honest = exhibit(mesh, {"0"});
  ASSERT_EQ(honest.certificate["levels"][0]["on_level"], 1);
  trial.expect("certified", honest, "honest");
  Exhibit forged = honest;
  forged.certificate["levels"][0]["mode"] = "1/1000000000000000000000000000000";
  trial.expect("refuted", forged, "mode off by 1e-30");
  forged = honest;
  forged.mesh.tensors[0].yy = std::numeric_limits<double>::denorm_min();
  trial.expect("refuted", forged, "smallest change of the field");
  forged.rehash();
  trial.expect("refuted", forged, "smallest change of the field, hashed");
}

/// Is it a tip of the first level, or half-way between two, which stay where they are?
bool is_apex(const Exhibit& e, std::size_t v) {
  for (const Json& cone : e.certificate["levels"][0]["cones"])
    for (std::size_t s = 1; s < cone.size(); ++s)
      for (std::size_t k = cone[s].size() == 3 ? 2 : 1; k < cone[s].size(); ++k)
        if (cone[s][k] == v) return true;
  return false;
}

TEST(Forgeries, Distances) {
  Trial trial("distances");
  for (const Exhibit& honest : honest_exhibits()) {
    const auto forge = [&](const std::string& verdict, const std::string& what,
                           const std::function<void(Json&)>& change) {
      Exhibit forged = honest;
      change(forged.certificate["levels"][0]["distance"]);
      if (forged.certificate != honest.certificate) trial.expect(verdict, forged, what);
    };
    const Json& truth = honest.certificate["levels"][0]["distance"];
    const bool all_coarse = truth["bound"] == "0x0p+0";
    if (!all_coarse)
      forge("refuted", "bound halved", [&](Json& d) {
        const double bound = std::strtod(d["bound"].get<std::string>().c_str(), nullptr);
        std::ostringstream half;
        half << std::hexfloat << bound / 2;
        d["bound"] = half.str();
      });
    if (!truth["coarse"].empty())
      forge("refuted", "coarse bound", [](Json& d) { d["coarse_bound"] = "0x1p-40"; });
    forge("refuted", "reach left out", [](Json& d) { d["reach"].erase(0); });
    forge("refuted", "reach too many", [](Json& d) { d["reach"].push_back(0); });
    forge("refuted", "no such tetrahedron", [](Json& d) { d["coarse"].push_back(1000000); });
    Share share(4);
    for (std::size_t v = 0; v < truth["reach"].size() && !all_coarse; ++v) {
      if (!share.has("reach")) continue;
      Exhibit forged = honest;
      forged.certificate["levels"][0]["distance"]["reach"][v] = 4000;
      Court court("reach");
      const bool is_used = court.verdict(forged) != "certified";
      if (truth["coarse"].empty() && !is_apex(honest, v)) {
        EXPECT_TRUE(is_used) << "reach beyond the tetrahedron";
      }
    }
  }
  // A plane that the triangles hit is left by any reach; this level is curved.
  Exhibit forged = honest_exhibits()[1];
  for (Json& n : forged.certificate["levels"][0]["distance"]["reach"]) n = n.get<int>() - 80;
  trial.expect("undecided", forged, "all reaches reduced");
}

TEST(Forgeries, Triangles) {
  Trial trial("triangles");
  for (const Exhibit& honest : honest_exhibits()) {
    const auto forge = [&](const std::string& what,
                           const std::function<void(SurfaceMesh&)>& change) {
      Exhibit forged = honest;
      change(forged.surface);
      if (forged.surface.triangles == honest.surface.triangles &&
          forged.surface.tet == honest.surface.tet && what.substr(0, 5) != "moved")
        return;
      trial.expect_not_certified(forged, what + ", not hashed");
      forged.rehash();
      trial.expect_not_certified(forged, what);
    };
    const SurfaceMesh& s = honest.surface;
    const std::size_t count = s.triangles.size(), step = count / 12 + 1;
    for (std::size_t t = 0; t < count; t += step) {
      forge("flipped", [&](SurfaceMesh& x) { std::swap(x.triangles[t][0], x.triangles[t][1]); });
      forge("removed", [&](SurfaceMesh& x) {
        x.triangles.erase(x.triangles.begin() + static_cast<std::ptrdiff_t>(t));
        x.tet.erase(x.tet.begin() + static_cast<std::ptrdiff_t>(t));
      });
      forge("doubled", [&](SurfaceMesh& x) {
        x.triangles.push_back(x.triangles[t]), x.tet.push_back(x.tet[t]);
      });
      forge("with another corner",
            [&](SurfaceMesh& x) { x.triangles[t][2] = x.triangles[(t + count / 2) % count][0]; });
      if (honest.mesh.tets.size() > 1)
        forge("in another tetrahedron", [&](SurfaceMesh& x) { x.tet[t] = x.tet[t] == 0 ? 1 : 0; });
    }
    const bool has_distance = honest.certificate["levels"][0]["distance"]["coarse"].empty();
    for (std::size_t v = 0; v < s.points.size(); v += s.points.size() / 12 + 1) {
      forge("vertices merged", [&](SurfaceMesh& x) {
        const auto other =
            x.triangles[0][0] == static_cast<int>(v) ? x.triangles[0][1] : x.triangles[0][0];
        for (auto& triangle : x.triangles)
          for (auto& corner : triangle)
            if (corner == static_cast<int>(v)) corner = other;
      });
      if (!has_distance) continue;
      const double bound = std::strtod(
          honest.certificate["levels"][0]["distance"]["bound"].get<std::string>().c_str(), nullptr);
      if (v < honest.certificate["levels"][0]["vertices"][1].get<std::size_t>())
        forge("moved by more than the bound",
              [&](SurfaceMesh& x) { x.points[v].x += 2.5 * bound, x.points[v].y += 2.5 * bound; });
    }
  }
}

TEST(Forgeries, Fields) {
  Trial trial("fields");
  for (const Exhibit& honest : honest_exhibits()) {
    for (std::size_t v = 0; v < honest.mesh.points.size(); v += 3) {
      for (const auto entry : {&SymmetricTensor<double>::xx, &SymmetricTensor<double>::yy,
                               &SymmetricTensor<double>::zz, &SymmetricTensor<double>::xy,
                               &SymmetricTensor<double>::yz, &SymmetricTensor<double>::xz}) {
        Exhibit forged = honest;
        double& x = forged.mesh.tensors[v].*entry;
        x = std::nextafter(x, HUGE_VAL);
        trial.expect("refuted", forged, "tensor off by an ulp");
      }
      Exhibit forged = honest;
      double& z = forged.mesh.points[v].z;
      z = std::nextafter(z, HUGE_VAL);
      trial.expect("refuted", forged, "point off by an ulp");
      forged = honest;
      auto& t = forged.mesh.tensors[v];
      if (deviator(t) == Deviator<double>{}) continue;  // so is its negative
      // That has the same magnitude.
      const bool is_mode = honest.certificate["levels"][0].contains("mode");
      t = is_mode ? SymmetricTensor<double>{-t.xx, -t.yy, -t.zz, -t.xy, -t.yz, -t.xz}
                  : SymmetricTensor<double>{};
      forged.rehash();
      trial.expect_not_certified(forged, "tensor with the other sign, or zero, hashed");
    }
    for (std::size_t t = 1; t < honest.mesh.tets.size(); t += 5) {
      Exhibit forged = honest;
      std::swap(forged.mesh.tets[0], forged.mesh.tets[t]);
      trial.expect("refuted", forged, "tetrahedra exchanged");
      forged.rehash();
      trial.expect_not_certified(forged, "tetrahedra exchanged, hashed");
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
