// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/write_surface.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "output/atomic_file.hpp"
#include "surfaces/surface_formats.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"

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
                          const std::vector<FileNote>& notes,
                          const std::vector<CellArray>& more) {
  using Format = std::string (*)(const SurfaceMesh&, const CurveMesh&);
  static const std::map<std::string, Format> formats{
      {".obj", detail::to_obj},
      {".off", [](const SurfaceMesh& s, const CurveMesh&) { return detail::to_off(s); }},
      {".ply", detail::to_ply},
      {".stl", [](const SurfaceMesh& s, const CurveMesh&) { return detail::to_stl(s); }},
      {".vtp", nullptr}};
  const std::string extension = lower_extension(file);
  const auto format = formats.find(extension);
  if (format == formats.end()) {
    std::string known;
    for (const auto& [name, unused] : formats) known += (known.empty() ? "" : ", ") + name;
    throw IoError(IoError::Kind::unwritable, file,
                  "has the unknown extension \"" + extension + "\"; known are " + known);
  }
  check(surface, mesh);
  check(curves, surface.points.size(), mesh);
  for (const CellArray& array : more)
    require(array.values.size() == surface.triangles.size(),
            "an array is not one for each triangle");
  if (!curves.lines.empty() && (extension == ".off" || extension == ".stl"))
    throw IoError(IoError::Kind::unwritable, file, "cannot hold curves: use .vtp, .ply or .obj");

  WriteReport report;
  std::string bytes;
  try {
    bytes = format->second != nullptr
                ? format->second(surface, curves)
                : detail::to_vtp(surface, curves, mesh, kinds, notes, more, report.arrays);
  } catch (const std::range_error& error) {
    throw IoError(IoError::Kind::unwritable, file,
                  std::string("cannot be written: ") + error.what());
  }
  detail::write_atomically(file, bytes);
  report.bytes = bytes.size();
  return report;
}

}  // namespace tensortopo
