// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {

/// What the extractions of several modes from one mesh have in common, computed once.
template <class Scalar>
struct PreparedField {
  /// Whether what a further mode needs is kept.
  enum class Use { one_mode, several_modes };

  /// @param mesh  valid (see `validate`); not read afterwards
  explicit PreparedField(const TetMesh& mesh, Use use = Use::several_modes);

  /// The mesh, in the order in which all is computed; the arrays below have its numbers.
  std::shared_ptr<const CanonicalMesh> canonical;
  ScaledField<Scalar> field;  ///< its deviators, scaled
  // One per vertex.
  /// Scaled as in `field`, rounded. If that is in double already, it is not kept twice.
  const std::vector<Deviator<double>>& tensors() const {
    if constexpr (std::is_same_v<Scalar, double>)
      return field.tensors;
    else
      return rounded_tensors;
  }
  std::vector<double> norms;        ///< sqrt(P) of these
  std::vector<double> lode_angles;  ///< of these; 0 isotropic

  /// Of each tetrahedron the Lode angles between which all of it certainly lies; empty for one
  /// mode, for which it is quicker to compare angles between tensors where they matter.
  std::vector<std::array<float, 2>> lode_ranges;

  std::vector<Deviator<double>> rounded_tensors;  ///< see `tensors`
};

}  // namespace tensortopo
