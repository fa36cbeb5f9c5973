// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <string>
#include <string_view>

namespace tensortopo {

/// "1 vertex", "2 vertices".
std::string counted(std::integral auto n, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// "1 component", "2 components".
std::string counted(std::integral auto n, std::string_view noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

/// "1 tetrahedron", "2 tetrahedra".
std::string counted_tets(std::integral auto n) { return counted(n, "tetrahedron", "tetrahedra"); }

}  // namespace tensortopo
