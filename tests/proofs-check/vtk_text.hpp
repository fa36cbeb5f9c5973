// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// VTK XML files as text.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// An array of a VTK XML file, in text.
template <class Numbers>
void write_array(std::ostream& out, const std::string& type, const std::string& name, int width,
                 const Numbers& numbers) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << width
      << "\" format=\"ascii\">";
  for (const auto& x : numbers) out << x << ' ';
  out << "</DataArray>\n";
}

template <class Cells>
void write_cells(std::ostream& out, const Cells& cells) {
  std::vector<TetMesh::Index> connectivity, offsets;
  for (const auto& cell : cells) {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<TetMesh::Index>(connectivity.size()));
  }
  write_array(out, "Int64", "connectivity", 1, connectivity);
  write_array(out, "Int64", "offsets", 1, offsets);
}

inline void write_points(std::ostream& out, const std::vector<Vector3<double>>& points) {
  std::vector<double> numbers;
  for (const auto& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  out << "<Points>";
  write_array(out, "Float64", "Points", 3, numbers);
  out << "</Points>";
}

inline std::ostringstream text_stream(const char* type) {
  std::ostringstream out;
  out.precision(17);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
      << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"><" << type << '>';
  return out;
}

/// A .vtu.
inline std::string field_text(const TetMesh& mesh) {
  std::ostringstream out = text_stream("UnstructuredGrid");
  out << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\""
      << mesh.tets.size() << "\"><PointData>";
  std::vector<double> tensors;
  for (const auto& t : mesh.tensors)
    tensors.insert(tensors.end(), {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz});
  write_array(out, "Float64", "stress", 6, tensors);
  out << "</PointData>";
  write_points(out, mesh.points);
  out << "<Cells>";
  write_cells(out, mesh.tets);
  write_array(out, "UInt8", "types", 1, std::vector<int>(mesh.tets.size(), 10));
  out << "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
  return out.str();
}

}  // namespace tensortopo::test
