// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "analyze/sweep.hpp"

namespace tensortopo {

/// Components, Euler characteristic, boundary loops and area against the mode, one below the
/// other, and a line for each critical value, as the bytes of a PNG of 1600 x 1400 pixels.
///
/// What is known everywhere is drawn as steps; what is known at the samples only, as dots that
/// thin lines join. Throws std::runtime_error if there is no display (see `DisplayServer`).
std::string sweep_chart(const Sweep& sweep, const SweepOptions& options);

}  // namespace tensortopo
