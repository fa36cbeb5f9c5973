// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tensortopo::detail {

/// The lines of a text that say something, and their words.
class LineScanner {
 public:
  explicit LineScanner(std::string_view text) : rest_(text) {}

  /// The words of the next line that has some, without a comment (from `#` on); false at the end.
  /// A line that ends in a backslash goes on in the next one.
  bool next(std::vector<std::string_view>& words);

  /// "line N", of the line given last.
  std::string place() const { return "line " + std::to_string(line_); }

  /// All that follows the line given last.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t line_ = 0;
};

/// A number, finite or not. Throws FormatError, as the next.
double number_of(std::string_view word);
std::int64_t integer_of(std::string_view word);

}  // namespace tensortopo::detail
