// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// A mode surface sampled until it is proved to be close to the level.
struct ExtractionWithin {
  Extraction extraction;  ///< the last one, of the densest samples
  CertifiedLevel level;  ///< what is claimed of it
  int rounds = 0;        ///< extractions that it took
  /// Tetrahedra, positions in the mesh, for which the distance asked for is not proved.
  std::vector<TetMesh::Index> farther;
};

/// The mode surface with proved distance bounds, both ways, of at most `largest_distance`: where
/// the bound is larger, the tetrahedron and its faces are sampled twice as densely, and all is
/// extracted again. Topology is that of the plain extraction. The bound is one by moved triangles,
/// or by parts of the tetrahedron: see `certify`.
///
/// A tetrahedron in which denser samples stop to help is given up, and listed in `farther`. So is
/// one that has more than 5,000 triangles (a doubling may have made 20,000 of fewer): it would soon
/// take longer than all others; and one where coordinates are rounded by more than the distance.
/// Where the distance is too small for a proof by parts, the smallest one for which that is tried
/// is proved, if it can be.
///
/// @param largest_distance  in the mesh's units, > 0
/// @param options  `density` is where sampling begins; `keep_topology` is about `extraction`
ExtractionWithin extract_within(const TetMesh& mesh, const ModeValue& mode,
                                double largest_distance, const ExtractOptions& options = {});

}  // namespace tensortopo
