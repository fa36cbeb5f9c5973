// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/render_subject.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "counted.hpp"
#include "render/input/domain_boundary.hpp"
#include "render/input/feature_edges.hpp"
#include "render/input/surface_input.hpp"
#include "render/tet/tet_surface.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_geometry.hpp"
#include "tensortopo/quadric/extract_invariant_surface.hpp"

namespace tensortopo {
namespace {

/// The sides of the box around a shape, two triangles each.
vtkSmartPointer<vtkPolyData> bounding_box(vtkPolyData& shape) {
  double b[6];
  shape.GetBounds(b);
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (int corner = 0; corner < 8; ++corner)
    points->InsertNextPoint(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)]);
  constexpr vtkIdType kSides[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const auto triangles = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& side : kSides) {
    triangles->InsertNextCell({side[0], side[1], side[2]});
    triangles->InsertNextCell({side[0], side[2], side[3]});
  }
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(triangles);
  return box;
}

/// A tetrahedron from the middle of the list of those that a mode's surface meets.
std::size_t crossed_tet(const TetMesh& mesh, const ModeValue& mode) {
  if (std::abs(mode.approx()) == 1)
    throw UsageError("--tet any: modes 1 and -1 have curves, name a tetrahedron");
  const SurfaceMesh surface = extract_mode_surface<double>(mesh, mode).surface;
  if (surface.tet.empty())
    throw UsageError(
        fmt::format("--tet any: the field has no surface of mode {}", short_text(mode)));
  return static_cast<std::size_t>(surface.tet[surface.tet.size() / 2]);
}

std::size_t place_of_cell(const TetMesh& mesh, std::int64_t cell) {
  const auto found = std::find(mesh.cell_ids.begin(), mesh.cell_ids.end(), cell);
  if (found == mesh.cell_ids.end()) {
    const auto [least, greatest] = std::minmax_element(mesh.cell_ids.begin(), mesh.cell_ids.end());
    throw UsageError(
        fmt::format("--tet {}: no such tetrahedron; the mesh has {}, numbered from {} "
                    "to {}",
                    cell, mesh.cell_ids.size(), *least, *greatest));
  }
  return static_cast<std::size_t>(found - mesh.cell_ids.begin());
}

// The sheets of a file, with the lines of the texture.
std::vector<Sheet> textured_sheets(const std::filesystem::path& file, vtkPolyData* all,
                                   const TetMesh& mesh, const FieldOrigin& field, Texture texture,
                                   bool recover) {
  // A file of curves has nothing to be textured.
  if (all->GetNumberOfPolys() == 0) return sheets_of(all);
  SurfaceInput input = read_surface(file);
  if (texture == Texture::dominant) {
    vtkDataArray* const vectors = input.file->GetPointData()->GetArray("dominant_eigenvector");
    if (vectors == nullptr || vectors->GetNumberOfComponents() != 3)
      throw IoError(IoError::Kind::invalid, file, "has no point data 'dominant_eigenvector'");
    for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
      input.surface.dominant_eigenvector.push_back(
          {vectors->GetComponent(i, 0), vectors->GetComponent(i, 1), vectors->GetComponent(i, 2)});
  } else {
    require_modes(input, file);
    locate_in_mesh(input, mesh, field, file);
  }
  set_line_field(*input.file, surface_lines(input.surface, mesh, texture, recover));
  return sheets_of(input.file);
}

// Why there is nothing in space.
std::string missed_note(const ModeValue& mode, std::int64_t tet, double beyond) {
  if (beyond > 1)
    return fmt::format(
        "mode {}: there is no surface in the cube around tetrahedron {}; a larger "
        "--beyond shows more of its linear field",
        short_text(mode), tet);
  return fmt::format(
      "mode {}: the surface misses tetrahedron {}, so nothing is drawn in it. Those "
      "that it meets are in the cell data 'tet' of an extracted .vtp, and --tet any "
      "takes one of them; --beyond 4 "
      "shows the linear field outside",
      short_text(mode), tet);
}

/// Whether more than the mesh's outline is drawn of it, or the caller says how to read its tensors.
bool needs_field(const RenderCommand& command) {
  const ReadOptions& read = command.read;
  return !command.modes.empty() || !command.frames.empty() || !command.levels.empty() ||
         command.tet || command.any_tet ||
         (command.texture != Texture::none && command.texture != Texture::dominant) ||
         !read.tensor.empty() || read.components || read.symmetrize || read.zero_below > 0 ||
         read.cell_to_point || read.mean || !read.materials.empty() || read.cell_values != CellValues::one;
}

}  // namespace

RenderSubject::RenderSubject(const RenderCommand& command) : command_(command) {
  if (command.mesh) {
    const bool field = needs_field(command);
    ReadResult read = field ? read_mesh(*command.mesh, command.read)
                            : read_geometry(*command.mesh, command.read);
    mesh_ = std::move(read.mesh);
    field_ = {read.sha256, read.report.tensor_name};
    mesh_notes_ = field ? read.report.all_notes() : read.report.notes;
    if (command.any_tet) {
      tet_ = crossed_tet(mesh_, command.frames.empty() ? command.modes.front()
                                                       : command.frames.front());
      mesh_notes_.push_back(fmt::format("--tet any: tetrahedron {}", mesh_.cell_ids[tet_]));
    } else if (command.tet) {
      tet_ = place_of_cell(mesh_, *command.tet);
    } else {
      domain_ = domain_boundary(mesh_);
      // A software renderer takes a minute for 20,000 of them, and nobody sees anything behind.
      constexpr std::size_t kMostCreases = 5000;
      if (const auto creases = feature_edges(surface_of(*domain_), EdgeKind::crease).size();
          creases > kMostCreases) {
        mesh_notes_.push_back(fmt::format(
            "the boundary has {} creases: its bounding box is drawn instead", creases));
        domain_ = bounding_box(*domain_);
      }
    }
  }
  for (const auto& file : command.surfaces) {
    const auto data = read_poly_data(file);
    auto sheets =
        command.texture == Texture::none
            ? sheets_of(data)
            : textured_sheets(file, data, mesh_, field_, command.texture, command.recover);
    if (sheets.empty()) empty_.push_back(file);
    if (const std::string sha256 = origin_of(*data).sha256;
        command.mesh && !sha256.empty() && sha256 != field_.sha256)
      mesh_notes_.push_back(
          fmt::format("{} was extracted from another file than this one", file.string()));
    for (Sheet& sheet : sheets) sheets_.push_back(std::move(sheet));
  }
}

