// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A certificate as FORMAT.md describes it.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace certificate {

using Number = std::uint64_t;

struct CrossingClaim {
  mpz_class i;  ///< from i / 2^k to (i + 1) / 2^k, inside [0, 1]
  unsigned k = 0;
  Number vertex = 0;
};
struct EdgeClaim {
  std::array<Number, 2> edge{};
  std::vector<CrossingClaim> crossings;
};
struct FaceClaim {
  std::array<Number, 3> face{};
  std::vector<std::array<Number, 2>> arcs;
  std::vector<Number> loops;
};
struct SheetClaim {
  std::int64_t euler_characteristic = 0;
  std::vector<std::vector<Number>> loops;  ///< crossing, face, crossing, face, ...
};
struct TetClaim {
  Number tet = 0;
  std::vector<SheetClaim> sheets;
};
struct ComponentClaim {
  std::int64_t euler_characteristic = 0, boundary_loops = 0;
  bool orientable = true;
  Number triangles = 0, first_vertex = 0;

  bool operator==(const ComponentClaim&) const = default;
};
struct DistanceClaim {
  std::vector<std::int64_t> reach;
  double bound = 0, coarse_bound = 0;
  std::vector<Number> coarse;
};
struct LevelClaims {
  std::string mode;
  mpz_class numerator, denominator;
  std::array<Number, 2> vertices{}, triangles{};  ///< first, count
  Number on_level = 0;
  std::vector<std::pair<Number, std::string>> undecided;
  std::vector<EdgeClaim> edges;
  std::vector<FaceClaim> faces;
  std::vector<TetClaim> tets;
  std::vector<ComponentClaim> components;
  std::optional<DistanceClaim> distance;
};
struct Claims {
  std::string tensor, components, input_sha256, surface_sha256;
  Number points = 0, tetrahedra = 0, vertices = 0, triangles = 0;
  std::vector<LevelClaims> levels;
};

/// Reads a certificate, JSON or CBOR. Throws Malformed. Order and ranges are checked as far as
/// the format itself says so; whether claims are true is not.
Claims read_claims(const std::string& file);

}  // namespace certificate
