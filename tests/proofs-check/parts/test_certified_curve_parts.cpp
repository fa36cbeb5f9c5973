// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The library's degenerate curves in parts, and certificates of parts, against the checker; forged
// parts are not certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "partition/pieces_of_curves.hpp"
#include "proofs-check/forgeries/curve_exhibit.hpp"
#include "proofs-check/parts/parts_in_files.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

const char* mode_of_kind(Degeneracy kind) { return kind == Degeneracy::linear ? "1" : "-1"; }

/// The curves that a piece has in a part's mesh.
CurveExhibit part_of_curves(const PartMesh& own, const PieceCurves& piece) {
  CurveExhibit part;
  part.mesh = own.mesh;
  const MergedCurves merged =
      merge_curve_pieces(std::array{restrict_piece(piece, own.numbers)});
  const CertifiedCurves claims = certify(merged);
  part.curves = merged.curves;
  CertificateSubject subject;
  subject.tensor = "stress", subject.components = "vtk";
  subject.points = part.mesh.points.size(), subject.tetrahedra = part.mesh.tets.size();
  subject.vertices = part.curves.points.size(), subject.cells = part.curves.lines.size();
  part.certificate = Json::parse(
      certificate_bytes(subject, std::span(&claims, 1), merged.cells, CertificateEncoding::json));
  part.rehash();
  return part;
}

/// A field in parts, and numbers of its whole curves.
struct CurveParts {
  Degeneracy kind;
  std::vector<CurveExhibit> parts;
  Json whole;

  certificate::Report check() const {
    PartFiles files("curve-parts", "polylines", mode_of_kind(kind));
    for (const CurveExhibit& part : parts)
      files.add(part.field_text(), part.curve_text(), part.certificate.dump());
    return files.check(whole);
  }
};

CurveParts parts_of_field(const TetMesh& mesh, const std::vector<std::int32_t>& owner, int parts,
                          Degeneracy kind, Random& random) {
  CurveParts result{kind, {}, {}};
  const auto pieces = curve_pieces(mesh, owner, parts, kind);
  for (int p = 0; p < parts; ++p) {
    const PartMesh own = part_mesh(mesh, owner, p, random);
    if (!own.mesh.tets.empty()) result.parts.push_back(part_of_curves(own, pieces[as_size(p)]));
  }
  const MergedCurves merged = merge_curve_pieces(pieces);
  const CurveInvariants known = curve_invariants(merged.curves);
  result.whole = {{"tetrahedra", mesh.tets.size()},
                  {"vertices", known.vertices},
                  {"lines", merged.curves.lines.size()},
                  {"components", known.components},
                  {"closed_components", known.closed_components}};
  return result;
}

