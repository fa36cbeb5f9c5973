// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "forgery.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <type_traits>

#include "certificate_writer.hpp"
#include "proofs-check/vtk_text.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/witness_fields.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = SurfaceMesh::Index;

std::string edited(std::string text, const std::vector<Exhibit::Edit>& edits) {
  for (const Exhibit::Edit& edit : edits)
    for (std::size_t at = text.find(edit.from); at != std::string::npos;
         at = edit.once ? std::string::npos : text.find(edit.from, at + edit.to.size()))
      text.replace(at, edit.from.size(), edit.to);
  return text;
}

}  // namespace

std::string Exhibit::field_text() const { return edited(test::field_text(mesh), in_field); }

std::string Exhibit::certificate_text() const { return edited(certificate.dump(), in_certificate); }

std::string Exhibit::surface_text() const {
  std::ostringstream out = text_stream("PolyData");
  out << "<Piece NumberOfPoints=\"" << surface.points.size()
      << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << surface.triangles.size() << "\"><PointData>";
  for (const FileArray& a : arrays)
    if (a.of == "points") write_array(out, a.type, a.name, a.width, a.numbers);
  out << "</PointData><CellData>";
  write_array(out, "Int64", "tet", 1, surface.tet);
  for (const FileArray& a : arrays)
    if (a.of == "triangles") write_array(out, a.type, a.name, a.width, a.numbers);
  out << "</CellData>";
  write_points(out, surface.points);
  out << "<Polys>";
  write_cells(out, surface.triangles);
  out << "</Polys></Piece></PolyData></VTKFile>\n";
  return edited(out.str(), in_surface);
}

namespace {

std::vector<FileArray> file_arrays(const SurfaceMesh& s) {
  std::vector<FileArray> result;
  const auto add = [&](const std::string& of, const std::string& type, const std::string& name,
                       const auto& values) {
    if (values.empty()) return;
    if constexpr (std::is_same_v<decltype(values.front()), const Vector3<double>&>) {
      result.push_back({of, type, name, 3, {}});
      for (const auto& v : values)
        result.back().numbers.insert(result.back().numbers.end(), {v.x, v.y, v.z});
    } else {
      result.push_back({of, type, name, 1, {values.begin(), values.end()}});
    }
  };
  add("points", "Float64", "mode", s.mode);
  add("points", "Float64", "value", s.value);
  add("points", "Float64", "medium_eigenvector", s.medium_eigenvector);
  add("points", "Float64", "dominant_eigenvector", s.dominant_eigenvector);
  add("points", "Float64", "normal", s.normal);
  add("points", "Float64", "residual", s.residual);
  add("triangles", "Int32", "component", s.component);
  return result;
}

Json hashes_json(const SurfaceMesh& surface) {
  Json result = Json::array();
  for (const ArrayHash& a : array_hashes(surface))
    result.push_back({a.of, a.name, a.components, a.sha256});
  return result;
}

/// What `append_level` leaves out.
void append_arrays(SurfaceMesh& all, const SurfaceMesh& level) {
  Index next = 0;
  for (const Index c : all.component) next = std::max(next, c + 1);
  for (const Index c : level.component) all.component.push_back(next + c);
  const auto append = [](auto& list, const auto& more) {
    list.insert(list.end(), more.begin(), more.end());
  };
  append(all.mode, level.mode);
  append(all.value, level.value);
  append(all.medium_eigenvector, level.medium_eigenvector);
  append(all.dominant_eigenvector, level.dominant_eigenvector);
  append(all.normal, level.normal);
  append(all.residual, level.residual);
}

}  // namespace

void Exhibit::rehash() {
  certificate["input"]["sha256"] = field_sha256(mesh);
  certificate["surface"]["sha256"] = surface_sha256(surface, mesh);
  if (!certificate["surface"].contains("arrays")) return;
  arrays = file_arrays(surface);
  certificate["surface"]["arrays"] = hashes_json(surface);
}

namespace {

CertifiedLevel certified_mode(const TetMesh& mesh, const std::string& mode, SurfaceMesh& all) {
  const ModeValue mu = ModeValue::parse(mode);
  ExtractOptions options;
  options.keep_topology = true;
  options.sampling.resolution = 1;  // few triangles
  Extraction e = extract_mode_surface<double>(mesh, mu, options);
  append_level(all, e.surface);
  append_arrays(all, e.surface);
  return certify(mesh, mu, e);
}

CertifiedLevel certified_invariant(const TetMesh& mesh, const InvariantLevel& level, int pieces,
                                   SurfaceMesh& all) {
  InvariantOptions options;
  options.pieces = pieces;
  const InvariantExtraction e = extract_invariant_surface(mesh, level, options);
  append_level(all, e.surface);
  append_arrays(all, e.surface);
  return certify(mesh, level, e);
}

}  // namespace

Exhibit exhibit(TetMesh mesh, const std::vector<std::string>& texts, int pieces) {
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
  Exhibit result;
  std::vector<CertifiedLevel> levels;
  for (const std::string& text : texts) {
    const std::size_t space = text.find(' ');
    levels.push_back(
        space == std::string::npos
            ? certified_mode(mesh, text, result.surface)
            : certified_invariant(mesh,
                                  InvariantLevel::parse(*invariant_named(text.substr(0, space)),
                                                        text.substr(space + 1)),
                                  pieces, result.surface));
  }
  CertificateSubject subject;
  subject.tensor = "stress";
  subject.components = "vtk";
  subject.points = mesh.points.size();
  subject.tetrahedra = mesh.tets.size();
  subject.vertices = result.surface.points.size();
  subject.cells = result.surface.triangles.size();
  subject.field_sha256 = field_sha256(mesh);
  subject.output_sha256 = surface_sha256(result.surface, mesh);
  result.certificate =
      Json::parse(certificate_bytes(subject, levels, mesh, CertificateEncoding::json));
  result.mesh = std::move(mesh);
  return result;
}

