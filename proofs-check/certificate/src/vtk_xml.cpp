// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk_xml.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "data_arrays.hpp"
#include "file_bytes.hpp"
#include "certificate_check/check_certificate.hpp"

namespace certificate {
namespace {

constexpr std::size_t kMaxIndex = 0x7fffffff;

std::vector<std::array<double, 3>> read_points(const XmlFile& file) {
  const std::size_t count = file.count("NumberOfPoints");
  const std::vector<double> x = file.reals(file.array("Points"), 3);
  if (count > kMaxIndex || x.size() != 3 * count) file.fail("not the points that it declares");
  std::vector<std::array<double, 3>> points(count);
  for (std::size_t i = 0; i < x.size(); ++i) points[i / 3][i % 3] = x[i];
  return points;
}

/// The corners of cell i, in ascending order.
template <std::size_t Count>
std::array<std::uint32_t, Count> corners(const XmlFile& file,
                                         const std::vector<std::uint64_t>& connectivity,
                                         const std::vector<std::uint64_t>& offsets, std::size_t i,
                                         std::size_t points) {
  const std::uint64_t first = i == 0 ? 0 : offsets[i - 1];
  if (first > offsets[i] || offsets[i] - first != Count || offsets[i] > connectivity.size())
    file.fail("cell " + std::to_string(i) + " has the wrong number of corners");
  std::array<std::uint32_t, Count> result;
  for (std::size_t k = 0; k < Count; ++k) {
    if (connectivity[first + k] >= points)
      file.fail("cell " + std::to_string(i) + " has a corner that is no point");
    result[k] = static_cast<std::uint32_t>(connectivity[first + k]);
  }
  auto sorted = result;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    file.fail("cell " + std::to_string(i) + " has a corner twice");
  return result;
}

double mean(double a, double b) { return a == b ? a : a / 2 + b / 2; }

std::vector<std::array<double, 6>> read_tensors(const XmlFile& file, const std::string& name,
                                                const std::string& components,
                                                std::size_t points) {
  static const std::map<std::string, std::array<std::size_t, 6>> orders{
      {"vtk", {0, 1, 2, 3, 4, 5}}, {"voigt", {0, 1, 2, 5, 3, 4}}, {"abaqus", {0, 1, 2, 3, 5, 4}}};
  const bool full = components == "full";
  const auto order = orders.find(components);
  if (!full && order == orders.end())
    file.fail("unknown order of components '" + components.substr(0, 40) + "'");
  const std::size_t width = full ? 9 : 6;
  const std::vector<double> t = file.reals(file.array("PointData", name), width);
  if (t.size() != width * points) file.fail("not one tensor for each point");
  std::vector<std::array<double, 6>> tensors(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double* v = t.data() + width * i;
    if (full) {
      tensors[i] = {v[0], v[4], v[8], mean(v[1], v[3]), mean(v[5], v[7]), mean(v[2], v[6])};
    } else {
      for (std::size_t k = 0; k < 6; ++k) tensors[i][k] = v[order->second[k]];
    }
  }
  return tensors;
}

}  // namespace

std::string file_bytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) throw Malformed(file, "cannot be read");
  return bytes;
}

Input read_input(const std::string& name, const std::string& tensor,
                 const std::string& components) {
  const XmlFile file(name, "UnstructuredGrid");
  Input input;
  input.points = read_points(file);
  input.tensors = read_tensors(file, tensor, components, input.points.size());
  const auto connectivity = file.naturals(file.array("Cells", "connectivity"));
  const auto offsets = file.naturals(file.array("Cells", "offsets"));
  const auto types = file.naturals(file.array("Cells", "types"));
  const std::size_t cells = file.count("NumberOfCells");
  if (offsets.size() != cells || types.size() != cells) file.fail("not the cells that it declares");
  constexpr std::uint64_t kTetrahedron = 10;
  for (std::size_t i = 0; i < cells; ++i) {
    if (types[i] != kTetrahedron) continue;
    auto tet = corners<4>(file, connectivity, offsets, i, input.points.size());
    std::sort(tet.begin(), tet.end());
    input.tets.push_back(tet);
    input.cells.push_back(i);
  }
  return input;
}

Triangles read_triangles(const std::string& name) {
  const XmlFile file(name, "PolyData");
  for (const char* other : {"NumberOfVerts", "NumberOfLines", "NumberOfStrips"})
    if (file.count(other) != 0) file.fail("holds more than triangles");
  Triangles result;
  result.points = read_points(file);
  if (file.count("NumberOfPolys") == 0) return result;  // then arrays may be missing
  const auto connectivity = file.naturals(file.array("Polys", "connectivity"));
  const auto offsets = file.naturals(file.array("Polys", "offsets"));
  result.cells = file.naturals(file.array("CellData", "tet"));
  const std::size_t cells = file.count("NumberOfPolys");
  if (offsets.size() != cells || result.cells.size() != cells)
    file.fail("not the triangles that it declares");
  for (std::size_t i = 0; i < cells; ++i)
    result.triangles.push_back(
        corners<3>(file, connectivity, offsets, i, result.points.size()));
  return result;
}

}  // namespace certificate
