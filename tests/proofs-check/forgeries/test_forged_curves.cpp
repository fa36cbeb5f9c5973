// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Every kind of claim about degenerate curves, altered in every way: none passes.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>

#include "curve_exhibit.hpp"
#include "forgery.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// Counts what came of the forgeries of one test. The short suite tries one in two of each kind.
class CurveTrial {
 public:
  explicit CurveTrial(const std::string& name) : court_(name) {}
  ~CurveTrial() {
    EXPECT_GT(tried_, 0u);
    std::cout << tried_ << " forgeries\n";
  }
  void expect(const std::string& verdict, const CurveExhibit& e, const std::string& what) {
    if (!share_.has(what)) return;
    EXPECT_EQ(found(e), verdict) << what << '\n' << court_.report();
  }
  void expect_not_certified(const CurveExhibit& e, const std::string& what) {
    if (!share_.has(what)) return;
    EXPECT_NE(found(e), "certified") << what;
  }

 private:
  std::string found(const CurveExhibit& e) {
    ++tried_;
    return court_.verdict(e.field_text(), e.curve_text(), e.certificate.dump());
  }
  Court court_;
  Share share_{2};
  std::size_t tried_ = 0;
};

using Judge = std::function<void(const Json& level, const std::string& what)>;

/// Each level of each exhibit, to be altered by `forge`, which calls back once for each forgery.
void for_levels(CurveTrial& trial, const std::function<void(const Json&, const Judge&)>& forge) {
  for (const CurveExhibit& honest : honest_curves())
    for (std::size_t l = 0; l < honest.certificate["levels"].size(); ++l)
      forge(honest.certificate["levels"][l], [&](const Json& level, const std::string& what) {
        CurveExhibit forged = honest;
        forged.certificate["levels"][l] = level;
        trial.expect_not_certified(forged, what);
      });
}

/// Steps through a list such that about six of its entries are altered.
std::size_t stride(const Json& list) { return list.size() / 6 + 1; }

/// One entry left out, or given twice.
void alter_entries(const Json& level, const char* list, const Judge& judge) {
  for (std::size_t i = 0; i < level[list].size(); i += stride(level[list])) {
    Json without = level, twice = level;
    without[list].erase(i);
    twice[list].insert(twice[list].begin() + static_cast<std::ptrdiff_t>(i), level[list][i]);
    judge(without, std::string(list) + " without one");
    judge(twice, std::string(list) + " with one twice");
  }
}

TEST(ForgedCurves, HonestOnesAreCertified) {
  CurveTrial trial("honest_curves");
  for (const CurveExhibit& e : honest_curves()) trial.expect("certified", e, "honest");
}

TEST(ForgedCurves, PointsOfFaces) {
  CurveTrial trial("curve_faces");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "faces", judge);
    for (std::size_t f = 0; f < level["faces"].size(); ++f) {
      if (f % stride(level["faces"]) != 0 && level["faces"][f].size() == 4) continue;
      for (std::size_t n = 3; n < level["faces"][f].size(); ++n) {
        const auto forge = [&](const char* what, const auto& alter) {
          Json forged = level;
          alter(forged["faces"][f][n]);
          judge(forged, what);
        };
        for (const std::size_t entry : {1U, 2U})
          for (const int step : {-3, 1000})
            forge("a box moved", [&](Json& p) { p[entry] = p[entry].get<std::int64_t>() + step; });
        forge("a box elsewhere",
              [](Json& p) { std::swap(p[1], p[2]), p[1] = p[1].get<int>() / 2; });
        forge("a wider box elsewhere", [](Json& p) { p[3] = p[3].get<int>() - 1; });
        forge("a narrower box elsewhere", [](Json& p) { p[3] = p[3].get<int>() + 1; });
        forge("a wrong depth", [](Json& p) { p[3] = 61; });
        forge("another vertex", [](Json& p) { p[0] = p[0].get<int>() + 1; });
        forge("no vertex", [](Json& p) { p[0] = 1 << 20; });
        Json without = level, added = level;
        without["faces"][f].erase(n);
        judge(without, "a point dropped");
        Json copy = level["faces"][f][n];
        copy[0] = copy[0].get<int>() + 1;
        added["faces"][f].insert(added["faces"][f].begin() + static_cast<std::ptrdiff_t>(n) + 1,
                                 copy);
        judge(added, "a point added");
      }
      // A wide box around everything holds all points of the face, and may hold just one.
      if (level["faces"][f].size() == 5) {
        Json forged = level;
        for (const std::size_t n : {3U, 4U})
          for (const std::size_t k : {1U, 2U, 3U}) forged["faces"][f][n][k] = 0;
        judge(forged, "all of the face");
        forged = level;
        std::swap(forged["faces"][f][3][0], forged["faces"][f][4][0]);
        judge(forged, "vertices exchanged");
      }
    }
  });
}

