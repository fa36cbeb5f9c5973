// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::test {

inline std::filesystem::path slab_file() {
  return std::filesystem::path(TENSORTOPO_EXAMPLE_DATA) / "s4_slab_small_C3D8I.vtu";
}

/// Radii for the slab: most a thousandth of the deviator, larger towards one side.
inline std::vector<double> slab_radii() {
  const TetMesh mesh = read_mesh(slab_file()).mesh;
  std::vector<double> radii;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    radii.push_back(std::abs(mesh.tensors[v].xx - mesh.tensors[v].zz) *
                    (v % 7 == 0 ? 0.02 : 0.0005));
  return radii;
}

/// Writes the slab as legacy .vtk, with an array `error` of radii at its points, and returns the
/// file.
inline std::string write_slab(const std::filesystem::path& file, const std::vector<double>& radii) {
  const TetMesh mesh = read_mesh(slab_file()).mesh;
  std::ofstream out(file);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "# vtk DataFile Version 3.0\nslab\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS "
      << mesh.points.size() << " double\n";
  for (const auto& p : mesh.points) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
  out << "CELLS " << mesh.tets.size() << ' ' << 5 * mesh.tets.size() << '\n';
  for (const auto& tet : mesh.tets)
    out << 4 << ' ' << tet[0] << ' ' << tet[1] << ' ' << tet[2] << ' ' << tet[3] << '\n';
  out << "CELL_TYPES " << mesh.tets.size() << '\n';
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) out << "10\n";
  out << "POINT_DATA " << mesh.points.size() << "\nTENSORS6 S double\n";
  for (const auto& t : mesh.tensors)
    out << t.xx << ' ' << t.yy << ' ' << t.zz << ' ' << t.xy << ' ' << t.yz << ' ' << t.xz << '\n';
  out << "SCALARS error double\nLOOKUP_TABLE default\n";
  for (const double r : radii) out << r << '\n';
  return file.string();
}

}  // namespace tensortopo::test
