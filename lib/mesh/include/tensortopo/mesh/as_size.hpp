// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace tensortopo {

/// A vertex or cell of a mesh as a subscript. Meshes number with signed integers, as VTK does, and
/// -1 is none.
/// @pre i >= 0
constexpr std::size_t as_size(std::int64_t i) { return static_cast<std::size_t>(i); }

}  // namespace tensortopo
