// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "extract/cases/extract_case.hpp"
#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo::test {

/// A surface and what is claimed of it.
struct Certified {
  Extraction extraction;
  CertifiedLevel level;
};

inline Certified certified(const TetMesh& mesh, const std::string& mode, double resolution = 4) {
  ExtractOptions options;
  options.keep_topology = true;
  options.sampling.resolution = resolution;
  const auto value = ModeValue::parse(mode);
  Certified result;
  result.extraction = extract_mode_surface<double>(mesh, value, options);
  result.level = certify(mesh, value, result.extraction);
  return result;
}

inline TetMesh smooth_cube(int cubes, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(cubes);
  fill_with_smooth_tensors(mesh, seed);
  return mesh;
}

}  // namespace tensortopo::test
