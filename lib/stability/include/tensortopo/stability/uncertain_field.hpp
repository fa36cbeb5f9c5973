// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// How much the deviators of a field may be in error.
struct Uncertainty {
  /// How the radii are given.
  enum class Kind {
    absolute,    ///< the same at each vertex
    relative,    ///< a share of the vertex' own deviator
    per_vertex,  ///< a radius for each
  };
  Kind kind = Kind::absolute;  ///< how the radii are given
  double value = 0;            ///< absolute: in units of the tensor; relative: 0.01 for one percent
  std::vector<double> radii;   ///< per vertex
  /// Of radii per vertex: the input's array that has them, empty if none does; and their SHA-256
  /// (`numbers_sha256`).
  std::string array = {}, radii_sha256 = {};
};

/// Reads "0.5" (in units of the tensor) or "1%" (of each vertex' deviator). Throws
/// std::invalid_argument, with the reason, for anything else.
Uncertainty parse_uncertainty(std::string_view text);

/// The largest Frobenius norm that the error of the deviator may have at each vertex, rounded up.
/// Throws std::invalid_argument if a number is negative or not finite, or not one a vertex is
/// given.
std::vector<double> vertex_radii(const TetMesh& mesh, const Uncertainty& uncertainty);

/// All piecewise linear fields of which the deviator at each vertex differs from that of a mesh by
/// at most a radius, in the Frobenius norm: the *members*.
struct UncertainField {
  /// @param mesh   valid (see `validate`); kept by reference
  /// @param radii  one per vertex, finite and not negative
  UncertainField(const TetMesh& mesh, std::span<const double> radii);

  const TetMesh* mesh;        ///< the mesh that it was made of
  ScaledField<double> field;  ///< its deviators, scaled
  std::vector<double> radii;  ///< scaled as the vertex, and widened by what its scaling rounds
  /// A member may be isotropic at the vertex: the deviator is not larger than the radius, or larger
  /// by no more than rounding.
  std::vector<char> may_vanish;
  std::vector<double> lode_angles;  ///< of the mesh's tensors; 0 where `may_vanish`
  std::vector<double> turns;        ///< largest angle between deviators of members and the mesh's
};

}  // namespace tensortopo
