// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "level.hpp"
#include "run/parallel.hpp"

namespace certificate {

/// Bounds what one check spends on topology, in decisions of signs, by the size of its files: a file
/// that is compressed can repeat a difficult tetrahedron many times. What comes after the limit stays
/// undecided. That does not depend on the number of threads, nor on the machine.
class WorkLimit {
 public:
  explicit WorkLimit(std::uint64_t decisions) : left_(decisions) {}
  /// @param bytes  of all files
  static WorkLimit of_files(std::size_t bytes) { return WorkLimit(kLeast + kPerByte * bytes); }

  bool is_reached() const { return left_ == 0; }

  /// For a new level: calls in parallel, in parts after each of which the limit is looked at.
  ForAll within(const Level& level, const Progress& progress) {
    counted_ = 0;
    return [this, &level, progress](std::size_t count, const std::function<void(std::size_t)>& f,
                                    const char* what) {
      for (std::size_t first = 0; first < count && !is_reached();) {
        if (progress) progress(what, static_cast<double>(first) / static_cast<double>(count));
        const std::size_t size =
            std::min(count - first, std::clamp<std::size_t>(left_ / kDear, 64, 8192));
        parallel_for(size, [&](std::size_t i) { f(first + i); });
        first += size;
        spend(level);
      }
    };
  }

 private:
  /// Counts what a level has decided since it was last counted.
  void spend(const Level& level) {
    const std::uint64_t decided = level.decided_by_balls() + level.decided_exactly();
    left_ -= std::min(left_, decided - counted_);
    counted_ = decided;
  }

  /// Difficult levels of one tetrahedron take some 100,000, next to modes 1 and -1 five times as
  /// many; a field near its degenerate curves takes three for each byte of its files; others fewer.
  static constexpr std::uint64_t kLeast = 4000000, kPerByte = 8;
  static constexpr std::uint64_t kDear = 100000;  ///< of a difficult edge, face or tetrahedron

  std::uint64_t left_;
  std::uint64_t counted_ = 0;  ///< of the level
};

}  // namespace certificate