TEST(ForgedCurves, PiecesInTetrahedra) {
  CurveTrial trial("curve_tets");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "tets", judge);
    for (std::size_t t = 0; t < level["tets"].size(); t += stride(level["tets"])) {
      const Json& tet = level["tets"][t];
      for (std::size_t n = 1; n < tet.size(); ++n) {
        Json forged = level;
        forged["tets"][t].erase(n);
        judge(forged, "a piece dropped");
        for (const std::size_t end : {0U, 1U})
          for (const int step : {-1, 1}) {
            forged = level;
            Json& v = forged["tets"][t][n][end];
            v = std::abs(v.get<int>() + step);
            judge(forged, "a piece that ends elsewhere");
          }
      }
      if (tet.size() == 3) {  // rejoined in both ways
        for (const std::size_t end : {0U, 1U}) {
          Json forged = level;
          Json& pieces = forged["tets"][t];
          std::swap(pieces[1][1], pieces[2][end]);
          for (Json* piece : {&pieces[1], &pieces[2]})
            if ((*piece)[0] > (*piece)[1]) std::swap((*piece)[0], (*piece)[1]);
          if (pieces[1] > pieces[2]) std::swap(pieces[1], pieces[2]);
          judge(forged, "pieces rejoined");
        }
      }
    }
  });
}

TEST(ForgedCurves, Components) {
  CurveTrial trial("curve_components");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    alter_entries(level, "curves", judge);
    for (std::size_t i = 0; i < level["curves"].size(); ++i) {
      Json forged = level;
      Json& closed = forged["curves"][i]["closed"];
      closed = !closed.get<bool>();
      judge(forged, "closed or not");
      for (const char* key : {"lines", "first_vertex"}) {
        forged = level;
        forged["curves"][i][key] = level["curves"][i][key].get<int>() + 1;
        judge(forged, key);
      }
      forged = level;
      Json other = level["curves"][i];
      if (other["lines"].get<int>() < 2) continue;
      forged["curves"][i]["lines"] = other["lines"].get<int>() - 1;
      other["lines"] = 1, other["first_vertex"] = other["first_vertex"].get<int>() + 1;
      forged["curves"].insert(forged["curves"].begin() + static_cast<std::ptrdiff_t>(i) + 1, other);
      judge(forged, "one in two");
    }
  });
}

