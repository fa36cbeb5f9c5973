// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curve_exhibit.hpp"

#include <algorithm>

#include "proofs-check/vtk_text.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = CurveMesh::Index;

void append(CurveMesh& all, const CurveMesh& part) {
  const auto first = static_cast<Index>(all.points.size());
  Index next = 0;
  for (const Index c : all.component) next = std::max(next, c + 1);
  for (auto line : part.lines) {
    for (Index& v : line) v += first;
    all.lines.push_back(line);
  }
  for (const Index c : part.component) all.component.push_back(next + c);
  const auto add = [](auto& list, const auto& more) {
    list.insert(list.end(), more.begin(), more.end());
  };
  add(all.tet, part.tet);
  add(all.points, part.points);
  add(all.dominant_eigenvector, part.dominant_eigenvector);
  add(all.mode, part.mode);
  add(all.separation, part.separation);
  add(all.residual, part.residual);
  add(all.carrier, part.carrier);
  add(all.carrier_vertices, part.carrier_vertices);
}

Json hashes_json(const CurveMesh& curves) {
  Json result = Json::array();
  for (const ArrayHash& a : array_hashes(curves))
    result.push_back({a.of, a.name, a.components, a.sha256});
  return result;
}

}  // namespace

void CurveExhibit::rehash() {
  certificate["input"]["sha256"] = field_sha256(mesh);
  certificate["polylines"]["sha256"] = curves_sha256(curves, mesh);
  certificate["polylines"]["arrays"] = hashes_json(curves);
}

std::string CurveExhibit::field_text() const { return test::field_text(mesh); }

std::string CurveExhibit::curve_text() const {
  std::ostringstream out = text_stream("PolyData");
  out << "<Piece NumberOfPoints=\"" << curves.points.size()
      << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << curves.lines.size()
      << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"><PointData>";
  std::vector<double> dominant;
  for (const auto& e : curves.dominant_eigenvector)
    dominant.insert(dominant.end(), {e.x, e.y, e.z});
  const auto write = [&](const char* type, const char* name, int width, const auto& numbers) {
    if (!numbers.empty()) write_array(out, type, name, width, numbers);
  };
  write("Float64", "mode", 1, curves.mode);
  write("Float64", "dominant_eigenvector", 3, dominant);
  write("Float64", "separation", 1, curves.separation);
  write("Float64", "residual", 1, curves.residual);
  out << "</PointData><CellData>";
  write("Int64", "tet", 1, curves.tet);
  write("Int32", "component", 1, curves.component);
  out << "</CellData>";
  write_points(out, curves.points);
  out << "<Lines>";
  write_cells(out, curves.lines);
  out << "</Lines></Piece></PolyData></VTKFile>\n";
  return out.str();
}

CurveExhibit curve_exhibit(TetMesh mesh, const std::vector<Degeneracy>& kinds) {
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
  CurveExhibit result;
  std::vector<CertifiedCurves> certified;
  for (const Degeneracy kind : kinds) {
    const CurveExtraction extraction = extract_degenerate_curves(mesh, kind);
    certified.push_back(certify(mesh, kind, extraction));
    append(result.curves, extraction.curves);
  }
  CertificateSubject subject;
  subject.tensor = "stress";
  subject.components = "vtk";
  subject.points = mesh.points.size();
  subject.tetrahedra = mesh.tets.size();
  subject.vertices = result.curves.points.size();
  subject.cells = result.curves.lines.size();
  result.certificate =
      Json::parse(certificate_bytes(subject, certified, mesh, CertificateEncoding::json));
  result.mesh = std::move(mesh);
  result.rehash();
  return result;
}

const std::vector<CurveExhibit>& honest_curves() {
  static const std::vector<CurveExhibit> all = [] {
    const std::vector<Degeneracy> both{Degeneracy::linear, Degeneracy::planar};
    std::vector<CurveExhibit> result;
    // The first field with each of these.
    const auto add_first = [&](int cells, const auto& wanted) {
      TetMesh field = cube_mesh(cells);
      for (std::uint64_t seed = 1;; ++seed) {
        fill_with_normal_tensors(field, seed);
        CurveExhibit e = curve_exhibit(field, result.empty() ? both : std::vector{both[seed % 2]});
        const Json& levels = e.certificate["levels"];
        if (!std::all_of(levels.begin(), levels.end(), wanted)) continue;
        result.push_back(std::move(e));
        return;
      }
    };
    const auto longest = [](const Json& list) {
      std::size_t size = 0;
      for (const Json& item : list) size = std::max(size, item.size());
      return size;
    };
    add_first(1, [&](const Json& level) { return !level["curves"].empty(); });
    add_first(1, [&](const Json& level) { return longest(level["faces"]) > 4; });
    add_first(1, [&](const Json& level) { return longest(level["tets"]) > 2; });
    add_first(1, [&](const Json& level) {
      return std::any_of(level["curves"].begin(), level["curves"].end(),
                         [](const Json& curve) { return curve["closed"].get<bool>(); });
    });
    return result;
  }();
  return all;
}

}  // namespace tensortopo::test
