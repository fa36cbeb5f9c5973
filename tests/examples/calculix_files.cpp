// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "calculix_files.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace tensortopo::test {

using namespace scenarios;

namespace {

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

template <class... Numbers>
std::string integers(Numbers... numbers) {
  std::string bytes;
  (append(bytes, static_cast<std::int32_t>(numbers)), ...);
  return bytes;
}

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, numbers...);
  return buffer;
}

}  // namespace

std::string record(const std::string& bytes) {
  const std::string mark = integers(bytes.size());
  return mark + bytes + mark;
}

std::string restart_bytes(const RestartFile& content) {
  const auto nodes = content.points.size(), elements = content.stresses.size();
  std::string file = record("Version 2.20" + std::string(68, ' '));
  for (int i = 1; i < 9; ++i) file += record(integers(i));
  file += record(integers(nodes)) + record(integers(elements)) + record(integers(0)) +
          record(integers(11 * elements)) + record(integers(8, 3, 1)) +
          record("BOTTOM" + std::string(75, ' ')) + record("");
  std::string points, displacements, stresses;
  for (const auto& p : content.points)
    for (const double x : {p.x, p.y, p.z}) append(points, x);
  for (const auto& u : content.displacements)
    for (const double x : {273.0, u.x, u.y, u.z}) append(displacements, x);
  for (const auto& hex : content.stresses)
    for (const auto& t : hex)
      for (const double x : {t.xx, t.yy, t.zz, t.xy, t.xz, t.yz}) append(stresses, x);
  return file + record(points) + record(std::string(8 * elements, 'C')) + record(displacements) +
         record(stresses) + record(std::string(stresses.size(), '\0'));
}

std::string frd_bytes(const HexMesh& mesh, const std::vector<Vector3<double>>& displacements,
                      const std::vector<SymmetricTensor<double>>& stresses) {
  const auto nodes = static_cast<int>(mesh.points.size());
  const auto hexes = static_cast<int>(mesh.hexes.size());
  const auto head = [&](int kind) {
    return text("  100CL  101 1.000000000%12d                     0    1           %d\n", nodes,
                kind);
  };
  std::string file = "    1C\n    1UUSER\n" + text("    2C%18s%12d%37s%d\n", "", nodes, "", 3);
  for (int i = 0; i < nodes; ++i) {
    const auto& p = mesh.points[static_cast<std::size_t>(i)];
    file += integers(i + 1);
    for (const double x : {p.x, p.y, p.z}) append(file, x);
  }
  file += text("    3C%18s%12d%37s%d\n", "", hexes, "", 2);
  for (int h = 0; h < hexes; ++h) {
    file += integers(h + 1, 1, 0, 1);
    for (const Index corner : mesh.hexes[static_cast<std::size_t>(h)]) file += integers(corner + 1);
  }
  file += "    1PSTEP                         1           1           1\n" + head(2) +
          " -4  DISP        4    1\n -5  D1          1    2    1    0\n"
          " -5  D2          1    2    2    0\n -5  D3          1    2    3    0\n"
          " -5  ALL         1    2    0    0    1ALL\n";
  for (int i = 0; i < nodes; ++i) {
    const auto& u = displacements[static_cast<std::size_t>(i)];
    file += integers(i + 1);
    for (const double x : {u.x, u.y, u.z}) append(file, static_cast<float>(x));
  }
  file += head(2) + " -4  STRESS      6    1\n";
  for (const char* name : {"SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"})
    file += std::string(" -5  ") + name + "         1    4    1    1\n";
  for (int i = 0; i < nodes; ++i) {
    const auto& t = stresses[static_cast<std::size_t>(i)];
    file += integers(i + 1);
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) append(file, static_cast<float>(x));
  }
  file += head(2) + " -4  ERROR       1    1\n -5  STR(%)      1    1    0    0\n";
  for (int i = 0; i < nodes; ++i) {
    file += integers(i + 1);
    append(file, 1.0f);
  }
  return file + " 9999\n";
}

std::string dat_text(const Reactions& reactions) {
  std::string file = "\n forces (fx,fy,fz) for set BOTTOM and time  0.1000000E+01\n\n";
  for (const auto& [point, f] : reactions.nodes)
    file += text("%10d %13.6E %13.6E %13.6E\n", point + 1, f.x, f.y, f.z);
  file += "\n total force (fx,fy,fz) for set BOTTOM and time  0.1000000E+01\n\n";
  return file + text("       %13.6E %13.6E %13.6E\n", reactions.total.x, reactions.total.y,
                     reactions.total.z);
}

std::vector<RestartFile::HexStress> sampled(
    const HexMesh& mesh,
    const std::function<SymmetricTensor<double>(const Vector3<double>&)>& stress) {
  // Signs of the corners in the order of a hexahedron.
  constexpr double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  const double g = 1 / std::sqrt(3.0);
  std::vector<RestartFile::HexStress> all;
  for (const auto& hex : mesh.hexes) {
    RestartFile::HexStress values;
    for (unsigned i = 0; i < 8; ++i) {
      const double at[3] = {i & 1 ? g : -g, i & 2 ? g : -g, i & 4 ? g : -g};
      Vector3<double> p;
      for (std::size_t c = 0; c < 8; ++c) {
        double shape = 1;
        for (int axis = 0; axis < 3; ++axis) shape *= (1 + sign[c][axis] * at[axis]) / 2;
        p += shape * mesh.points[static_cast<std::size_t>(hex[c])];
      }
      values[i] = stress(p);
    }
    all.push_back(values);
  }
  return all;
}

void put(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace tensortopo::test
