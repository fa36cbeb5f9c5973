// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/element.hpp"

namespace tensortopo::detail {

/// A number of each item of an element, or a list of numbers.
struct PlyProperty {
  std::string name;
  ElementType type = ElementType::f32;
  std::optional<ElementType> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Where the property of this name is; throws FormatError if there is none.
  std::size_t index_of(std::string_view property) const;
};

struct PlyHeader {
  std::optional<std::endian> binary;  ///< byte order; empty: text
  std::vector<PlyElement> elements;
  std::string_view body;
};

/// Throws FormatError.
PlyHeader read_ply_header(std::string_view bytes);

}  // namespace tensortopo::detail
