// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// What is known of an extraction's memory before it begins.
struct MemorySizes {
  std::size_t tets = 0;     ///< of the mesh
  std::size_t crossed = 0;  ///< of all modes, those with vertices on both sides of the mode
  bool is_certified = false;  ///< whether a certificate is written, too
};

/// Counts them. In double precision: no result depends on it but the number of pieces.
MemorySizes memory_sizes(const TetMesh& mesh, std::span<const ModeValue> modes);

/// An estimate, in bytes, of the most memory that the program holds when it extracts in so many
/// pieces; the constants are in memory_plan.cpp.
/// @param pieces  at least 1
double estimated_memory(const MemorySizes& sizes, std::int32_t pieces);

/// The smallest number of pieces whose estimate is at most `bytes`; nothing if there is none.
std::optional<std::int32_t> pieces_within(const MemorySizes& sizes, std::uint64_t bytes);

/// The least of the estimates of all numbers of pieces.
double least_memory(const MemorySizes& sizes);

/// As many pieces as fit in the memory that the command asks for, into `report.pieces`, with
/// `report.memory`; else as many as it says. Throws UsageError if none fit.
void plan_pieces(const ExtractCommand& command, const TetMesh& mesh,
                 std::span<const ModeValue> modes, ExtractReport& report);

/// Throws UsageError if the program has held more memory than the command allows.
void require_below_limit(const ExtractCommand& command, const ExtractReport& report);

/// "8.0 GB", in powers of 1000.
std::string memory_text(double bytes);

}  // namespace tensortopo
