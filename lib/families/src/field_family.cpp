// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/field_family.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "tensortopo/families/block.hpp"
#include "tensortopo/families/elastic_stress.hpp"
#include "tensortopo/families/helix_field.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"
#include "tensortopo/families/random_source.hpp"
#include "tensortopo/families/single_tets.hpp"
#include "tensortopo/families/special_tets.hpp"

namespace tensortopo {

namespace {

constexpr std::array<FieldKind, 10> kKinds{
    FieldKind::linear,         FieldKind::complex,    FieldKind::rough,      FieldKind::bifurcation,
    FieldKind::planar_extrema, FieldKind::nongeneric, FieldKind::boussinesq, FieldKind::kelvin,
    FieldKind::helix,          FieldKind::block};

std::vector<ModeValue> parsed(std::initializer_list<const char*> modes) {
  std::vector<ModeValue> values;
  for (const char* mode : modes) values.push_back(ModeValue::parse(mode));
  return values;
}

std::size_t or_default(std::size_t asked, std::size_t usual) { return asked > 0 ? asked : usual; }

int cube_cells(std::size_t tetrahedra) { return cells_for({1, 1, 1}, tetrahedra)[0]; }

FamilyMember bifurcation(const FamilyRequest& request, RandomSource& random) {
  // The level is that of s = 1/4; the members' s are within 2^-11 of it.
  const double place = (2 * request.member + 1.0) / (2 * request.members);
  const double s = 0.25 + 0x1p-10 * (place - 0.5);
  return {"saddle at s = 1/4 " + std::string(s < 0.25 ? "- " : "+ ") +
              std::to_string(std::abs(s - 0.25)) + ", the level's is 1/4",
          saddle_tet(s, random), parsed({"143/343"})};
}

FamilyMember planar_extrema(const FamilyRequest& request, RandomSource& random) {
  const auto count = kPlanarCounts[static_cast<std::size_t>(request.member % 3)];
  return {std::to_string(count.extrema) + " extrema and " + std::to_string(count.saddles) +
              " saddles in the plane of a face",
          planar_extrema_tet(count.extrema, random), parsed({"9/10", "-9/10", "99/100"})};
}

FamilyMember nongeneric(const FamilyRequest& request, RandomSource& random) {
  const auto& all = all_specialities();
  const Speciality which = all[static_cast<std::size_t>(request.member) % all.size()];
  const auto level = special_level(which);
  return {std::string(name_of(which)), special_tet(which, random),
          level ? std::vector<ModeValue>{*level} : parsed({"1/2"})};
}

FamilyMember boussinesq(const FamilyRequest& request, RandomSource& random) {
  struct Load {
    double x, y, size;
  };
  std::array<Load, 3> loads{};
  for (Load& load : loads)
    load = {1.5 * random.uniform() - 0.75, 1.5 * random.uniform() - 0.75, 0.5 + random.uniform()};
  const int n = cube_cells(or_default(request.tetrahedra, 3072));
  // The surface itself, where the stress under a load is infinite, is left out.
  TetMesh mesh = kuhn_box({n, n, n}, {-1, -1, 0.25}, {1, 1, 2.25});
  sample_field(mesh, [&](const Vector3<double>& p) {
    SymmetricTensor<double> sum;
    for (const Load& load : loads)
      sum = sum + boussinesq_stress<double>({p.x - load.x, p.y - load.y, p.z}, load.size, 0.25);
    return sum;
  });
  return {"three loads on a half space", std::move(mesh), parsed({"0", "1/2", "-9/10"})};
}

FamilyMember kelvin(const FamilyRequest& request, RandomSource& random) {
  // Off the lattice, and in no direction of it.
  const auto offset = [&] { return 0.25 * random.uniform() - 0.125; };
  const Vector3<double> at{offset(), offset(), offset()};
  const Vector3<double> force{random.normal(), random.normal(), 3 + random.uniform()};
  const int n = cube_cells(or_default(request.tetrahedra, 3072));
  TetMesh mesh = kuhn_slab({n, n, n}, {-1, -1, -1}, {1, 1, 1}, request.slab, request.slabs);
  sample_field(mesh, [&](const Vector3<double>& p) {
    const Vector3<double> x = p - at;
    return x == Vector3<double>{} ? SymmetricTensor<double>{}
                                  : kelvin_stress<double>(x, force, 0.25);
  });
  return {"a force in an infinite body", std::move(mesh), parsed({"0", "1/2", "9/10"})};
}

FamilyMember helix(const FamilyRequest& request, RandomSource& random) {
  const HelixField field{1, 0.25 + 0.125 * random.uniform(), 0.5};
  const int n = cube_cells(or_default(request.tetrahedra, 10368));
  TetMesh mesh = kuhn_box({n, n, n}, {-1.6, -1.7, -1.25}, {1.7, 1.65, 1.25});
  sample_field(mesh, field);
  return {"a helix of " + std::to_string(field.turns_per_height) + " turns per unit of height",
          std::move(mesh), parsed({"0", "9/10", "99/100"})};
}

}  // namespace

std::span<const FieldKind> all_field_kinds() { return kKinds; }

std::string_view name_of(FieldKind kind) {
  constexpr std::array<std::string_view, kKinds.size()> names{
      "linear",     "complex",    "rough",  "bifurcation", "planar-extrema",
      "nongeneric", "boussinesq", "kelvin", "helix",       "block"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<FieldKind> field_kind(std::string_view name) {
  for (const FieldKind kind : kKinds)
    if (name_of(kind) == name) return kind;
  return std::nullopt;
}

FamilyMember family_member(FieldKind kind, const FamilyRequest& request) {
  if (request.member < 0 || request.member >= request.members)
    throw std::invalid_argument("family_member: no such member");
  if (request.slabs != 1 && kind != FieldKind::kelvin)
    throw std::invalid_argument("family_member: only kelvin is made in slabs");
  // Members draw from sources of their own, so that each can be made alone.
  RandomSource random(request.seed * 0x9e3779b97f4a7c15u + static_cast<unsigned>(request.member));
  switch (kind) {
    case FieldKind::linear:
      return {"random tensors", random_tet(random), parsed({"0", "1/2", "9/10"})};
    case FieldKind::complex:
      return {"cubic polynomial",
              smooth_cube(cube_cells(or_default(request.tetrahedra, 48)), random),
              parsed({"0", "1/2", "9/10"})};
    case FieldKind::rough:
      return {"random tensors", rough_cube(cube_cells(or_default(request.tetrahedra, 48)), random),
              parsed({"0", "1/2", "9/10"})};
    case FieldKind::bifurcation:
      return bifurcation(request, random);
    case FieldKind::planar_extrema:
      return planar_extrema(request, random);
    case FieldKind::nongeneric:
      return nongeneric(request, random);
    case FieldKind::boussinesq:
      return boussinesq(request, random);
    case FieldKind::kelvin:
      return kelvin(request, random);
    case FieldKind::helix:
      return helix(request, random);
    case FieldKind::block:
      break;
  }
  const auto block =
      static_cast<Block>((request.seed + 3 + static_cast<unsigned>(request.member)) % 4);
  return {name_of(block) + ", stand-in stress",
          block_field(block, or_default(request.tetrahedra, 7000)), parsed({"0", "1/2", "-1/2"})};
}

}  // namespace tensortopo
