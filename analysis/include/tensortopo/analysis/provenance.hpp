// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tensortopo {

/// What made a file: the program's version, and the options that were given of those that the
/// result depends on (not the names of files, nor the number of threads).
struct Provenance {
  std::string version;
  std::vector<std::pair<std::string, std::vector<std::string>>>
      options;  ///< values; none of a flag

  /// "--mode 1/2 --improve"
  std::string options_text() const {
    std::string text;
    for (const auto& [name, values] : options) {
      text += (text.empty() ? "" : " ") + name;
      for (const std::string& value : values) text += " " + value;
    }
    return text;
  }
};

}  // namespace tensortopo
