// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/read_mesh.hpp"

#include <cstdint>
#include <memory>
#include <new>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "bytes/input_file.hpp"
#include "fields/assemble_cells.hpp"
#include "fields/merge_points.hpp"
#include "fields/raw_grid.hpp"
#include "fields/read_legacy.hpp"
#include "fields/read_mesh_of.hpp"
#include "fields/read_vtu.hpp"
#include "fields/tensor_array.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/mesh/validate.hpp"
#include "fields/torn_faces.hpp"

namespace tensortopo {
namespace {

using namespace detail;

std::vector<RawGrid> read_pieces(const std::shared_ptr<const InputFile>& index, Sha256& sum) {
  std::vector<RawGrid> grids;
  std::set<std::filesystem::path> seen;
  for (const auto& path : read_pvtu(index)) {
    const auto piece = load(path);
    if (!seen.insert(std::filesystem::canonical(path)).second)
      throw IoError(IoError::Kind::invalid, index->path,
                    "names a piece twice (" + path.filename().string() + ")");
    sum.add(piece->bytes);
    for (RawGrid& grid : read_vtu(piece)) grids.push_back(std::move(grid));
  }
  return grids;
}

void require_known_extension(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".vtu" && extension != ".pvtu" && extension != ".vtk")
    throw IoError(IoError::Kind::invalid, path,
                  "has the unknown extension \"" + extension + "\"; known are .vtu, .pvtu, .vtk");
}

std::vector<RawGrid> read_grids(const std::shared_ptr<const InputFile>& file, bool for_certificate,
                                std::string& sha256) {
  const std::filesystem::path& path = file->path;
  const std::string extension = lower_extension(path);
  if (for_certificate && extension == ".pvtu")
    throw IoError(IoError::Kind::inapplicable, path,
                  "names files of pieces, but a certificate is about the numbers in one file as "
                  "they are; merge them into one .vtu");
  Sha256 sum;
  sum.add(file->bytes);
  std::vector<RawGrid> grids;
  if (extension == ".vtu") grids = read_vtu(file, for_certificate);
  if (extension == ".pvtu") grids = read_pieces(file, sum);
  if (extension == ".vtk") grids.push_back(read_legacy(file));
  sha256 = sum.hex();
  return grids;
}

/// Refuses meshes that are unfit; else their outer faces.
std::vector<OuterFace> check(const std::filesystem::path& file, const TetMesh& mesh) {
  if (mesh.tets.empty()) throw IoError(IoError::Kind::invalid, file, "has no tetrahedra");
  if (mesh.tets.size() > INT32_MAX)
    throw IoError(IoError::Kind::invalid, file, "has too many tetrahedra");
  std::vector<OuterFace> outer;
  const std::vector<MeshDefect> defects = validate(mesh, &outer);
  if (defects.empty()) return outer;
  std::string text = defects.front().text;
  if (defects.size() > 1)
    text += "; " + std::to_string(defects.size() - 1) + " more defects" +
            (defects.size() >= 1000 ? " at least" : "");
  throw IoError(IoError::Kind::invalid, file, text);
}

void write_notes(const ReadOptions& options, ReadReport& report) {
  const auto note = [&](std::size_t count, const char* what) {
    if (count > 0) report.notes.push_back(std::to_string(count) + " " + what);
  };
  note(report.skipped_cells_2d_1d, "cells of dimension below 3 skipped");
  note(report.skipped_ghost_cells, "ghost cells skipped");
  note(report.split_cells, "cells split into tetrahedra");
  note(report.quadratic_cells, options.quadratic == QuadraticCells::split
                                   ? "quadratic cells split around their nodes"
                                   : "quadratic cells taken by their corners");
  note(report.added_vertices, "vertices added at centres of faces and quadratic cells");
  note(report.curved_edges, "edges of quadratic cells are curved and taken as straight");
  note(report.reoriented_cells, "tetrahedra of negative volume turned around");
  note(report.symmetrized_tensors, "tensors symmetrized");
  note(report.averaged_vertices, "vertices given the mean of the cells around them");
  note(report.merged_points, "points merged where pieces meet");
  note(report.unreferenced_points, "points belong to no tetrahedron");
  if (report.torn_faces.count > 0) report.notes.push_back(report.torn_faces.text());
}

/// What is left of a file's lists when the mesh is made: the cells that were split.
struct SplitCells {
  std::vector<RawGrid> grids;  ///< cells alone; none if no cell was split
  VertexMap map;
};

/// Makes the mesh of what a file lists.
SplitCells read_unchecked(const std::shared_ptr<const InputFile>& file, const ReadOptions& options,
                          ReadResult& result) {
  TetMesh& mesh = result.mesh;
  ReadReport& report = result.report;
  std::vector<RawGrid> grids = read_grids(file, options.for_certificate, result.sha256);

  const TensorChoice choice = choose_tensor(grids, options);
  report.tensor_name = choice.name;
  report.components = choice.taken;
  std::vector<std::vector<SymmetricTensor<double>>> tensors(grids.size());
  std::size_t points = 0;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    points += grids[k].points();
    const std::size_t expected = choice.on_cells ? grids[k].cells() : grids[k].points();
    if (expected > 0)
      tensors[k] = read_tensors(grids[k], choice, options, report.symmetrized_tensors);
  }

  const std::vector<std::vector<SymmetricTensor<double>>> none;
  const VertexMap map = merge_points(grids, choice.on_cells ? none : tensors, mesh);
  report.merged_points = points - mesh.points.size();
  assemble_cells(grids, map, choice.on_cells ? tensors : none, options, mesh, report);
  if (report.split_cells == 0) return {};
  for (RawGrid& grid : grids) {
    grid.coordinates = std::vector<double>();
    grid.point_data = grid.cell_data = std::vector<ArraySource>();
  }
  return {std::move(grids), map};
}

}  // namespace

ReadResult detail::read_mesh_of(const std::shared_ptr<const InputFile>& file,
                                const ReadOptions& options) {
  ReadResult result;
  const SplitCells split = read_unchecked(file, options, result);
  ReadReport& report = result.report;
  report.torn_faces = torn_faces(split.grids, split.map, result.mesh, check(file->path, result.mesh));
  report.unreferenced_points = count_unreferenced_points(result.mesh);
  write_notes(options, report);
  return result;
}

std::vector<std::string> ReadReport::all_notes() const {
  std::vector<std::string> all = notes;
  const bool is_plain = components.order == ComponentOrder::full ||
                        (components.order == ComponentOrder::vtk &&
                         components.source == ComponentSource::named);
  if (!is_plain)
    all.insert(all.begin(), "components of `" + tensor_name + "`: " + components.text());
  return all;
}

std::string TornFaces::text() const {
  if (count == 0) return {};
  const auto face = [&](std::size_t side) {
    const auto& v = vertices[side];
    return fmt::format("{} {} {} of cell {}", v[0], v[1], v[2], cells[side]);
  };
  return fmt::format(
      "{} faces lie on others that they are not (vertices {}, on {}): surfaces are torn there",
      count, face(0), face(1));
}

ReadResult read_mesh(const std::filesystem::path& file, const ReadOptions& options) {
  try {
    require_known_extension(file);
    return read_mesh_of(load(file), options);
  } catch (const std::bad_alloc&) {
    throw IoError(IoError::Kind::invalid, file, "is too large for this machine's memory");
  } catch (const std::length_error&) {
    throw IoError(IoError::Kind::invalid, file, "is too large for this machine's memory");
  }
}

}  // namespace tensortopo
