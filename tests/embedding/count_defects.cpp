// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "embedding/field_surface.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace {

/// Extracts the level of a mode and prints what is wrong with it as a surface in space.
void print_defects(const tensortopo::TetMesh& mesh, const char* text,
                   const tensortopo::ExtractOptions& options) {
  using namespace tensortopo;
  embedding::Mode mode{0, 1};
  if (std::sscanf(text, "%" SCNd64 "/%" SCNd64, &mode.numerator, &mode.denominator) < 1)
    throw std::invalid_argument("not a mode like 1/2: " + std::string(text));
  const auto start = std::chrono::steady_clock::now();
  const auto result = extract_mode_surface<double>(mesh, ModeValue::parse(text), options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const auto surface = embedding::surface_of(result.surface);
  const auto field = embedding::field_of(mesh);
  const auto found = embedding::intersections(surface);
  const auto against = embedding::against_gradient(surface, field);
  const auto off = embedding::residuals(surface, field, mode);
  std::array<std::size_t, 3> where{};
  for (const auto& pair : found.pairs) ++where[static_cast<std::size_t>(pair.where)];
  std::printf("mode %s: %zu triangles, %zu unresolved, %zu not embedded, %.2f s; ", text,
              surface.triangles.size(), result.unresolved.size(), result.not_embedded.size(),
              seconds.count());
  std::printf("intersecting pairs: %zu in one sheet, %zu in two sheets, %zu in two tetrahedra; ",
              where[0], where[1], where[2]);
  std::printf("without area: %zu; against the gradient: %zu at centroids, %zu at corners; ",
              found.without_area, against.at_centroid.size(), against.at_corners);
  std::printf("largest residual %.3g, off: %zu of %zu\n", off.largest, off.off.size(),
              off.compared);
  for (const auto t : result.not_embedded) std::printf("  not embedded: tetrahedron %d\n", t);
  for (const auto v : off.off) {
    const auto& p = surface.points[v];
    std::printf("  off: vertex %zu at %.17g %.17g %.17g, carrier %d\n", v, p[0], p[1], p[2],
                static_cast<int>(result.surface.carrier[v]));
  }
  std::fflush(stdout);
}

}  // namespace

/// count_defects [--as-meshed] FIELD MODE...: modes are whole numbers or fractions of them.
/// @param --as-meshed  without `ExtractOptions::embedded`
int main(int count, char** arguments) {
  tensortopo::ExtractOptions options;
  int next = 1;
  if (next < count && std::string(arguments[next]) == "--as-meshed")
    options.embedded = false, ++next;
  if (count < next + 2) {
    std::fputs("usage: count_defects [--as-meshed] FIELD MODE...\n", stderr);
    return 2;
  }
  try {
    tensortopo::ReadOptions reading;
    reading.tetrahedralize = true;
    const auto mesh = tensortopo::read_mesh(arguments[next], reading).mesh;
    for (int k = next + 1; k < count; ++k) print_defects(mesh, arguments[k], options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "count_defects: %s\n", error.what());
    return 1;
  }
  return 0;
}
