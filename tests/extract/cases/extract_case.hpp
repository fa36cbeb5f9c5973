// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "extract/level/proofs/is_above.hpp"
#include "support/fields/random_fields.hpp"
#include "support/surfaces/topology.hpp"
#include "support/trials.hpp"
#include "support/fields/witness_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/scaled_field.hpp"

namespace tensortopo::test {

/// The levels at which random fields are extracted.
inline const std::array<const char*, 10> kLevels{"0",    "1e-6", "1/10",  "-1/10",  "1/2",
                                                 "-1/2", "9/10", "-9/10", "99/100", "-99/100"};

/// Says which seed a test meshes from, in its output and in its failures.
std::string announce(std::uint64_t seed);

ModeValue mode_of(const Fraction& fraction);

template <class Scalar = double>
Extraction extract(const TetMesh& mesh, const std::string& mode) {
  return extract_mode_surface<Scalar>(mesh, ModeValue::parse(mode));
}

/// The reasons given for tetrahedra that were not extracted, "" if there are none.
std::string unresolved_text(const Extraction& extraction);

/// Components of the surface and its vertices on the edges of the only tetrahedron.
LocalTopology topology_in_tet(const Extraction& extraction);

/// Components of a surface in any mesh, and how many vertices lie on edges, in faces, inside.
struct SurfaceSummary {
  std::vector<ComponentTopology> components;
  std::size_t on_edges = 0;

  friend bool operator==(const SurfaceSummary&, const SurfaceSummary&) = default;
};
SurfaceSummary summary(const SurfaceMesh& surface);
std::ostream& operator<<(std::ostream& out, const SurfaceSummary& s);

/// Everything that can be wrong with an extracted surface, in words; "" if nothing is.
///
/// Edges with one triangle must lie in a face of the boundary of the domain, from which unresolved
/// tetrahedra are taken out; which face that is comes from the vertices' carriers alone. In a face
/// between two tetrahedra, each of the two must have one of the edge's triangles.
struct SoundnessOptions {
  bool residuals = true;
  bool coincidences = true;  ///< two vertices at one point count
};
std::string flaws(const Extraction& extraction, const TetMesh& mesh,
                  const SoundnessOptions& options = {});

/// A simplex of its own, as the extraction sees it.
template <class Scalar, std::size_t Vertices>
struct SimplexCase {
  explicit SimplexCase(const std::array<SymmetricTensor<double>, Vertices>& tensors,
                       const ModeValue& mode)
      : mesh(bare_mesh(tensors)), field(mesh), level(make_level<Scalar>(mode)) {
    std::vector<char> above(Vertices);
    for (std::size_t i = 0; i < Vertices; ++i) {
      const LevelSimplex<Scalar, 2> point = field.template simplex<2>(
          std::array<std::size_t, 2>{i, i}, std::vector<char>(Vertices, 0));
      above[i] = is_above<Scalar, 2>(point, field.tensors[i], {1.0, 0.0}, level);
    }
    std::array<std::size_t, Vertices> all{};
    for (std::size_t i = 0; i < Vertices; ++i) all[i] = i;
    simplex = field.template simplex<Vertices>(all, above);
  }
  SimplexCase(const SimplexCase&) = delete;
  SimplexCase& operator=(const SimplexCase&) = delete;

  /// The edge between two of the vertices.
  LevelSimplex<Scalar, 2> edge(std::size_t i, std::size_t j) const {
    return field.template simplex<2>(std::array<std::size_t, 2>{i, j}, sides());
  }
  LevelSimplex<Scalar, 3> face(std::size_t i, std::size_t j, std::size_t k) const {
    return field.template simplex<3>(std::array<std::size_t, 3>{i, j, k}, sides());
  }

  TetMesh mesh;
  ScaledField<Scalar> field;
  Level<Scalar> level;
  LevelSimplex<Scalar, Vertices> simplex;

 private:
  static TetMesh bare_mesh(const std::array<SymmetricTensor<double>, Vertices>& tensors) {
    TetMesh mesh;
    mesh.tensors.assign(tensors.begin(), tensors.end());
    mesh.points.resize(Vertices);
    return mesh;
  }
  std::vector<char> sides() const {
    return std::vector<char>(simplex.above.begin(), simplex.above.end());
  }
};

}  // namespace tensortopo::test
