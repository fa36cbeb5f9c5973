// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/element.hpp"

namespace tensortopo::detail {

/// Numbers in a legacy file, located but not decoded.
struct LegacyNumbers {
  std::string_view text;  ///< from the first number on; of a binary file: exactly the bytes
  ElementType type = ElementType::f64;
  std::size_t count = 0;
  bool binary = false;

  /// Value is double or std::int64_t. Throws FormatError.
  template <class Value>
  std::vector<Value> decode() const;
};

/// A forward reader of a legacy VTK file: words and lines, and blocks of numbers, whose length is
/// checked against the rest of the file. Throws FormatError.
class LegacyScanner {
 public:
  explicit LegacyScanner(std::string_view bytes) : all_(bytes), rest_(bytes) {}

  void set_binary(bool binary) { binary_ = binary; }
  bool is_binary() const { return binary_; }

  /// To the end of the line, which is taken too; without a carriage return.
  std::string_view line();
  /// The next word; empty at the end of the file.
  std::string_view word();
  /// The next word in lower case, without taking it.
  std::string peek_keyword();
  /// The next word as a count. `what` is for the message.
  std::size_t count(const char* what);
  /// The next word as a number type.
  ElementType type();

  /// The numbers at hand, passed over. In a binary file they begin on the next line.
  LegacyNumbers numbers(std::uint64_t count, ElementType type);
  /// Passes over entries that are no numbers.
  void skip_bits(std::uint64_t count);
  void skip_strings(std::uint64_t count);

  /// "line N", or "byte N" of a binary file.
  std::string place() const;

 private:
  std::string_view bytes(std::uint64_t size);
  void end_header_line();
  void skip_words(std::uint64_t count);

  std::string_view all_, rest_;
  bool binary_ = false;
};

}  // namespace tensortopo::detail
