// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace tensortopo::detail {

/// The number types that the formats store.
enum class ElementType { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

std::size_t size_of(ElementType type);
bool is_integer(ElementType type);

/// Names as in XML files (`Float64`); empty for one that is no number type.
std::optional<ElementType> xml_element_type(std::string_view name);
/// Names as in legacy files (`double`), in any case; `bit` and `string` are not among them.
std::optional<ElementType> legacy_element_type(std::string_view name);

/// All elements in `bytes`, exactly: Value is double or std::int64_t. Throws FormatError for an
/// integer that Value cannot hold, or for floating-point numbers where integers are wanted.
template <class Value>
std::vector<Value> from_bytes(std::string_view bytes, ElementType type, std::endian order);

/// One element from text, rounded once to `type`. Throws FormatError, also when it overflows.
template <class Value>
Value from_text(std::string_view word, ElementType type);

}  // namespace tensortopo::detail
