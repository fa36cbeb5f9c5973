// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/element.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {
namespace {

struct Name {
  std::string_view text;
  ElementType type;
};

constexpr std::array xml_names{
    Name{"Int8", ElementType::i8},     Name{"UInt8", ElementType::u8},
    Name{"Int16", ElementType::i16},   Name{"UInt16", ElementType::u16},
    Name{"Int32", ElementType::i32},   Name{"UInt32", ElementType::u32},
    Name{"Int64", ElementType::i64},   Name{"UInt64", ElementType::u64},
    Name{"Float32", ElementType::f32}, Name{"Float64", ElementType::f64}};

constexpr std::array legacy_names{Name{"char", ElementType::i8},
                                  Name{"signed_char", ElementType::i8},
                                  Name{"unsigned_char", ElementType::u8},
                                  Name{"short", ElementType::i16},
                                  Name{"unsigned_short", ElementType::u16},
                                  Name{"int", ElementType::i32},
                                  Name{"vtkidtype", ElementType::i32},
                                  Name{"unsigned_int", ElementType::u32},
                                  Name{"long", ElementType::i64},
                                  Name{"vtktypeint64", ElementType::i64},
                                  Name{"unsigned_long", ElementType::u64},
                                  Name{"vtktypeuint64", ElementType::u64},
                                  Name{"float", ElementType::f32},
                                  Name{"double", ElementType::f64}};

template <class Names>
std::optional<ElementType> look_up(const Names& names, std::string_view text) {
  for (const Name& name : names)
    if (name.text == text) return name.type;
  return std::nullopt;
}

/// Calls `visit` with a value of the C++ type that `type` stands for.
template <class Visit>
auto with_type(ElementType type, const Visit& visit) {
  switch (type) {
    case ElementType::i8:
      return visit(std::int8_t{});
    case ElementType::u8:
      return visit(std::uint8_t{});
    case ElementType::i16:
      return visit(std::int16_t{});
    case ElementType::u16:
      return visit(std::uint16_t{});
    case ElementType::i32:
      return visit(std::int32_t{});
    case ElementType::u32:
      return visit(std::uint32_t{});
    case ElementType::i64:
      return visit(std::int64_t{});
    case ElementType::u64:
      return visit(std::uint64_t{});
    case ElementType::f32:
      return visit(float{});
    case ElementType::f64:
      break;
  }
  return visit(double{});
}

template <class Value, class Element>
Value exactly(Element element) {
  if constexpr (std::is_floating_point_v<Element> && !std::is_floating_point_v<Value>) {
    throw FormatError("holds floating-point numbers where integers belong");
  } else if constexpr (std::is_floating_point_v<Value>) {
    if constexpr (sizeof(Element) == 8 && !std::is_floating_point_v<Element>) {
      // Beyond 2^53 some integers have no double; below 2^63 the way back is defined.
      const auto value = static_cast<Value>(element);
      if (std::abs(value) >= 0x1p63 || static_cast<Element>(value) != element)
        throw FormatError("the integer " + std::to_string(element) + " has no exact double");
      return value;
    } else {
      return static_cast<Value>(element);
    }
  } else {
    if constexpr (sizeof(Element) == 8 && std::is_unsigned_v<Element>)
      if (element > static_cast<Element>(std::numeric_limits<Value>::max()))
        throw FormatError("the integer " + std::to_string(element) + " is too large");
    return static_cast<Value>(element);
  }
}

}  // namespace

std::size_t size_of(ElementType type) {
  return with_type(type, [](auto element) { return sizeof(element); });
}

bool is_integer(ElementType type) { return type != ElementType::f32 && type != ElementType::f64; }

std::optional<ElementType> xml_element_type(std::string_view name) {
  return look_up(xml_names, name);
}

std::optional<ElementType> legacy_element_type(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return look_up(legacy_names, lower);
}

template <class Value>
std::vector<Value> from_bytes(std::string_view bytes, ElementType type, std::endian order) {
  return with_type(type, [&](auto zero) {
    using Element = decltype(zero);
    std::vector<Value> values(bytes.size() / sizeof(Element));
    const bool swap = order != std::endian::native;
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::array<char, sizeof(Element)> raw;
      std::memcpy(raw.data(), bytes.data() + i * sizeof(Element), sizeof(Element));
      if (swap) std::reverse(raw.begin(), raw.end());
      values[i] = exactly<Value>(std::bit_cast<Element>(raw));
    }
    return values;
  });
}

template <class Value>
Value from_text(std::string_view word, ElementType type) {
  return with_type(type, [&](auto element) {
    using Element = decltype(element);
    std::string_view digits = word;
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') digits.remove_prefix(1);
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, element);
    if (error == std::errc::invalid_argument || stop != end)
      throw FormatError("\"" + std::string(word.substr(0, 40)) + "\" is not " +
                        (std::is_integral_v<Element> ? "an integer" : "a number"));
    if (error == std::errc::result_out_of_range) {
      if constexpr (std::is_floating_point_v<Element>) {
        // Too small is rounded like any other number; only too large is beyond repair.
        const std::string copy(digits);
        if constexpr (sizeof(Element) == sizeof(float))
          element = std::strtof(copy.c_str(), nullptr);
        else
          element = std::strtod(copy.c_str(), nullptr);
        if (std::isfinite(element)) return exactly<Value>(element);
      }
      throw FormatError("\"" + std::string(word.substr(0, 40)) + "\" is out of range of its type");
    }
    return exactly<Value>(element);
  });
}

template std::vector<double> from_bytes(std::string_view, ElementType, std::endian);
template std::vector<std::int64_t> from_bytes(std::string_view, ElementType, std::endian);
template double from_text(std::string_view, ElementType);
template std::int64_t from_text(std::string_view, ElementType);

}  // namespace tensortopo::detail
