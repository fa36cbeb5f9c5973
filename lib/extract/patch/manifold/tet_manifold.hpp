// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/manifold/field_lift.hpp"
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo {

/// The medium eigenvector manifold of one tetrahedron's linear field, for meshing its sheets as
/// the paper does (section on extraction inside a tetrahedron). It guides samples and
/// connectivity only, so double serves; what it meshes is checked against the proved topology.
///
/// A neutral surface is meshed on the manifold of a mode next to 0. Its complex domain is an oval
/// around each singularity, too small to hold a sample, and the oval's boundary stands for the
/// straight line of the surface that has the singularity as medium eigenvector everywhere: the
/// point is blown up to the line. Vertices are put on the level afterwards. In the same way a
/// characteristic tensor of mode 0, whose ovals are points for every mode, is taken for one next to
/// it.
struct TetManifold {
  CharacteristicTensor<double> characteristic;
  MediumEigenvectorManifold<double> manifold;
  FieldLift<double> lift;  ///< to weights in the scaled vertex tensors
  int sign;                ///< of the mode
  bool small_ovals;        ///< the medium eigenvector does not tell places along an oval

  /// Where on the boundary of the complex domain the medium eigenvector, or its opposite, of a
  /// tensor on it is. Where ovals are small, as for a neutral surface, the eigenvector is nearly a
  /// singularity, and it is the dominant eigenvector that tells the place.
  BoundaryPosition<double> boundary_position(const Vector3<double>& medium,
                                             const Vector3<double>& dominant) const;
};

}  // namespace tensortopo
