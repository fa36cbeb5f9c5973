// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/read_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "bytes/format_error.hpp"
#include "bytes/input_file.hpp"
#include "bytes/printable.hpp"
#include "fields/assemble_cells.hpp"
#include "fields/cell_means.hpp"
#include "fields/cells_where.hpp"
#include "fields/merge_points.hpp"
#include "fields/read_mesh_of.hpp"
#include "fields/small_tensors.hpp"
#include "fields/tensor_array.hpp"
#include "fields/torn_faces.hpp"
#include "formats/field_format.hpp"
#include "grids/raw_grid.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_geometry.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo {
namespace {

using namespace detail;

/// The grids of a file, and the hash of its bytes.
std::vector<RawGrid> read_grids(const std::shared_ptr<const InputFile>& file,
                                const ReadOptions& options, ReadResult& result) {
  const FieldFormatEntry& entry = format_of(file->path);
  const std::string_view extension = entry.format.extension;
  if (options.step && !entry.format.has_steps)
    throw IoError(IoError::Kind::inapplicable, file->path,
                  fmt::format("--step: a {} has no steps", extension));
  if (!options.mask.empty() && !entry.format.takes_mask)
    throw IoError(IoError::Kind::inapplicable, file->path,
                  fmt::format("--mask: is for NIfTI images, not for a {}", extension));
  Sha256 sum;
  sum.add(file->bytes);
  std::vector<RawGrid> grids = entry.read(FieldSource{file, options, sum, result.report.notes});
  result.sha256 = sum.hex();
  return grids;
}

/// What whoever has such a mesh can do, or nothing.
std::string_view remedy_of(MeshDefect::Kind kind, const ReadOptions& options,
                           const ReadReport& report) {
  using Kind = MeshDefect::Kind;
  switch (kind) {
    case Kind::out_of_range:
      return "; give the mesh in other units of length";
    case Kind::degenerate_cell:
    case Kind::repeated_vertex:
      return "; take such cells out of the mesh, or leave them out with --where";
    case Kind::duplicated_cell:
      return "; take one of the cells out of the mesh";
    case Kind::overlapping_cells:
    case Kind::inverted_cell:
      return report.quadratic_cells > 0 && options.quadratic == QuadraticCells::split
                 ? "; --quadratic corners takes the quadratic cells by their corners"
                 : "";
    default:
      return "";
  }
}

/// Refuses meshes that are unfit; else their outer faces.
std::vector<OuterFace> check(const std::filesystem::path& file, const TetMesh& mesh,
                             const ReadOptions& options, const ReadReport& report) {
  const std::size_t left_out = report.cells_left_out;
  if (mesh.tets.empty())
    throw IoError(IoError::Kind::invalid, file,
                  left_out > 0 ? fmt::format("--where leaves no cell ({} are left out)", left_out)
                               : std::string("has no tetrahedra"));
  if (mesh.tets.size() > INT32_MAX)
    throw IoError(IoError::Kind::invalid, file, "has too many tetrahedra");
  std::vector<OuterFace> outer;
  const std::vector<MeshDefect> defects = validate(mesh, &outer);
  if (defects.empty()) return outer;
  std::string text = defects.front().text;
  if (defects.size() > 1)
    text += "; " + std::to_string(defects.size() - 1) + " more defects" +
            (defects.size() >= 1000 ? " at least" : "");
  text += remedy_of(defects.front().kind, options, report);
  throw IoError(IoError::Kind::invalid, file, text);
}

void write_notes(const ReadOptions& options, ReadReport& report) {
  // A noun with its plural and what is said of it.
  const auto note = [&](std::size_t count, const char* one, const char* many, const char* what) {
    if (count > 0)
      report.notes.push_back(fmt::format("{} {} {}", count, count == 1 ? one : many, what));
  };
  note(report.skipped_cells_2d_1d, "cell", "cells", "of dimension below 3 skipped");
  note(report.skipped_ghost_cells, "ghost cell", "ghost cells", "skipped");
  if (!options.where.empty())
    report.notes.push_back(fmt::format("{} {} left out, where not: {}", report.cells_left_out,
                                       report.cells_left_out == 1 ? "cell" : "cells",
                                       options.where));
  note(report.split_cells, "cell", "cells", "split into tetrahedra");
  note(report.quadratic_cells, "quadratic cell", "quadratic cells",
       options.quadratic == QuadraticCells::split ? "split around their nodes"
                                                  : "taken by their corners");
  note(report.added_vertices, "vertex", "vertices",
       "added at centres of faces and quadratic cells");
  note(report.curved_edges, "curved edge", "curved edges", "of quadratic cells taken as straight");
  note(report.reoriented_cells, "tetrahedron", "tetrahedra", "of negative volume turned around");
  note(report.symmetrized_tensors, "tensor", "tensors", "symmetrized");
  if (options.zero_below > 0)
    report.notes.push_back(
        fmt::format("{} {} changed by --zero-below {:g}", report.tensors_with_zeros,
                    report.tensors_with_zeros == 1 ? "tensor" : "tensors", options.zero_below));
  note(report.averaged_vertices, "vertex", "vertices",
       options.mean == MeanWeights::volume ? "given the mean of the cells around them, by volume"
                                           : "given the mean of the cells around them");
  note(report.doubled_vertices, "vertex", "vertices",
       "doubled between materials, where tensors may jump");
  note(report.merged_points, "point", "points",
       options.merge_points ? "merged with others in their place" : "merged where pieces meet");
  if (options.merge_points && report.merged_points == 0)
    report.notes.emplace_back("--merge-points: no two points have the same coordinates");
  note(report.unreferenced_points, "point", "points", "in no tetrahedron");
  if (report.torn_faces.count > 0) report.notes.push_back(report.torn_faces.text());
}

/// Merges points, and takes means of tensors of cells or points, as the options say.
void take_means(std::vector<RawGrid>& grids, VertexMap& map,
                const std::vector<std::vector<SymmetricTensor<double>>>& tensors,
                const TensorChoice& choice, const ReadOptions& options, TetMesh& mesh,
                ReadReport& report) {
  const bool means_of_points = !choice.on_cells && options.merge_points && options.mean;
  if (!choice.on_cells && !means_of_points && !(options.materials.empty() && !options.mean))
    throw IoError(IoError::Kind::inapplicable, grids.front().file,
                  std::string(options.mean ? "--mean" : "--materials") +
                      ": no means are taken of tensors at points; with --merge-points --mean they "
                      "are, of points in the same place");
  const Materials materials =
      choice.on_cells || means_of_points ? materials_of(grids, options) : Materials{};
  if (options.merge_points)
    report.merged_points +=
        merge_vertices(grids, map, choice.on_cells ? Materials{} : materials, options.mean, mesh);
  if (!choice.on_cells) return;
  report.doubled_vertices = separate_materials(grids, map, materials, mesh);
  report.averaged_vertices =
      average_cells(grids, map, tensors, choice, options.mean.value_or(MeanWeights::plain), mesh);
}

/// What is left of a file's lists when the mesh is made: the cells that were split.
struct SplitCells {
  std::vector<RawGrid> grids;  ///< cells alone; none if no cell was split
  VertexMap map;
};

/// Whether each corner of one triangle has one of the other in its place.
bool in_same_places(const TetMesh& mesh,
                    const std::array<std::array<std::int64_t, 3>, 2>& triangles) {
  const auto at = [&](std::int64_t v) { return mesh.points[static_cast<std::size_t>(v)]; };
  return std::all_of(triangles[0].begin(), triangles[0].end(), [&](std::int64_t v) {
    return std::any_of(triangles[1].begin(), triangles[1].end(),
                       [&](std::int64_t w) { return at(v) == at(w); });
  });
}

enum class Reading { field, geometry };

/// The cells that `options.where` takes; none if it says nothing.
CellSelection selected(const std::vector<RawGrid>& grids, const ReadOptions& options,
                       const TensorChoice* choice,
                       const std::vector<std::vector<SymmetricTensor<double>>>& tensors) {
  if (options.where.empty()) return {};
  return cells_where(grids, options.where, choice, tensors);
}

/// Makes the mesh of what a file lists, but for its tensors.
void assemble_geometry(std::vector<RawGrid>& grids, const ReadOptions& options,
                       ReadResult& result) {
  for (RawGrid& grid : grids)
    naming_file(grid.file, "", [&] {
      // A lattice has no more samples than an array of the file has values.
      if (grid.lattice && grid.point_data.empty() && grid.cell_data.empty())
        throw FormatError("has no arrays");
      if (grid.lattice)
        (grid.point_data.empty() ? grid.cell_data : grid.point_data).front().values();
      fill_lattice(grid);
    });
  VertexMap map = merge_points(grids, {}, result.mesh);
  if (options.merge_points)
    result.report.merged_points = merge_vertices(grids, map, {}, std::nullopt, result.mesh);
  result.mesh.tensors.assign(result.mesh.points.size(), {});
  const CellSelection selection = selected(grids, options, nullptr, {});
  assemble_cells(grids, map, selection, options.quadratic, options, result.mesh, result.report);
}

/// Makes the mesh of what a file lists.
SplitCells read_unchecked(const std::shared_ptr<const InputFile>& file, const ReadOptions& options,
                          Reading what, ReadResult& result) {
  TetMesh& mesh = result.mesh;
  ReadReport& report = result.report;
  std::vector<RawGrid> grids = read_grids(file, options, result);

  if (what == Reading::geometry) {
    assemble_geometry(grids, options, result);
    return {};
  }
  const TensorChoice choice = choose_tensor(grids, options);
  report.tensor_name = choice.name;
  report.components = choice.taken;
  if (!choice.note.empty()) report.notes.push_back(choice.note);
  std::vector<std::vector<SymmetricTensor<double>>> tensors(grids.size());
  std::size_t points = 0;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    points += grids[k].points();
    const std::size_t expected = choice.on_cells ? grids[k].cells() : grids[k].points();
    if (expected > 0)
      tensors[k] = read_tensors(grids[k], choice, options, report.symmetrized_tensors);
    naming_file(file->path, "", [&] { fill_lattice(grids[k]); });
  }

