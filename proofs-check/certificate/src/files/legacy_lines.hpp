// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace certificate {

/// A type of number, or text, that legacy files name.
struct LegacyType {
  enum Kind { real, whole, natural, text } kind;
  std::size_t size;  ///< bytes, in a binary file
};

/// Reads a legacy VTK file by lines and blocks of numbers. Other readers go by words in some
/// places, by lines in others, and cut both: here a line has to be as VTK's writer writes it, so
/// that all of them come to the same places of the file. Lines end with a line feed, perhaps after a
/// carriage return; their words are apart by one space each; no other control character, no line of
/// more than 250 bytes; each block of numbers ends with its line. All functions throw Malformed.
class LegacyLines {
 public:
  using Words = std::vector<std::string_view>;

  /// Both must outlive it.
  LegacyLines(const std::string& file, std::string_view bytes)
      : file_(file), rest_(bytes), most_(std::min<std::size_t>(bytes.size(), 0xffffffff)) {}

  [[noreturn]] void fail(const std::string& what) const;
  void set_binary(bool is_binary) { binary_ = is_binary; }
  bool is_binary() const { return binary_; }

  /// A line, without its end.
  std::string_view line();
  /// The words of the next line that is not blank; none at the end of the file.
  Words words();
  /// The same, which must be as many.
  Words words(std::size_t count);
  /// The words of a line.
  Words words_in(std::string_view line) const;
  /// The numbers from the next line on, in bytes with the highest first, or in words.
  std::vector<double> numbers(std::size_t count, LegacyType type);
  /// Passes by texts: each a line of any length, or bytes after their number.
  void skip_texts(std::size_t count);

  /// A count: digits. What it counts takes a byte of the file at least, so that products of some do
  /// not overflow.
  std::size_t natural(std::string_view word) const;
  LegacyType type(std::string_view word) const;
  /// A name, in which %XX stands for a space and the like.
  std::string name(std::string_view word) const;

 private:
  const std::string& file_;
  std::string_view rest_;
  std::size_t most_;
  bool binary_ = false;
};

std::string lower_case(std::string_view text);

}  // namespace certificate
