// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tensortopo/extract/curve_arcs.hpp"

namespace tensortopo {

/// Whether a plane is proved to be strictly between two sets of boxes, and so between the convex
/// hulls of any points of these.
bool are_hulls_apart(std::span<const PlaceBox> a, std::span<const PlaceBox> b);

}  // namespace tensortopo
