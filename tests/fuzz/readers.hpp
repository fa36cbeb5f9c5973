// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace tensortopo::test {

/// A reader of files that strangers give.
struct FuzzedReader {
  std::string name;  ///< of its folder in corpus, too
  /// Reads the bytes. Whatever they are, there is a result that keeps the reader's laws, or an
  /// error of one line; else it throws std::logic_error.
  void (*read)(std::string_view bytes);
};

const std::vector<FuzzedReader>& fuzzed_readers();

/// Its name, for GoogleTest.
inline void PrintTo(const FuzzedReader& reader, std::ostream* stream) { *stream << reader.name; }

}  // namespace tensortopo::test