TetMesh random_mesh(std::uint64_t seed, Random& random) {
  TetMesh mesh = cube_mesh(random.integer(1, 3));
  if (random.integer(0, 1) == 0)
    fill_with_normal_tensors(mesh, seed);
  else
    fill_with_smooth_tensors(mesh, seed);
  mesh.cell_ids.resize(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids[t] = static_cast<std::int64_t>(t);
  return mesh;
}

/// A face, or a place, by the bits of its corners.
using PlaceKey = std::vector<std::array<double, 3>>;

PlaceKey place_key(std::vector<Vector3<double>> points) {
  PlaceKey key;
  for (const auto& p : points) key.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  std::sort(key.begin(), key.end());
  return key;
}

/// How many points each face of a part has, by the face's corners.
std::map<PlaceKey, std::size_t> points_of_faces(const CurveExhibit& part) {
  std::map<PlaceKey, std::size_t> result;
  for (const Json& face : part.certificate["levels"][0]["faces"]) {
    std::vector<Vector3<double>> corners;
    for (std::size_t i = 0; i < 3; ++i) corners.push_back(part.mesh.points[face[i].get<std::size_t>()]);
    result[place_key(corners)] = face.size() - 3;
  }
  return result;
}

/// The numbers of points of faces that two parts have.
std::vector<std::size_t> points_on_seams(const CurveParts& all) {
  std::map<PlaceKey, std::size_t> seen;
  std::vector<std::size_t> result;
  for (const CurveExhibit& part : all.parts)
    for (const auto& [face, points] : points_of_faces(part))
      if (!seen.try_emplace(face, points).second) result.push_back(points);
  return result;
}

TEST(CertifiedCurveParts, AreWhatTheWholeIs) {
  std::size_t certified = 0, lines = 0, on_seams = 0, several = 0;
  const int fields = trials(24);
  for (int i = 0; i < fields; ++i) {
    const auto seed = 20261201u + static_cast<std::uint64_t>(i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TetMesh mesh = random_mesh(seed, random);
    const int count = random.integer(2, 4);
    const auto owner = owners_of_kind(random.integer(0, 2), mesh, count, random);
    const CurveParts parts = parts_of_field(mesh, owner, count, kDegeneracies[as_size(i % 2)], random);
    const auto report = parts.check();
    ASSERT_EQ(report.status(), "certified") << to_text(report);
    ++certified;
    lines += parts.whole["lines"].get<std::size_t>();
    for (const std::size_t points : points_on_seams(parts)) ++on_seams, several += points > 1;
    const std::string key = std::next(parts.whole.items().begin(), i % 5).key();
    CurveParts other = parts;
    other.whole[key] = other.whole[key].get<int>() + 1;
    EXPECT_EQ(other.check().refuted, 1u) << key;
  }
  EXPECT_EQ(certified, as_size(fields));
  EXPECT_GE(lines, 15 * as_size(fields));
  EXPECT_GE(on_seams, 3 * as_size(fields));
  EXPECT_GE(several, as_size(fields) / 8);
}

/// What is in special position stays open, with the whole; what is not is certified.
TEST(CertifiedCurveParts, AreNotRefutedInSpecialPosition) {
  std::size_t lines = 0, open = 0;
  for (int i = 0; i < std::min(trials(1), 20); ++i)
    for (const MeshKind mesh_kind : all_mesh_kinds()) {
      Random random(20261203u + static_cast<unsigned>(i));
      TetMesh mesh = special_mesh(mesh_kind, random);
      mesh.cell_ids.resize(mesh.tets.size());
      for (std::size_t t = 0; t < mesh.tets.size(); ++t)
        mesh.cell_ids[t] = static_cast<std::int64_t>(t);
      const auto owner = random_owners(mesh, 2, random);
      for (const Degeneracy kind : kDegeneracies) {
        const CurveParts parts = parts_of_field(mesh, owner, 2, kind, random);
        const auto report = parts.check();
        EXPECT_EQ(report.refuted, 0u) << name_of(mesh_kind) << '\n' << to_text(report);
        lines += parts.whole["lines"].get<std::size_t>();
        open += report.status() == "undecided";
      }
    }
  EXPECT_GE(lines, 100u);
  EXPECT_GE(open, 5u);
}

// ---- forgeries ----

/// A field in three slabs with curves across the seams, the same for a seed.
CurveParts honest_parts(std::uint64_t seed) {
  Random random(seed);
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, seed);
  mesh.cell_ids.resize(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids[t] = static_cast<std::int64_t>(t);
  return parts_of_field(mesh, slabs(mesh, 3), 3, kDegeneracies[seed % 2], random);
}

/// Another field in the place of a part's, with its own curves and certificate.
void replace(CurveParts& all, std::size_t part, const TetMesh& mesh) {
  all.parts[part] = curve_exhibit(mesh, {all.kind});
}

bool has_place(const TetMesh& mesh, const Vector3<double>& point) {
  return std::find(mesh.points.begin(), mesh.points.end(), point) != mesh.points.end();
}

/// A vertex of the curves of part 1 that part 0 or 2 has as well; -1 for none.
CurveMesh::Index vertex_on_seam(const CurveParts& all) {
  const auto& points = all.parts[1].curves.points;
  for (std::size_t v = 0; v < points.size(); ++v)
    for (const std::size_t p : {0u, 2u}) {
      const auto& others = all.parts[p].curves.points;
      if (std::find(others.begin(), others.end(), points[v]) != others.end())
        return static_cast<CurveMesh::Index>(v);
    }
  return -1;
}

std::size_t line_at(const CurveMesh& curves, CurveMesh::Index vertex) {
  std::size_t l = 0;
  while (curves.lines[l].front() != vertex && curves.lines[l].back() != vertex) ++l;
  return l;
}

/// Takes a line away, and vertices that no other line has.
void drop_line(CurveExhibit& part, std::size_t line) {
  CurveMesh& c = part.curves;
  const auto at = static_cast<std::ptrdiff_t>(line);
  c.lines.erase(c.lines.begin() + at), c.tet.erase(c.tet.begin() + at);
  c.component.clear();
  c.separation.clear(), c.residual.clear(), c.dominant_eigenvector.clear(), c.mode.clear();
  std::vector<CurveMesh::Index> number(c.points.size(), -1);
  std::vector<Vector3<double>> points;
  for (auto& l : c.lines)
    for (auto& v : l) {
      auto& n = number[as_size(v)];
      if (n < 0) n = static_cast<CurveMesh::Index>(points.size()), points.push_back(c.points[as_size(v)]);
      v = n;
    }
  c.points = points;
  Json& document = part.certificate;
  document["polylines"]["vertices"] = c.points.size();
  document["polylines"]["lines"] = c.lines.size();
  document["levels"][0]["vertices"][1] = c.points.size();
  document["levels"][0]["lines"][1] = c.lines.size();
  part.rehash();
}

struct Forgery {
  const char* name;
  /// False if there is nothing to forge.
  std::function<bool(CurveParts&)> forge;
  const char* finding;  ///< in the verdict
};

std::vector<Forgery> forgeries() {
  const auto seam = [](CurveParts& all, const auto& edit) {
    const auto v = vertex_on_seam(all);
    if (v >= 0) edit(all.parts[1], v);
    return v >= 0;
  };
  return {
      {"a line at a seam dropped from the polylines",
       [=](CurveParts& all) {
         return seam(all, [](CurveExhibit& part, auto v) { drop_line(part, line_at(part.curves, v)); });
       },
       "refuted: part 1"},
      {"a line at a seam dropped, with what is claimed of its tetrahedron",
       [=](CurveParts& all) {
         return seam(all, [](CurveExhibit& part, auto v) {
           const std::size_t line = line_at(part.curves, v);
           const auto tet = part.curves.tet[line];
           drop_line(part, line);
           Json& tets = part.certificate["levels"][0]["tets"];
           tets.erase(std::find_if(tets.begin(), tets.end(),
                                   [&](const Json& claim) { return claim[0] == tet; }));
         });
       },
       "refuted: part 1"},
      {"a line twice in one part",
       [=](CurveParts& all) {
         return seam(all, [](CurveExhibit& part, auto v) {
           const std::size_t line = line_at(part.curves, v);
           part.curves.lines.push_back(part.curves.lines[line]);
           part.curves.tet.push_back(part.curves.tet[line]);
           part.curves.component.push_back(part.curves.component[line]);
           part.certificate["polylines"]["lines"] = part.curves.lines.size();
           part.certificate["levels"][0]["lines"][1] = part.curves.lines.size();
           part.rehash();
         });
       },
       "refuted: part 1"},
      {"a tetrahedron at a seam, with its line, in two parts",
       [=](CurveParts& all) {
         TetMesh mesh = all.parts[0].mesh;
         const bool is_there = seam(all, [&](CurveExhibit& part, auto v) {
           auto corners = part.mesh.tets[as_size(part.curves.tet[line_at(part.curves, v)])];
           for (auto& corner : corners) {
             const auto& point = part.mesh.points[as_size(corner)];
             const auto known = std::find(mesh.points.begin(), mesh.points.end(), point);
             const auto number = known - mesh.points.begin();
             if (known == mesh.points.end()) {
               mesh.points.push_back(point);
               mesh.tensors.push_back(part.mesh.tensors[as_size(corner)]);
             }
             corner = static_cast<TetMesh::Index>(number);
           }
           mesh.tets.push_back(corners);
         });
         if (is_there) replace(all, 0, mesh);
         return is_there;
       },
       "refuted: "},
      {"a tetrahedron at a seam, with its line, in no part",
       [=](CurveParts& all) {
         TetMesh mesh = all.parts[1].mesh;
         const bool is_there = seam(all, [&](const CurveExhibit& part, auto v) {
           mesh.tets.erase(mesh.tets.begin() + part.curves.tet[line_at(part.curves, v)]);
         });
         if (is_there) replace(all, 1, mesh);
         return is_there;
       },
       "refuted: whole, "},
      {"a tensor at a seam changed by a bit in one part",
       [](CurveParts& all) {
         TetMesh mesh = all.parts[1].mesh;
         for (std::size_t v = 0; v < mesh.points.size(); ++v)
           if (has_place(all.parts[2].mesh, mesh.points[v])) {
             mesh.tensors[v].xx =
                 std::nextafter(mesh.tensors[v].xx, std::numeric_limits<double>::infinity());
             replace(all, 1, mesh);
             return true;
           }
         return false;
       },
       "derived different tensors in parts"},
      {"a part of another mesh",
       [](CurveParts& all) {
         if (vertex_on_seam(all) < 0) return false;
         TetMesh mesh = all.parts[1].mesh;
         for (auto& p : mesh.points) p = {p.x * 2 + 9, p.y * 2, p.z * 2};
         replace(all, 1, mesh);
         return true;
       },
       "refuted: whole, "},
      {"a part of another field",
       [](CurveParts& all) {
         TetMesh mesh = all.parts[1].mesh;
         fill_with_normal_tensors(mesh, 99);
         replace(all, 1, mesh);
         return true;
       },
       "derived different tensors in parts"},
      {"a vertex on a seam moved by a bit",
       [=](CurveParts& all) {
         return seam(all, [](CurveExhibit& part, auto v) {
           auto& x = part.curves.points[as_size(v)].x;
           x = std::nextafter(x, 9.0);
           part.rehash();
         });
       },
       "the same vertices on both sides"},
      {"a part missing",
       [](CurveParts& all) {
         all.parts.pop_back();
         return true;
       },
       "refuted: whole, "},
      {"a tetrahedron at a seam left out",
       [=](CurveParts& all) {
         return seam(all, [](CurveExhibit& part, auto v) {
           const auto tet = part.curves.tet[line_at(part.curves, v)];
           part.certificate["levels"][0]["undecided"].push_back({tet, "points_not_told_apart"});
         });
       },
       ""}};
}

TEST(ForgedCurveParts, AreNotCertified) {
  const int fields = std::min(trials(3), 30);
  std::size_t refuted = 0;
  for (const Forgery& forgery : forgeries()) {
    std::size_t tried = 0;
    for (std::uint64_t seed = 1; seed <= 4 * as_size(fields) && tried < as_size(fields); ++seed) {
      CurveParts parts = honest_parts(seed);
      if (!forgery.forge(parts)) continue;
      ++tried;
      const auto report = parts.check();
      EXPECT_NE(report.status(), "certified") << forgery.name << ", seed " << seed;
      EXPECT_NE(to_text(report).find(forgery.finding), std::string::npos)
          << forgery.name << ", seed " << seed << '\n'
          << to_text(report);
      refuted += report.status() == "refuted";
    }
    EXPECT_EQ(tried, as_size(fields)) << forgery.name;
  }
  // All but those of a tetrahedron that is left out, at least.
  EXPECT_GE(refuted, (forgeries().size() - 1) * as_size(fields));
}

TEST(ForgedCurveParts, HonestOnesAreCertified) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto report = honest_parts(seed).check();
    EXPECT_EQ(report.status(), "certified") << to_text(report);
  }
}

}  // namespace
}  // namespace tensortopo::test