TEST(ForgedCurves, LevelsAndWhatIsLeftOut) {
  CurveTrial trial("curve_levels");
  for_levels(trial, [](const Json& level, const Judge& judge) {
    const auto forge = [&](const char* what, const auto& alter) {
      Json forged = level;
      alter(forged);
      judge(forged, what);
    };
    forge("the other mode", [](Json& l) { l["mode"] = l["mode"] == "1" ? "-1" : "1"; });
    for (const char* mode : {"1/2", "0", "2", "-2", "1/1", "", "+1"})
      forge("another mode", [&](Json& l) { l["mode"] = mode; });
    for (const char* range : {"vertices", "lines"})
      for (const std::size_t end : {0U, 1U})
        forge("another range", [&](Json& l) { l[range][end] = l[range][end].get<int>() + 1; });
    forge("left out", [](Json& l) {
      l["undecided"].push_back({l["tets"][0][0], "neutral_characteristic"});
    });
    forge("left out with its claims", [](Json& l) {
      l["undecided"].push_back({l["tets"][0][0], "points_not_told_apart"});
      l["tets"].erase(0);
    });
    forge("left out, not there", [](Json& l) {
      l["undecided"].push_back({1000, "degenerate_point_on_edge"});
    });
    forge("a reason of surfaces", [](Json& l) {
      l["undecided"].push_back({l["tets"][0][0], "critical_value_in_cell"});
    });
    for (const char* key : {"faces", "tets", "curves", "undecided", "mode", "lines"})
      forge("without a key", [&](Json& l) { l.erase(key); });
    forge("with another key", [](Json& l) { l["edges"] = Json::array(); });
  });
}

/// With hashes that fit.
TEST(ForgedCurves, Polylines) {
  CurveTrial trial("curve_lines");
  for (const CurveExhibit& honest : honest_curves()) {
    const auto forge = [&](const char* what, const auto& alter) {
      CurveExhibit forged = honest;
      alter(forged.curves);
      forged.rehash();
      trial.expect_not_certified(forged, what);
    };
    for (std::size_t l = 0; l < honest.curves.lines.size();
         l += honest.curves.lines.size() / 6 + 1) {
      const auto& line = honest.curves.lines[l];
      const auto at = [](CurveMesh::Index v) { return static_cast<std::size_t>(v); };
      for (const auto end : {line.front(), line.back()})
        for (const double step : {1e-9, -1e-3})
          forge("a point of a face moved", [&](CurveMesh& c) { c.points[at(end)].y += step; });
      forge("in another tetrahedron", [&](CurveMesh& c) { c.tet[l] = (c.tet[l] + 1) % 6; });
      forge("another component", [&](CurveMesh& c) { ++c.component[l]; });
      forge("another mode", [&](CurveMesh& c) { c.mode[at(line[0])] *= 0.75; });
      if (line.size() == 2) continue;
      forge("a sample elsewhere", [&](CurveMesh& c) { c.points[at(line[1])].z += 1.5; });
      forge("a sample left out", [&](CurveMesh& c) { c.lines[l].erase(c.lines[l].begin() + 1); });
      forge("ends in a sample", [&](CurveMesh& c) { c.lines[l].pop_back(); });
      forge("a sample twice",
            [&](CurveMesh& c) { c.lines[l].insert(c.lines[l].begin(), line[1]); });
    }
    if (honest.curves.lines.size() > 1)
      forge("ends exchanged", [&](CurveMesh& c) { std::swap(c.lines[0][0], c.lines[1][0]); });
  }
}

/// Without hashes that fit, and with: curves of another field.
TEST(ForgedCurves, Inputs) {
  CurveTrial trial("curve_inputs");
  for (const CurveExhibit& honest : honest_curves()) {
    CurveExhibit forged = honest;
    forged.mesh.tensors[0].xy = std::nextafter(forged.mesh.tensors[0].xy, 2);
    trial.expect("refuted", forged, "one bit of a tensor");
    forged = honest;
    for (auto& t : forged.mesh.tensors) t = -1.0 * t;
    forged.rehash();
    trial.expect("refuted", forged, "opposite signs");
    forged = honest;
    for (auto& t : forged.mesh.tensors) std::swap(t.xx, t.yy), std::swap(t.yz, t.xz);
    forged.rehash();
    trial.expect("certified", forged, "turned tensors have the same curves");
    for (auto& t : forged.mesh.tensors) t.xx += 0.5;
    forged.rehash();
    trial.expect("refuted", forged, "other tensors");
  }
}

}  // namespace
}  // namespace tensortopo::test
