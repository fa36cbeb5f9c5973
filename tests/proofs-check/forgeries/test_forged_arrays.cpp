// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Arrays of the surface's file besides its geometry: no number of them can be altered unseen.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "forgery_trial.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

/// Of two modes, and of an invariant with two values.
const std::vector<Exhibit>& exhibits_with_arrays() {
  static const std::vector<Exhibit> all = [] {
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, 5);
    return std::vector<Exhibit>{exhibit_with_arrays(mesh, {"1/4", "-9/10"}),
                                exhibit_with_arrays(mesh, {"anisotropy 4/5", "anisotropy 9/10"})};
  }();
  return all;
}

/// Calls back with each exhibit and the position of each of its arrays.
template <class Forge>
void for_arrays(const Forge& forge) {
  for (const Exhibit& e : exhibits_with_arrays())
    for (std::size_t i = 0; i < e.arrays.size(); ++i) forge(e, i);
}

TEST(ForgedArrays, HonestOnesAreCertified) {
  Court court("arrays");
  std::size_t count = 0;
  for (const Exhibit& e : exhibits_with_arrays()) {
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    EXPECT_NE(court.report().find("arrays: "), std::string::npos);
    count += e.arrays.size();
  }
  // mode, two eigenvectors, normal, residual, component; value, normal, residual, component.
  EXPECT_EQ(count, 10u);
}

TEST(ForgedArrays, OneNumber) {
  Court court("array_number");
  for_arrays([&](const Exhibit& e, std::size_t i) {
    const std::size_t size = e.arrays[i].numbers.size();
    for (const std::size_t k : {std::size_t{0}, size / 2, size - 1}) {
      Exhibit forged = e;
      double& x = forged.arrays[i].numbers[k];
      x = e.arrays[i].type == "Int32" ? x + 1 : std::nextafter(x, 2);
      EXPECT_EQ(court.verdict(forged), "refuted") << e.arrays[i].name;
      EXPECT_NE(court.report().find("array '" + e.arrays[i].name + "' of the " + e.arrays[i].of),
                std::string::npos)
          << court.report();
    }
  });
}

TEST(ForgedArrays, RemovedAddedRenamedReordered) {
  Trial trial("array_names");
  for_arrays([&](const Exhibit& e, std::size_t i) {
    const std::string& name = e.arrays[i].name;
    Exhibit forged = e;
    forged.arrays.erase(forged.arrays.begin() + static_cast<std::ptrdiff_t>(i));
    trial.expect("refuted", forged, name + " removed");
    forged = e;
    forged.arrays.push_back(e.arrays[i]);
    forged.arrays.back().name += "2";
    trial.expect("refuted", forged, name + " added");
    forged.arrays.back().name = name;
    trial.expect("malformed", forged, name + " twice");
    forged = e;
    forged.arrays[i].name[0] = 'M';
    trial.expect("refuted", forged, name + " renamed");
    forged = e;
    forged.arrays[i].numbers.pop_back();
    trial.expect("malformed", forged, name + " without its last number");
    forged = e;
    forged.arrays[i].numbers[0] = std::numeric_limits<double>::infinity();
    trial.expect("malformed", forged, name + " not finite");
  });
  Exhibit forged = exhibits_with_arrays()[0];
  std::swap(forged.arrays[1].name, forged.arrays[2].name);
  trial.expect("refuted", forged, "eigenvectors exchanged");
  forged = exhibits_with_arrays()[0];
  std::swap(forged.arrays[1], forged.arrays[2]);
  trial.expect("certified", forged, "the file has them in another order");
}

TEST(ForgedArrays, TheCertificatesHashes) {
  Trial trial("array_hashes");
  for (const Exhibit& e : exhibits_with_arrays()) {
    const Json& hashes = e.certificate["surface"]["arrays"];
    for (std::size_t i = 0; i < hashes.size(); ++i) {
      const auto forge = [&](const std::string& verdict, const char* what, const auto& alter) {
        Exhibit forged = e;
        alter(forged.certificate["surface"]["arrays"]);
        trial.expect(verdict, forged, what);
      };
      forge("refuted", "without one", [&](Json& list) { list.erase(i); });
      forge("malformed", "twice", [&](Json& list) { list.insert(list.begin(), list[i]); });
      forge("refuted", "hash", [&](Json& list) { list[i][3] = std::string(64, '0'); });
      forge("refuted", "components", [&](Json& list) { list[i][2] = 4; });
      forge("refuted", "name",
            [&](Json& list) { list[i][1] = list[i][1].get<std::string>() + "0"; });
      forge("malformed", "no text", [&](Json& list) { list[i][1] = 1; });
    }
  }
}

/// A certificate of before says nothing of arrays, and is no proof of any.
TEST(ForgedArrays, WithoutHashesTheyAreOpen) {
  Court court("array_open");
  for (Exhibit e : exhibits_with_arrays()) {
    e.certificate["surface"].erase("arrays");
    EXPECT_EQ(court.verdict(e), "undecided");
    EXPECT_NE(court.report().find("not bound"), std::string::npos) << court.report();
    EXPECT_NE(court.report().find(" 0 refuted, 1 undecided"), std::string::npos);
    e.arrays.clear();
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
  }
}

