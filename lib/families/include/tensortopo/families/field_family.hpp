// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The families of fields with known or certifiable mode surfaces.
enum class FieldKind {
  linear,          ///< one tetrahedron of random tensors
  complex,         ///< a cubic polynomial field on a small lattice
  rough,           ///< random tensors on a small lattice
  bifurcation,     ///< tetrahedra around their saddle: the members' mu0 pass the level
  planar_extrema,  ///< a face with 2, 3 or 4 extrema inside, in turn
  nongeneric,      ///< one `Speciality` after the other
  boussinesq,      ///< three loads on an elastic half space
  kelvin,          ///< a force in an infinite elastic body
  helix,           ///< the degenerate curve is a helix
  block,           ///< the four blocks, in turn, with a stand-in stress
};

std::span<const FieldKind> all_field_kinds();
/// "linear", "planar-extrema" and so on.
std::string_view name_of(FieldKind kind);
std::optional<FieldKind> field_kind(std::string_view name);

/// Which member of a family.
struct FamilyRequest {
  std::uint64_t seed = 1;      ///< which family of this kind
  int member = 0;              ///< which of its members
  int members = 1;             ///< size of the family, 0 <= member < members
  std::size_t tetrahedra = 0;  ///< at least so many where a mesh is made; 0: the kind's default
  /// Of kelvin: one of so many slabs of its mesh across x, 0 <= slab < slabs. Points and tetrahedra
  /// of all slabs in order, points that two have counted where they come first, are the whole's.
  int slab = 0, slabs = 1;
};

/// A field of a family.
struct FamilyMember {
  std::string note;              ///< what this one is
  TetMesh mesh;                  ///< valid
  std::vector<ModeValue> modes;  ///< levels worth a look
};

/// A member of a family: the same bytes for the same request on every platform with IEEE doubles,
/// since it is made by + - * / and square roots alone. Throws std::invalid_argument for a member
/// out of range.
FamilyMember family_member(FieldKind kind, const FamilyRequest& request);

}  // namespace tensortopo
