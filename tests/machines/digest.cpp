// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Prints hashes of what is computed of some fields: surfaces with all arrays, certificates,
// degenerate curves, critical values. Machines, compilers and options must not change a line.
// Usage: digest SEEDS
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/families/field_family.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"

namespace {

using namespace tensortopo;

constexpr std::array kModes{"0",    "1/10",  "-1/10",  "1/2",        "-1/2",
                            "9/10", "-9/10", "99/100", "-9999/10000"};

std::string sha256(const std::string& bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.hex();
}

void print_surface(const TetMesh& mesh, const ModeValue& mode) {
  ExtractOptions options;
  options.keep_topology = true;
  Extraction extraction = extract_mode_surface<double>(mesh, mode, options);
  std::string arrays;
  for (const ArrayHash& array : array_hashes(extraction.surface)) arrays += array.sha256;
  const std::string surface = surface_sha256(extraction.surface, mesh);
  const std::size_t triangles = extraction.surface.triangles.size();
  const CertifiedLevel level = certify(mesh, mode, extraction);
  const std::string certificate =
      certificate_bytes({}, std::span(&level, 1), mesh, CertificateEncoding::json);
  std::printf("  mode %s: %zu triangles, surface %s, arrays %s, certificate %s\n",
              mode.text().c_str(), triangles, surface.c_str(), sha256(arrays).c_str(),
              sha256(certificate).c_str());
}

void print_curves(const TetMesh& mesh, Degeneracy kind) {
  const CurveExtraction extraction = extract_degenerate_curves(mesh, kind);
  std::string arrays;
  for (const ArrayHash& array : array_hashes(extraction.curves)) arrays += array.sha256;
  std::printf("  curves %s: %zu lines, %s, arrays %s\n",
              kind == Degeneracy::linear ? "linear" : "planar", extraction.curves.lines.size(),
              curves_sha256(extraction.curves, mesh).c_str(), sha256(arrays).c_str());
}

void print_critical_values(const TetMesh& mesh) {
  const MeshCriticalValues values = mesh_critical_values(mesh, -1, 1);
  std::vector<double> numbers;
  for (const MeshCriticalPoint& point : values.points) {
    numbers.insert(numbers.end(),
                   {point.low, point.high, point.point.x, point.point.y, point.point.z,
                    static_cast<double>(point.dimension), static_cast<double>(point.index)});
    numbers.insert(numbers.end(), point.weights.begin(), point.weights.end());
  }
  std::printf("  critical values: %zu, %s\n", values.points.size(),
              numbers_sha256(numbers).c_str());
}

void print_field(FieldKind kind, std::uint64_t seed) {
  FamilyRequest request;
  request.seed = seed;
  request.members = 20;
  request.member = static_cast<int>(seed % 20);
  request.tetrahedra = kind == FieldKind::block ? 100 : 40;
  const TetMesh mesh = family_member(kind, request).mesh;
  std::printf("%s, seed %d: %zu tetrahedra, %s\n", std::string(name_of(kind)).c_str(),
              static_cast<int>(seed), mesh.tets.size(), field_sha256(mesh).c_str());
  for (const char* mode : kModes) print_surface(mesh, ModeValue::parse(mode));
  print_curves(mesh, Degeneracy::linear);
  print_curves(mesh, Degeneracy::planar);
  print_critical_values(mesh);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  const int seeds = count == 2 ? std::atoi(words[1]) : 0;
  if (seeds < 1) {
    std::fputs("usage: digest SEEDS\n", stderr);
    return 2;
  }
  for (int seed = 1; seed <= seeds; ++seed)
    for (const FieldKind kind : all_field_kinds())
      print_field(kind, static_cast<std::uint64_t>(seed));
  return 0;
}
