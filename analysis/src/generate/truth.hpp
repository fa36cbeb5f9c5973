// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// How far the reference surface of a level is from it.
struct ReferenceTruth {
  std::string surface, points;  ///< file names; beside the truth file
  std::size_t vertices = 0, triangles = 0;
  double distance = 0;  ///< both ways; of the triangles, see DistanceClaim
  std::size_t coarse_cells = 0;
  double coarse_distance = 0;  ///< of the triangles in the coarse cells
  double point_bound = 0;      ///< of the refined vertices, see ReferencePoints
  std::size_t unproved_points = 0;
};

/// Certified facts about one mode surface of a field, for whoever wants to compare.
struct LevelTruth {
  using Index = TetMesh::Index;
  struct Component {
    std::int64_t euler_characteristic = 0;
    std::size_t boundary_loops = 0;
    bool orientable = true;
    int member = -1;  ///< of a field of several members side by side: which; else -1
    bool closed() const { return boundary_loops == 0; }
    auto operator<=>(const Component&) const = default;
  };
  struct EdgeFact {
    std::array<Index, 2> vertices{};
    int crossings = 0;
    auto operator<=>(const EdgeFact&) const = default;
  };
  struct FaceFact {
    std::array<Index, 3> vertices{};
    int arcs = 0, closed_curves = 0;
    auto operator<=>(const FaceFact&) const = default;
  };
  struct TetFact {
    Index tet = -1;
    std::vector<std::array<int, 2>> sheets;  ///< Euler characteristic, boundary loops; sorted
    bool operator==(const TetFact&) const = default;
  };

  ModeValue mode;
  std::vector<Component> components;  ///< of what is decided; sorted
  std::vector<EdgeFact> edges;        ///< those with crossings
  std::vector<FaceFact> faces;        ///< those with curves
  std::vector<TetFact> tets;          ///< those with sheets
  std::vector<UndecidedCell> undecided;
  bool detailed = true;  ///< edges, faces and tets are listed
  std::optional<ReferenceTruth> reference;
};

/// A field, and the truth about some of its mode surfaces.
struct FieldTruth {
  std::string kind, note;
  std::vector<std::string> notes;  ///< of the members side by side, if they differ; else none
  std::uint64_t seed = 0;
  int member = 0, members = 1;
  std::string field_sha256;
  std::size_t points = 0, tetrahedra = 0;
  std::vector<LevelTruth> levels;
};

/// The facts among the claims.
/// @param member_of  the member of the field in which a component lies, if there are several
/// @pre the level is a mode's
LevelTruth level_truth(const CertifiedLevel& level, bool detailed,
                       const std::function<int(const ComponentClaim&)>& member_of = {});

/// JSON; equal truths give equal bytes. Ends with a newline.
std::string to_json(const FieldTruth& truth);

/// Reads what `to_json` writes. Throws IoError (`invalid`), with what is wrong.
FieldTruth read_truth(const std::filesystem::path& file);

/// The same of a text, whose file is named in errors.
FieldTruth parse_truth(const std::string& text, const std::filesystem::path& file);

}  // namespace tensortopo
