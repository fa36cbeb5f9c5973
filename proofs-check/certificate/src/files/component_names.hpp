// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace certificate {

/// What names of components say about the order in which a tensor's entries are taken.
enum class Spelling {
  silent,   ///< nothing: there are none, or none that are understood
  agrees,
  differs,
};

/// Names are understood if, without what all of them begin and end with and without separators,
/// each is one or two of the axes x, y, z (or 1, 2, 3; or 0, 1, 2), and no two are the same. One
/// axis stands for a diagonal entry. Else each name that ends in an entry (`tau_xy`, `E12`) must end in
/// the one in its place, and the others say nothing.
/// @param places  of XX YY ZZ XY YZ XZ among the components, of which there are 6 or 9
Spelling spelling_of(std::vector<std::string> names, const std::array<std::size_t, 6>& places);

}  // namespace certificate