  const CellSelection selection = selected(grids, options, &choice, tensors);
  const std::vector<std::vector<SymmetricTensor<double>>> none;
  VertexMap map = merge_points(grids, choice.on_cells ? none : tensors, mesh);
  report.merged_points = points - mesh.points.size();
  const auto has_points = [](const RawGrid& grid) { return grid.points() > 0; };
  if (std::count_if(grids.begin(), grids.end(), has_points) > 1 && report.merged_points == 0)
    report.notes.emplace_back(kPiecesDoNotMeet);
  take_means(grids, map, tensors, choice, options, mesh, report);
  // A mean of cells is at their corners only.
  const bool at_corners = choice.on_cells && choice.values != CellValues::nodes;
  assemble_cells(grids, map, selection, at_corners ? QuadraticCells::corners : options.quadratic,
                 options, mesh, report);
  if (report.split_cells == 0) return {};
  for (RawGrid& grid : grids) {
    grid.coordinates = std::vector<double>();
    grid.point_data = grid.cell_data = std::vector<ArraySource>();
  }
  return {std::move(grids), map};
}

}  // namespace

namespace {

ReadResult read_checked(const std::shared_ptr<const InputFile>& file, const ReadOptions& options,
                        Reading what) {
  ReadResult result;
  const SplitCells split = read_unchecked(file, options, what, result);
  ReadReport& report = result.report;
  if (what == Reading::field && !options.where.empty()) {
    if (const NotFinite found = find_not_finite(result.mesh); found.count > 0)
      throw IoError(
          IoError::Kind::invalid, file->path,
          fmt::format("a tensor component of `{}` is no finite number at vertex {}{}, of "
                      "cells that --where takes",
                      report.tensor_name, found.vertex,
                      found.count > 1 ? fmt::format(" and {} more", found.count - 1) : ""));
  }
  if (options.zero_below > 0)
    report.tensors_with_zeros = take_as_zero(result.mesh, options.zero_below);
  const auto outer = check(file->path, result.mesh, options, report);
  report.torn_faces = torn_faces(split.grids, split.map, result.mesh, outer);
  report.unreferenced_points = count_unreferenced_points(result.mesh);
  write_notes(options, report);
  if (std::string note = note_of_nearly_isotropic(result.mesh); !note.empty())
    report.notes.push_back(std::move(note));
  if (report.torn_faces.count > 0 && options.materials.empty() &&
      in_same_places(result.mesh, report.torn_faces.vertices))
    report.notes.push_back(
        "points of torn faces are doubled; --merge-points makes one of those with equal tensors, "
        "with --mean of all in one place");
  for (std::string& note : report.notes) note = printable(std::move(note));
  return result;
}

ReadResult read_named(const std::filesystem::path& file, const ReadOptions& options, Reading what) {
  const bool names_files = format_of(file).format.names_files;  // before it is read
  try {
    return read_checked(load(file), options, what);
  } catch (const IoError& error) {
    if (!names_files || error.file() == file) throw;
    throw error.named_by(file);
  } catch (const std::bad_alloc&) {
    throw IoError(IoError::Kind::invalid, file, "is too large for this machine's memory");
  } catch (const std::length_error&) {
    throw IoError(IoError::Kind::invalid, file, "is too large for this machine's memory");
  }
}

}  // namespace

ReadResult detail::read_mesh_of(const std::shared_ptr<const InputFile>& file,
                                const ReadOptions& options) {
  return read_checked(file, options, Reading::field);
}

const char* ReadOptions::making_others() const {
  if (cell_to_point || cell_values != CellValues::one) return "--cell-to-point";
  if (tetrahedralize) return "--tetrahedralize";
  if (zero_below > 0) return "--zero-below";
  if (merge_points) return "--merge-points";
  if (!where.empty()) return "--where";
  return nullptr;
}

std::vector<std::string> ReadReport::all_notes() const {
  std::vector<std::string> all = notes;
  const bool is_plain =
      components.order == ComponentOrder::full ||
      (components.order == ComponentOrder::vtk && components.source == ComponentSource::named);
  if (!is_plain)
    all.insert(all.begin(),
               detail::printable("components of `" + tensor_name + "`: " + components.text()));
  return all;
}

ReadResult read_mesh(const std::filesystem::path& file, const ReadOptions& options) {
  return read_named(file, options, Reading::field);
}

ReadResult read_geometry(const std::filesystem::path& file, const ReadOptions& options) {
  return read_named(file, options, Reading::geometry);
}

}  // namespace tensortopo