/// Hashes that fit do not help: what they are of is derived, and the place is said.
TEST(ForgedArrays, ModesValuesAndComponentsAreDerived) {
  Court court("array_claims");
  const auto expect_refuted = [&](Exhibit& forged, const std::string& place) {
    forged.rehash();
    EXPECT_EQ(court.verdict(forged), "refuted");
    EXPECT_NE(court.report().find("refuted: " + place + ": "), std::string::npos) << place << '\n'
                                                                                  << court.report();
  };
  for (const Exhibit& e : exhibits_with_arrays()) {
    Exhibit forged = e;
    auto& numbers = e.surface.mode.empty() ? forged.surface.value : forged.surface.mode;
    const std::string name = e.surface.mode.empty() ? "value" : "mode";
    const std::size_t v = numbers.size() - 3;
    numbers[v] = std::nextafter(numbers[v], -2);
    expect_refuted(forged, name + " at vertex " + std::to_string(v));
    for (const std::size_t t : {std::size_t{0}, forged.surface.triangles.size() - 1}) {
      forged = e;
      forged.surface.component[t] += 1;
      expect_refuted(forged, "component of triangle " + std::to_string(t));
    }
    forged = e;  // all of them in one
    std::fill(forged.surface.component.begin(), forged.surface.component.end(), 0);
    forged.rehash();
    EXPECT_EQ(court.verdict(forged), "refuted");
  }
  // An array of modes beside levels of another invariant.
  Exhibit forged = exhibits_with_arrays()[1];
  forged.surface.mode = forged.surface.value;
  expect_refuted(forged, "mode at vertex 0");
}

/// Of the residual the hash says only that it is what was written.
TEST(ForgedArrays, TheResidualIsBoundButNotProved) {
  Court court("array_bound");
  Exhibit e = exhibits_with_arrays()[0];
  e.surface.residual[0] = 1;
  e.rehash();
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
}

TEST(ForgedArrays, NormalsAreDerived) {
  Court court("array_normal");
  std::vector<Exhibit> all = exhibits_with_arrays();
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 5);
  for (const char* level : {"magnitude 2", "deviator-magnitude 3/2"})
    all.push_back(exhibit_with_arrays(mesh, {level}));
  for (const Exhibit& honest : all) {
    EXPECT_EQ(court.verdict(honest), "certified") << court.report();
    EXPECT_NE(court.report().find("normal shown at "), std::string::npos) << court.report();
    EXPECT_NE(court.report().find("not derived: 'residual'\n"), std::string::npos)
        << court.report();
    const std::size_t v = honest.surface.points.size() / 2;
    const Vector3<double> n = honest.surface.normal[v];
    const Vector3<double> across = unit(cross(n, Vector3<double>{n.y, n.z, -n.x}));
    for (const Vector3<double>& other : {-1.0 * n, across, unit(n + 0.2 * across), 2.0 * n}) {
      Exhibit e = honest;
      e.surface.normal[v] = other;
      e.rehash();
      EXPECT_EQ(court.verdict(e), "refuted");
      EXPECT_NE(court.report().find("normal at vertex " + std::to_string(v)), std::string::npos)
          << court.report();
    }
  }
}

/// The zero vector says nothing, and is not counted as shown.
TEST(ForgedArrays, ZeroVectorsAreNotShown) {
  Court court("array_zero");
  for (Exhibit e : exhibits_with_arrays()) {
    std::fill(e.surface.normal.begin(), e.surface.normal.end(), Vector3<double>{});
    e.rehash();
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    EXPECT_NE(court.report().find("normal shown at 0 of "), std::string::npos) << court.report();
  }
}

/// Names are shown such that they are seen as they are, and on one line.
TEST(ForgedArrays, NamesDoNotWriteIntoTheVerdict) {
  Court court("array_names_shown");
  for (const std::string name : {"x&#10;certified: 9 claims", "x\xe2\x80\xae", "x\xef\xbb\xbf"}) {
    Exhibit e = exhibits_with_arrays()[0];
    e.in_surface.push_back({"Name=\"residual\"", "Name=\"" + name + "\""});
    EXPECT_EQ(court.verdict(e), "refuted");
    EXPECT_NE(court.report().find(" 'x?"), std::string::npos) << court.report();
    EXPECT_EQ(court.report().find("\ncertified: 9"), std::string::npos) << court.report();
  }
}

/// Tensors of nine components that are not symmetric: what is certified is of another field than a
/// reader of the file may think.
TEST(ForgedArrays, SymmetrizedTensorsAreCounted) {
  Court court("symmetrized");
  Exhibit e = exhibits_with_arrays()[0];
  e.certificate["input"]["components"] = "full";
  std::string old = "NumberOfComponents=\"6\" format=\"ascii\">", text = old;
  text[text.find('6')] = '9';
  for (std::size_t v = 0; v < e.mesh.tensors.size(); ++v) {
    const auto& t = e.mesh.tensors[v];
    const double off = v < 2 ? 0.5 : 0;  // exact
    auto& xy = e.mesh.tensors[v].xy;
    xy = std::ldexp(std::round(std::ldexp(t.xy, 20)), -20);
    for (const double x : {t.xx, xy + off, t.xz, xy - off, t.yy, t.yz, t.xz, t.yz, t.zz})
      text += Json(x).dump() + ' ';
  }
  e = exhibit_with_arrays(e.mesh, {"1/4", "-9/10"});
  e.certificate["input"]["components"] = "full";
  const std::string field = e.field_text();
  const std::size_t first = field.find(old), end = field.find("</DataArray>", first);
  e.in_field.push_back({field.substr(first, end - first), text, true});
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
  EXPECT_NE(court.report().find(", 2 tensors symmetrized"), std::string::npos) << court.report();
}

}  // namespace
}  // namespace tensortopo::test