Exhibit exhibit_with_arrays(TetMesh mesh, const std::vector<std::string>& levels) {
  Exhibit result = exhibit(std::move(mesh), levels);
  result.certificate["surface"]["arrays"] = Json::array();
  result.rehash();
  return result;
}

namespace {

bool has_closed_cone(const Exhibit& e) {
  const Json& cones = e.certificate["levels"][0]["cones"];
  return std::any_of(cones.begin(), cones.end(), [](const Json& cone) {
    return std::any_of(cone.begin() + 1, cone.end(), [](const Json& s) { return s.size() == 2; });
  });
}

/// In one tetrahedron: a closed sheet, a closed curve on a face, an edge crossed twice, both nappes
/// of an anisotropy; and levels of two kinds in one file.
std::vector<Exhibit> invariant_exhibits() {
  std::vector<Exhibit> result;
  result.push_back(exhibit(reference_tet_mesh(kAroundZero), {"magnitude 1/10"}));
  result.push_back(exhibit(reference_tet_mesh(kZeroInFace), {"deviator-magnitude 1/10"}));
  result.push_back(exhibit(reference_tet_mesh(kZeroOnEdge), {"magnitude 1/10"}, 2));
  // Isotropic of both signs at two vertices.
  const TetTensors two_nappes{{{2, 1, 1.5, 0.25, 0, 0},
                               {-1.5, -1, -2, 0, 0.5, 0},
                               {1, -1, 0, 1, 0, 0.5},
                               {0.5, 0, -0.5, 0, 1, -1}}};
  result.push_back(exhibit(reference_tet_mesh(two_nappes), {"anisotropy 4/5"}));
  result.push_back(exhibit(reference_tet_mesh(two_nappes), {"magnitude 2", "1/4"}));
  return result;
}

}  // namespace

TetMesh two_tets_at_an_edge() {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  mesh.tensors.resize(6);
  fill_with_normal_tensors(mesh, 1);
  mesh.tensors[0] = {1, 0, -1, 0, 0, 0};
  mesh.tensors[1] = {-1, 1, 0.25, 0.25, 0, 0.125};
  mesh.tets = {{0, 2, 3, 1}, {0, 4, 5, 1}};
  return mesh;
}

const std::vector<Exhibit>& honest_exhibits() {
  static const std::vector<Exhibit> all = [] {
    std::vector<Exhibit> result;
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, 5);
    result.push_back(exhibit(mesh, {"1/4", "-1/2"}));
    for (std::uint64_t seed = 1; result.size() < 2; ++seed) {
      fill_with_smooth_tensors(mesh, seed, 4, 1);
      Exhibit e = exhibit(mesh, {"0"});
      if (e.surface.triangles.size() > 30) result.push_back(std::move(e));
    }
    // Around one isotropic vertex, around the edge between two, over a closed curve.
    constexpr SymmetricTensor<double> kNoDeviator{3, 3, 3, 0, 0, 0};
    for (const auto& zeros : {std::vector<std::size_t>{0}, std::vector<std::size_t>{0, 7}}) {
      fill_with_normal_tensors(mesh, 5);
      for (const std::size_t v : zeros) mesh.tensors[v] = kNoDeviator;
      result.push_back(exhibit(mesh, {"1/4"}));
    }
    result.push_back(result.back());
    Random random(3);
    while (!has_closed_cone(result.back())) {
      TetTensors tensors = random.tet_tensors();
      tensors[2] = kNoDeviator;
      result.back() = exhibit(reference_tet_mesh(tensors), {"1/4"});
    }
    for (const FieldWitness& witness : field_witnesses()) {
      const TetCase& c = witness.cases.front();
      const std::string mode =
          std::to_string(c.mode.numerator) + "/" + std::to_string(c.mode.denominator);
      Exhibit e = exhibit(single_tet_mesh(c.points, witness.field.at(c.points)), {mode});
      const bool is_small = !e.surface.triangles.empty() && e.surface.triangles.size() < 400;
      if (is_small && Court("choice").verdict(e) == "certified") result.push_back(std::move(e));
    }
    for (Exhibit& e : invariant_exhibits()) result.push_back(std::move(e));
    return result;
  }();
  return all;
}

Court::Court(const std::string& name)
    : folder_(std::filesystem::path(testing::TempDir()) /
              ("court_" + name + "_" + std::to_string(getpid()))) {
  std::filesystem::create_directories(folder_);
}

Court::~Court() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void Court::put(const char* name, const std::string& text, std::string& last) {
  if (text == last) return;
  std::ofstream(folder_ / name, std::ios::binary) << text;
  last = text;
}

std::string Court::verdict(const std::string& field, const std::string& surface,
                           const std::string& certificate) {
  put("field.vtu", field, field_);
  put("surface.vtp", surface, surface_);
  put("c.json", certificate, certificate_);
  try {
    const certificate::Report report = certificate::check_certificate(
        (folder_ / "field.vtu").string(), (folder_ / "surface.vtp").string(),
        (folder_ / "c.json").string());
    report_ = to_text(report);
    return report.status();
  } catch (const certificate::Malformed& error) {
    report_ = error.what();
    return "malformed";
  }
}

}  // namespace tensortopo::test
