// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace tensortopo {

using UndirectedEdge = std::pair<std::size_t, std::size_t>;  ///< smaller end first

/// Cuts triangles at new vertices on some of their sides; directions are kept.
std::vector<std::array<std::size_t, 3>> split_triangles(
    const std::vector<std::array<std::size_t, 3>>& triangles,
    const std::map<UndirectedEdge, std::size_t>& middle);

}  // namespace tensortopo
