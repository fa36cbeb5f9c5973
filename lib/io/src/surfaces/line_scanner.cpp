// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surfaces/line_scanner.hpp"

#include <algorithm>

#include "bytes/element.hpp"
#include "bytes/words.hpp"

namespace tensortopo::detail {

bool LineScanner::next(std::vector<std::string_view>& words) {
  words.clear();
  bool goes_on = false;
  while (!rest_.empty() && (words.empty() || goes_on)) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    line = trimmed(line.substr(0, line.find('#')));
    goes_on = line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
      words.push_back(word);
  }
  return !words.empty();
}

double number_of(std::string_view word) { return from_text<double>(word, ElementType::f64); }

std::int64_t integer_of(std::string_view word) {
  return from_text<std::int64_t>(word, ElementType::i64);
}

}  // namespace tensortopo::detail
