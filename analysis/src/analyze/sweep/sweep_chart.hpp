// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tensortopo/sweep/sweep.hpp"

namespace tensortopo {

/// Components, Euler characteristic, boundary loops and area against the mode, one below the
/// other, how many critical points of which kind there are, and a line for each, as the bytes of a
/// PNG of 1600 x 1760 pixels.
///
/// What is constant between critical values is drawn as steps, and not where it is not known; the
/// area as dots, at the samples, that thin lines join. Throws std::runtime_error if there is no
/// display (see `DisplayServer`).
std::string sweep_chart(const Sweep& sweep, const SweepOptions& options);

}  // namespace tensortopo
