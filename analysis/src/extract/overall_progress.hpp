// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

/// Tells of several extractions in a row how much of all of them is done: a fraction that never
/// falls, though an extraction's stages start at zero and may be repeated.
///
/// A stage fills a share of its extraction, from where the last one ended; a repetition fills half
/// of what is left of that share. Shares are those that stages take on bundled fields, roughly.
class OverallProgress {
 public:
  OverallProgress(const Progress& progress, std::size_t extractions)
      : progress_(progress), extractions_(extractions) {}

  explicit operator bool() const { return static_cast<bool>(progress_); }
  /// The next extraction begins.
  /// @param label  precedes the names of its stages
  void begin(std::string label);
  /// As an extraction calls it.
  void operator()(std::string_view stage, double fraction);
  /// All extractions are done.
  void finish(std::string_view stage) const;

 private:
  const Progress& progress_;
  std::size_t extractions_, done_ = 0;
  bool begun_ = false;
  std::string label_, stage_;
  double from_ = 0, to_ = 0;        ///< of the pass, in the extraction
  double reached_ = 0, last_ = 0;   ///< of the extraction; of the pass
};

}  // namespace tensortopo
