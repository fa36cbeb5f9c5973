// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/stability/stability_run.hpp"

namespace tensortopo {

/// What the command asks for; nothing if it says nothing of uncertainty. Throws UsageError if that
/// cannot be read, or if some of the modes, or the method, have no proofs that it could apply to.
std::optional<Uncertainty> requested_uncertainty(const ExtractCommand& command,
                                                 std::span<const ModeValue> modes);

/// Reads the radii, if the command names an array of them. Throws IoError, also if one is negative.
void read_radii(const ExtractCommand& command, const ReadResult& read, Uncertainty& uncertainty);

/// The stability of the next level's surface, in its report.
/// @param radius   as it was asked for
StabilityReport report_stability(StabilityRun& run, const std::string& radius,
                                 const ModeValue& mode, const ExtractOptions& options,
                                 const Extraction& extraction);

}  // namespace tensortopo
