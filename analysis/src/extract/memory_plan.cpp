// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/memory_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "peak_memory.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

// Bytes, fitted to peaks of `extract --pieces N` on two threads with the surface of one mode. Some are
// of a field that the surface crosses in few tetrahedra, others of one that it crosses in many.
constexpr double kProgram = 50e6;       // the program with its libraries
constexpr double kReadTet = 132;        // reading, and the screening of the whole
constexpr double kSlabTet = 308;        // in the slab
constexpr double kTet = 92;             // mesh and owners
constexpr double kCrossed = 1250;       // surfaces of slabs, merged and written
constexpr double kWholeCrossed = 1700;  // a surface extracted at once
constexpr double kGhostCrossed = 380;   // where slabs meet

// What a certificate adds to each.
constexpr double kCheckedTet = 124;            // the checker's own reading
constexpr double kClaimedTet = 130;            // that, and what is left of it later
constexpr double kClaimedCrossed = 1500;       // proofs and claims of slabs
constexpr double kClaimedWholeCrossed = 1300;  // proofs and claims made at once
constexpr double kClaimedGhostCrossed = 340;   // where slabs meet

constexpr std::int32_t kMostPieces = 1000;

/// Tetrahedra on both sides of a slab, of a cube of cubes cut in six.
double ghosts(const MemorySizes& sizes) {
  return 12 * std::cbrt(std::pow(static_cast<double>(sizes.tets) / 6, 2));
}

}  // namespace

MemorySizes memory_sizes(const TetMesh& mesh, std::span<const ModeValue> modes) {
  std::vector<double> at;
  at.reserve(mesh.tensors.size());
  for (const auto& tensor : mesh.tensors)
    at.push_back(
        mode_if_defined(deviator(tensor)).value_or(std::numeric_limits<double>::quiet_NaN()));
  MemorySizes sizes{mesh.tets.size(), 0, false};
  for (const ModeValue& mode : modes) {
    const double level = mode.approx();
    for (const auto& tet : mesh.tets) {
      bool below = false, above = false;
      for (const TetMesh::Index v : tet) {
        below = below || at[as_size(v)] < level;
        above = above || at[as_size(v)] >= level;
      }
      sizes.crossed += below && above;
    }
  }
  return sizes;
}

double estimated_memory(const MemorySizes& sizes, std::int32_t pieces) {
  const auto tets = static_cast<double>(sizes.tets), crossed = static_cast<double>(sizes.crossed);
  const double claims = sizes.is_certified ? 1 : 0;
  const double reading = kProgram + (kReadTet + claims * kCheckedTet) * tets;
  if (pieces == 1)
    return reading + (kWholeCrossed + claims * kClaimedWholeCrossed) * crossed;
  const double ghost = std::min(ghosts(sizes), tets), share = tets > 0 ? crossed / tets : 0;
  const double slab = std::min(tets / pieces + ghost, tets);
  return std::max(reading, kProgram + (kTet + claims * kClaimedTet) * tets + kSlabTet * slab +
                               (kCrossed + claims * kClaimedCrossed) * crossed +
                               (kGhostCrossed + claims * kClaimedGhostCrossed) * share * ghost *
                                   pieces);
}

std::optional<std::int32_t> pieces_within(const MemorySizes& sizes, std::uint64_t bytes) {
  for (std::int32_t pieces = 1; pieces <= kMostPieces; ++pieces)
    if (estimated_memory(sizes, pieces) <= static_cast<double>(bytes)) return pieces;
  return std::nullopt;
}

double least_memory(const MemorySizes& sizes) {
  double least = estimated_memory(sizes, 1);
  for (std::int32_t pieces = 2; pieces <= kMostPieces; ++pieces)
    least = std::min(least, estimated_memory(sizes, pieces));
  return least;
}

void plan_pieces(const ExtractCommand& command, const TetMesh& mesh,
                 std::span<const ModeValue> modes, ExtractReport& report) {
  report.pieces = command.pieces;
  if (command.memory == 0) return;
  require_below_limit(command, report);
  MemorySizes sizes = memory_sizes(mesh, modes);
  sizes.is_certified = !command.certificate.empty();
  const auto pieces = pieces_within(sizes, command.memory);
  if (!pieces)
    throw UsageError(fmt::format(
        "--memory: {}: {} are too little for {} tetrahedra, some {} of which the surfaces cross: "
        "in any number of pieces it takes about {}",
        command.input.string(), memory_text(static_cast<double>(command.memory)), sizes.tets,
        sizes.crossed, memory_text(least_memory(sizes))));
  report.pieces = *pieces;
  report.memory = MemoryReport{
      command.memory, static_cast<std::uint64_t>(estimated_memory(sizes, *pieces)), 0};
}

void require_below_limit(const ExtractCommand& command, const ExtractReport& report) {
  if (command.memory == 0) return;
  const std::uint64_t peak = peak_memory();
  if (peak > command.memory)
    throw UsageError(fmt::format(
        "--memory: {}: {} are too little: the program has held {}{}; nothing written",
        command.input.string(), memory_text(static_cast<double>(command.memory)),
        memory_text(static_cast<double>(peak)),
        report.memory ? fmt::format(" in {} pieces", report.pieces) : " to read the field"));
}

std::string memory_text(double bytes) {
  constexpr std::array kUnits{"bytes", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1000 && unit + 1 < kUnits.size()) bytes /= 1000, ++unit;
  return unit == 0 ? fmt::format("{:.0f} bytes", bytes)
                   : fmt::format("{:.4g} {}", bytes, kUnits[unit]);
}

}  // namespace tensortopo
