// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfaces/write_formats.hpp"
#include "vtk/xml_output.hpp"

namespace tensortopo::detail {
namespace {

/// The values of the surface and those of the curves as one array: zero where only the other kind
/// has values. Nothing is copied if there is but one kind.
template <class Value>
class Joined {
 public:
  Joined(const std::vector<Value>& of_surface, std::size_t surface_size,
         const std::vector<Value>& of_curves, std::size_t curve_size) {
    if (of_surface.empty() && of_curves.empty()) return;
    values_ = of_surface.empty() ? of_curves : of_surface;
    if (values_.size() == surface_size + curve_size) return;
    both_ = of_surface;
    both_.resize(surface_size);
    both_.insert(both_.end(), of_curves.begin(), of_curves.end());
    both_.resize(surface_size + curve_size);
    values_ = both_;
  }
  Joined(const Joined&) = delete;
  Joined& operator=(const Joined&) = delete;

  std::span<const Value> values() const { return values_; }

 private:
  std::vector<Value> both_;
  std::span<const Value> values_;
};

/// The ids of the cells: of the curves' first, as VTK orders them.
std::vector<std::int64_t> cell_ids(const SurfaceMesh& surface, const CurveMesh& curves,
                                   const TetMesh& mesh) {
  std::vector<std::int64_t> ids;
  ids.reserve(curves.tet.size() + surface.tet.size());
  for (const auto* const tets : {&curves.tet, &surface.tet})
    for (const auto t : *tets) ids.push_back(mesh.cell_ids[static_cast<std::size_t>(t)]);
  return ids;
}

/// Components of the curves are numbered after those of the surface.
std::vector<SurfaceMesh::Index> components(const SurfaceMesh& surface, const CurveMesh& curves) {
  SurfaceMesh::Index first = 0;
  for (const auto c : surface.component) first = std::max(first, c + 1);
  std::vector<SurfaceMesh::Index> result;
  result.reserve(curves.component.size() + surface.component.size());
  for (const auto c : curves.component) result.push_back(first + c);
  result.insert(result.end(), surface.component.begin(), surface.component.end());
  return result;
}

/// Arrays of one section. Without values an array is written only if it is `expected`.
class Section {
 public:
  Section(XmlOutput& out, std::vector<std::string>& names) : out_(out), names_(names) {}

  template <class Value, class... More>
  void add(const char* name, bool expected, std::span<const Value> values, More... more) {
    if (values.empty() && !expected) return;
    out_.array(name, values, more...);
    names_.emplace_back(name);
  }

 private:
  XmlOutput& out_;
  std::vector<std::string>& names_;
};

void add_lines(XmlOutput& out, const CurveMesh& curves, std::size_t first_point) {
  std::vector<std::int64_t> corners, ends;
  for (const auto& line : curves.lines) {
    for (const auto v : line) corners.push_back(static_cast<std::int64_t>(first_point) + v);
    ends.push_back(static_cast<std::int64_t>(corners.size()));
  }
  out.open("Lines");
  out.array("connectivity", corners);
  out.array("offsets", ends);
  out.close("Lines");
}

}  // namespace

void write_vtp(const SurfaceMesh& surface, const CurveMesh& curves, const TetMesh& mesh,
               const OutputKinds& kinds, const std::vector<FileNote>& notes,
               const std::vector<CellArray>& more, OutputFile& file,
               std::vector<std::string>& names) {
  const std::size_t before = surface.points.size(), after = curves.points.size();
  const bool is_empty = before + after == 0;
  const bool of_modes = is_empty && kinds.mode_surfaces,
             of_values = is_empty && kinds.invariant_surfaces,
             of_curves = is_empty && kinds.degenerate_curves;
  const bool of_any = of_modes || of_values || of_curves;
  const bool has_modes = of_modes || of_curves || !surface.mode.empty() || !curves.mode.empty(),
             has_values = of_values || !surface.value.empty(),
             has_normals = of_modes || of_values || !surface.normal.empty();

  XmlOutput out("PolyData", file);
  out.open("PolyData");
  if (!notes.empty()) {
    out.open("FieldData");
    for (const FileNote& note : notes) out.string(note.name, note.text);
    out.close("FieldData");
  }
  out.open("Piece", {{"NumberOfPoints", std::to_string(before + after)},
                     {"NumberOfVerts", "0"},
                     {"NumberOfLines", std::to_string(curves.lines.size())},
                     {"NumberOfStrips", "0"},
                     {"NumberOfPolys", std::to_string(surface.triangles.size())}});

  XmlOutput::Attributes marks;
  if (has_values || has_modes) marks.emplace_back("Scalars", has_values ? "value" : "mode");
  if (has_normals) marks.emplace_back("Normals", "normal");
  Section section(out, names);
  const auto add_numbers = [&](const char* name, bool expected, const std::vector<double>& first,
                               const std::vector<double>& second, Patterns patterns) {
    section.add(name, expected, Joined(first, before, second, after).values(), patterns);
  };
  const auto add_vectors = [&](const char* name, bool expected,
                               const std::vector<Vector3<double>>& first,
                               const std::vector<Vector3<double>>& second) {
    section.add(name, expected, Joined(first, before, second, after).values(), Patterns::none);
  };
  out.open("PointData", marks);
  add_numbers("mode", of_modes || of_curves, surface.mode, curves.mode, Patterns::some);
  add_numbers("value", of_values, surface.value, {}, Patterns::some);
  add_vectors("medium_eigenvector", of_modes, surface.medium_eigenvector, {});
  add_vectors("dominant_eigenvector", of_modes || of_curves, surface.dominant_eigenvector,
              curves.dominant_eigenvector);
  add_vectors("normal", of_modes || of_values, surface.normal, {});
  add_numbers("separation", of_curves, {}, curves.separation, Patterns::none);
  add_numbers("residual", of_any, surface.residual, curves.residual, Patterns::none);
  for (const CellArray& array : more) {
    if (!array.of_points) continue;
    std::vector<std::int32_t> values = array.values;
    values.insert(values.end(), array.line_values.begin(), array.line_values.end());
    values.resize(before + after, -1);
    section.add(array.name.c_str(), false, std::span<const std::int32_t>(values));
  }
  out.close("PointData");

  const auto ids = cell_ids(surface, curves, mesh);
  const auto parts = components(surface, curves);
  out.open("CellData");
  section.add("tet", of_any, std::span(ids));
  section.add("component", of_any, std::span(parts));
  for (const CellArray& array : more) {
    if (array.of_points) continue;
    std::vector<std::int32_t> values = array.line_values;
    values.resize(curves.lines.size(), 0);
    values.insert(values.end(), array.values.begin(), array.values.end());
    section.add(array.name.c_str(), false, std::span<const std::int32_t>(values));
  }
  out.close("CellData");

  out.open("Points");
  out.array("Points", Joined(surface.points, before, curves.points, after).values(),
            Patterns::some);
  out.close("Points");
  if (!curves.lines.empty()) add_lines(out, curves, before);
  out.open("Polys");
  out.corners(std::span(surface.triangles));
  out.close("Polys");
  out.close("Piece");
  out.close("PolyData");
  out.finish();
}

}  // namespace tensortopo::detail
