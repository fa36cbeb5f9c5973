// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// One level of a surface: first its topology is derived, then all claims are compared with it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/document.hpp"
#include "files/files.hpp"
#include "parts/part_border.hpp"
#include "run/ledger.hpp"
#include "run/work_limit.hpp"
#include "surface/compare_stability.hpp"
#include "topology.hpp"

namespace certificate {

/// The name of a level in the verdict.
std::string level_name_of(const Json& claims);

Level level_of(const Json& claims);

/// What is known of a level while it is checked.
struct CheckedLevel {
  CheckedLevel(const Json& its_claims, std::shared_ptr<const Field> its_field)
      : claims(its_claims), field(std::move(its_field)), level(level_of(its_claims)) {}

  const Json& claims;
  const std::shared_ptr<const Field> field;
  const Level level;
  Report report;  ///< of this level only
  Ledger ledger{report};
  std::vector<bool> left_out;        ///< tetrahedra about which nothing is claimed
  std::optional<Topology> topology;  ///< nothing where there is no more to compare
};

/// Derives the level's topology, as far as the limit of work allows.
void derive_level(CheckedLevel& checked, const Input& input, WorkLimit& limit,
                  const Progress& progress);

/// Compares the claims with the topology, if there is one.
/// @param border  if not null, gets what is needed to put parts together
void compare_level(CheckedLevel& checked, const RadiiByArray& radii, const Input& input,
                   const Triangles& surface, const Progress& progress, PartBorder* border);

}  // namespace certificate
