// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// Where parts of a mesh meet, if `ExtractOptions::part` tells parts apart.
class PartSeam {
 public:
  PartSeam(const ExtractOptions& options, const TetComplex& cells)
      : part_(options.part), cells_(cells) {}

  bool exists() const { return !part_.empty(); }

  /// Whether two tetrahedra are of different parts.
  bool parts(std::size_t t, std::size_t u) const {
    return exists() && part_[as_size(cells_.tets[t])] != part_[as_size(cells_.tets[u])];
  }

  /// The tetrahedron across a face, if it is of another part; else -1.
  TetMesh::Index across(std::size_t t, std::size_t face) const {
    const auto& both = cells_.face_tets[as_size(cells_.tet_faces[t][face])];
    const auto other = as_size(both[0]) == t ? both[1] : both[0];
    return other >= 0 && parts(t, as_size(other)) ? other : -1;
  }

 private:
  const std::vector<char>& part_;
  const TetComplex& cells_;
};

}  // namespace tensortopo
