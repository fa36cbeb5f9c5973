// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "render/scene/line_field.hpp"
#include "tensortopo/manifold/field_lift.hpp"
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A tetrahedron and the tensors at its corners.
struct TetField {
  std::array<Vector3<double>, 4> corners{};
  std::array<SymmetricTensor<double>, 4> tensors{};

  /// The linear field, in the tetrahedron and beyond.
  SymmetricTensor<double> at(const Vector3<double>& point) const;
  /// The barycentric coordinates of a point.
  std::array<double, 4> weights(const Vector3<double>& point) const;
};

/// The tetrahedron of a mesh as a field.
TetField tet_field(const TetMesh& mesh, std::size_t tet);

/// What a direction is as medium eigenvector of the generalized mode surface of a linear field
/// (paper, section on mode surface analysis). The real domain is divided by the modes of the two
/// points of +-v.
enum class DirectionKind {
  complex_domain,  ///< grey: no point has it
  positive,        ///< cyan: both points have mode +|mu|
  negative,        ///< magenta: both have mode -|mu|
  mixed,           ///< blue: one of each
};

/// The unit sphere as the medium eigenvector manifold of one tetrahedron's linear field.
class TetDirections {
 public:
  /// Throws std::invalid_argument if the deviators of the tensors are dependent.
  TetDirections(const TetField& field, const ModeValue& mode);

  const MediumEigenvectorManifold<double>& manifold() const { return manifold_; }

  DirectionKind kind(const Vector3<double>& v) const;
  /// The sign of the mode (1 for mode 0) at the point of v, of the pair +-v the one that
  /// `tensor_at` stands for, if that is in the tetrahedron; else, and in the complex domain, 0.
  int sign_inside(const Vector3<double>& v) const;
  /// The same for a point of the boundary of the complex domain.
  int sign_inside_boundary(const Vector3<double>& v) const;
  /// The point of v, in the tetrahedron or beyond; nothing in the complex domain or at infinity.
  std::optional<Vector3<double>> place(const Vector3<double>& v) const;

  /// Of +-v the one whose point has the dominant eigenvector `dominant`.
  Vector3<double> canonical(const Vector3<double>& v, const Vector3<double>& dominant) const;

  /// The direction of the texture at v, tangent to the sphere: the dominant eigenvector of v's
  /// point (an eigenvector of the paper's asymmetric tensor), or that of a principal direction of
  /// the surface there, carried over by the derivative of the medium eigenvector. Without a
  /// direction (as at mode 1) 0.
  Vector3<double> line(const Vector3<double>& v, Texture texture) const;

 private:
  std::array<double, 4> weights(const Vector3<double>& v) const;

  TetField field_;
  MediumEigenvectorManifold<double> manifold_;
  FieldLift<double> lift_;
};

/// The derivative of the medium eigenvector of a linear field along `step`, at a point where it is
/// v: sum over the other eigenvectors e of (e . dT v) / (medium - value of e) e. Its sign is v's.
Vector3<double> medium_eigenvector_derivative(const TetField& field, const Vector3<double>& point,
                                              const Vector3<double>& step);

}  // namespace tensortopo