std::vector<Sheet> RenderSubject::extracted(const ModeValue& mode, RenderReport& report) const {
  const double value = mode.approx();
  const auto note = [&](std::size_t cells) {
    if (cells > 0)
      report.notes.push_back(fmt::format("mode {}: {} of {} unresolved, and not drawn",
                                         short_text(mode), cells, counted_tets(mesh_.tets.size())));
  };
  if (std::abs(value) == 1) {
    const auto kind = value > 0 ? Degeneracy::linear : Degeneracy::planar;
    const CurveExtraction extraction = extract_degenerate_curves(mesh_, kind);
    note(extraction.unresolved.size());
    if (extraction.curves.lines.empty())
      report.notes.push_back(
          fmt::format("mode {}: the field has no such curves", short_text(mode)));
    return {sheet_of(extraction.curves, value)};
  }
  const Extraction extraction = extract_mode_surface<double>(mesh_, mode);
  note(extraction.unresolved.size());
  if (extraction.surface.triangles.empty())
    report.notes.push_back(fmt::format("mode {}: the field has no such surface", short_text(mode)));
  const LineField lines =
      surface_lines(extraction.surface, mesh_, command_.texture, command_.recover);
  return {sheet_of(extraction.surface, value, lines)};
}

Sheet RenderSubject::extracted(const InvariantLevel& level, RenderReport& report) const {
  InvariantOptions options;
  options.pieces = command_.pieces;
  const InvariantExtraction extraction = extract_invariant_surface(mesh_, level, options);
  const std::string name = fmt::format("{} {}", name_of(level.invariant()), short_text(level));
  if (!extraction.zero_tensor.empty())
    report.notes.push_back(fmt::format("{}: {} of {} unresolved, and not drawn", name,
                                       extraction.zero_tensor.size(), counted_tets(mesh_.tets.size())));
  if (extraction.surface.triangles.empty())
    report.notes.push_back(name + ": the field has no such surface");
  Sheet sheet = sheet_of(extraction.surface, 0);
  sheet.mode.reset();
  sheet.value = extraction.surface.value.empty() ? 0 : extraction.surface.value.front();
  return sheet;
}

vtkSmartPointer<vtkImageData> RenderSubject::picture(const std::vector<ModeValue>& modes,
                                                     RenderReport& report) {
  for (const ModeValue& mode : modes) report.modes.push_back(mode.approx());
  if (command_.one_tet()) {
    TetPicture picture;
    picture.field = tet_field(mesh_, tet_);
    picture.modes = modes;
    if (!command_.panels.empty()) picture.panels = command_.panels;
    picture.texture = command_.texture;
    picture.beyond = command_.beyond;
    picture.marked = command_.marked;
    picture.view = command_.view;
    if (!picture.view.sized) set_default_size(picture);
    try {
      const TetDirections directions(picture.field, modes.front());
      const double mode = directions.manifold().characteristic().mode;
      report.bifurcation_mode = std::sqrt((1 - mode) * (1 + mode));
      TetImage result = draw_tet(picture);
      report.marked.insert(report.marked.end(), result.marked.begin(), result.marked.end());
      report.notes.insert(report.notes.end(), result.notes.begin(), result.notes.end());
      for (const ModeValue& missed : result.missed)
        report.notes.push_back(missed_note(missed, mesh_.cell_ids[tet_], command_.beyond));
      return result.image;
    } catch (const std::invalid_argument& problem) {
      throw IoError(IoError::Kind::invalid, *command_.mesh,
                    fmt::format("{} (tetrahedron {})", problem.what(), mesh_.cell_ids[tet_]));
    }
  }
  std::vector<Sheet> sheets = sheets_;
  for (const ModeValue& mode : modes) {
    std::vector<ModeValue> signs{mode};
    if (command_.generalized && mode.sign() != 0) signs.push_back(mode.opposite());
    for (const ModeValue& one : signs)
      for (Sheet& sheet : extracted(one, report)) sheets.push_back(std::move(sheet));
  }
  for (const InvariantLevel& level : command_.levels) {
    Sheet sheet = extracted(level, report);
    if (sheet.shape->GetNumberOfPolys() > 0) sheets.push_back(std::move(sheet));
  }
  if (modes.empty())
    for (const Sheet& sheet : sheets) {
      if (sheet.mode) report.modes.push_back(*sheet.mode);
      if (sheet.value) report.values.push_back(*sheet.value);
    }
  const bool has_surface = std::any_of(sheets.begin(), sheets.end(), [](const Sheet& s) {
    return s.shape->GetNumberOfPoints() > 0;
  });
  Drawn drawn = draw(std::move(sheets), domain_, command_.view);
  if (has_surface && !drawn.surface_in_view)
    report.notes.push_back("nothing of the surface is in view (--focus, --zoom)");
  return drawn.image;
}

}  // namespace tensortopo
