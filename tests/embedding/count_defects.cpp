// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <map>

#include "embedding/field_surface.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/read_mesh.hpp"

/// count_defects FIELD NUMERATOR/DENOMINATOR...: extracts the level of each mode and prints what is
/// wrong with it as a surface in space.
int main(int count, char** arguments) {
  using namespace tensortopo;
  ReadOptions options;
  options.tetrahedralize = true;
  const auto mesh = read_mesh(arguments[1], options).mesh;
  const auto field = embedding::field_of(mesh);
  for (int k = 2; k < count; ++k) {
    embedding::Mode mode{0, 1};
    if (std::sscanf(arguments[k], "%ld/%ld", &mode.numerator, &mode.denominator) < 1) return 2;
    const auto start = std::chrono::steady_clock::now();
    const auto result = extract_mode_surface<double>(mesh, ModeValue::parse(arguments[k]));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const auto surface = embedding::surface_of(result.surface);
    const auto found = embedding::intersections(surface);
    const auto against = embedding::against_gradient(surface, field);
    const auto off = embedding::residuals(surface, field, mode);
    std::array<std::size_t, 3> where{};
    for (const auto& pair : found.pairs) ++where[static_cast<std::size_t>(pair.where)];
    std::printf(
        "%s mode %s: %zu triangles, %zu unresolved, %.2f s; intersecting pairs: %zu in one sheet, "
        "%zu in two sheets, %zu in two tetrahedra; without area: %zu; against the gradient: %zu at "
        "centroids, %zu at corners; largest residual %.3g, off: %zu of %zu\n",
        arguments[1], arguments[k], surface.triangles.size(), result.unresolved.size(),
        seconds.count(), where[0], where[1], where[2], found.without_area,
        against.at_centroid.size(), against.at_corners, off.largest, off.off, off.compared);
    std::fflush(stdout);
    if (std::getenv("TETS") != nullptr) {
      std::map<int, std::array<int, 2>> tets;
      for (const auto& pair : found.pairs) ++tets[surface.tet[pair.first]][0];
      for (const auto t : against.at_centroid) ++tets[surface.tet[t]][1];
      for (const auto& [t, counts] : tets)
        std::printf("tet %d pairs %d against %d\n", t, counts[0], counts[1]);
    }
  }
}
