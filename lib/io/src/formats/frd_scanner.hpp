// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tensortopo::detail {

/// How a block of a .frd file stores its numbers: the digit at the end of its first line.
enum class FrdEncoding { short_text = 0, long_text = 1, floats = 2, doubles = 3 };

constexpr bool is_text(FrdEncoding encoding) {
  return encoding == FrdEncoding::short_text || encoding == FrdEncoding::long_text;
}

/// Columns of a line, counted from 0; what is beyond its end is empty.
std::string_view columns(std::string_view line, std::size_t begin, std::size_t width);

/// A count in columns, blanks around it. Throws FormatError with `what` it is.
std::uint64_t count_in(std::string_view line, std::size_t begin, std::size_t width,
                       const char* what);

/// The next real number off the front of `text`: numbers of fixed width may touch each other, where
/// the second has a minus. Throws FormatError.
double take_real(std::string_view& text);

/// A forward reader of a .frd file: lines, and blocks of bytes between them. Throws FormatError.
class FrdScanner {
 public:
  explicit FrdScanner(std::string_view bytes) : all_(bytes), rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }
  /// To the end of the line, which is taken too; without a carriage return.
  std::string_view line();
  std::string_view peek_line() const { return FrdScanner(*this).line(); }
  std::string_view bytes(std::uint64_t count, std::uint64_t size);
  /// The lines up to the one that ends a block (-3), which is taken too.
  std::string_view text_block();
  /// "byte N"
  std::string place() const;

 private:
  std::string_view all_, rest_;
};

}  // namespace tensortopo::detail
