// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/write_surface.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "output/atomic_file.hpp"
#include "surfaces/surface_format.hpp"
#include "surfaces/write_formats.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("write_surface: ") + what);
}

template <class Values>
bool fits(const Values& values, std::size_t size) {
  return values.empty() || values.size() == size;
}

void check(const SurfaceMesh& s, const TetMesh& mesh) {
  const std::size_t points = s.points.size();
  require(fits(s.medium_eigenvector, points) && fits(s.dominant_eigenvector, points) &&
              fits(s.normal, points) && fits(s.mode, points) && fits(s.residual, points),
          "an array is not one for each point");
  require(fits(s.tet, s.triangles.size()) && fits(s.component, s.triangles.size()),
          "an array is not one for each triangle");
  const auto below = [](auto index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
  };
  for (const auto& t : s.triangles)
    for (const auto v : t)
      require(below(v, points), "a triangle names a point that does not exist");
  for (const auto t : s.tet)
    require(below(t, mesh.cell_ids.size()),
            "a triangle names a tetrahedron that has no entry in the mesh's cell_ids");
}

void check(const CurveMesh& c, std::size_t surface_points, const TetMesh& mesh) {
  const std::size_t points = c.points.size();
  require(fits(c.dominant_eigenvector, points) && fits(c.mode, points) &&
              fits(c.separation, points) && fits(c.residual, points),
          "an array of the curves is not one for each point");
  require(fits(c.tet, c.lines.size()) && fits(c.component, c.lines.size()),
          "an array is not one for each line");
  require(points <= static_cast<std::size_t>(std::numeric_limits<CurveMesh::Index>::max()) -
                        std::min(surface_points, points),
          "more points than 32 bits can number");
  const auto below = [](auto index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
  };
  for (const auto& line : c.lines) {
    require(line.size() > 1, "a line has fewer than two points");
    for (const auto v : line) require(below(v, points), "a line names a point that does not exist");
  }
  for (const auto t : c.tet)
    require(below(t, mesh.cell_ids.size()),
            "a line names a tetrahedron that has no entry in the mesh's cell_ids");
}

}  // namespace

WriteReport write_surface(const SurfaceMesh& surface, const TetMesh& mesh,
                          const std::filesystem::path& file, const OutputKinds& kinds) {
  return write_surface(surface, CurveMesh{}, mesh, file, kinds);
}

WriteReport write_surface(const SurfaceMesh& surface, const CurveMesh& curves, const TetMesh& mesh,
                          const std::filesystem::path& file, const OutputKinds& kinds,
                          const std::vector<FileNote>& notes, const std::vector<CellArray>& more) {
  const detail::SurfaceFormatEntry* const entry = detail::surface_entry_of(file);
  if (entry == nullptr)
    throw IoError(IoError::Kind::unwritable, file, "the name must end in " + surface_extensions());
  check(surface, mesh);
  check(curves, surface.points.size(), mesh);
  for (const CellArray& array : more)
    require(array.of_points ? array.values.size() == surface.points.size() &&
                                  fits(array.line_values, curves.points.size())
                            : array.values.size() == surface.triangles.size() &&
                                  fits(array.line_values, curves.lines.size()),
            "an array is not one for each triangle and line, or each point");
  if (!curves.lines.empty() && !entry->format.holds_curves)
    throw IoError(IoError::Kind::unwritable, file,
                  "cannot hold curves: use " + surface_extensions(true));

  WriteReport report;
  detail::OutputFile output(file);
  if (entry->write == nullptr) {
    detail::write_vtp(surface, curves, mesh, kinds, notes, more, output, report.arrays);
  } else {
    try {
      output.append(entry->write(surface, curves));
    } catch (const std::range_error& error) {
      throw IoError(IoError::Kind::unwritable, file,
                    std::string("cannot be written: ") + error.what());
    }
    output.finish();
  }
  report.bytes = output.size();
  return report;
}

}  // namespace tensortopo
