// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The places of two chains along one curve, as the parts on both sides of a face have it: one of
// them runs backwards.
#pragma once

#include <cstddef>
#include <optional>

#include "parts/part_border.hpp"

namespace certificate {

/// Which vertex of the second chain the first vertex of the first one is, so that the next vertices
/// of the first are those before of the second, at the same places. Of a closed curve there may be
/// several, and any of them will do: to turn the circle is an isotopy. Nothing if there is none.
std::optional<std::size_t> turn_between(const BorderChain& chain, const BorderChain& other);

/// The first edge of a chain that the second does not have; if it has all, in another order, 0.
std::size_t first_difference(const BorderChain& chain, const BorderChain& other);

}  // namespace certificate
