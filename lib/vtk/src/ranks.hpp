// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace tensortopo::filters {

/// The application has asked for an end.
struct Aborted {};

/// The processes that each have a piece of a grid. All call the same functions in the same order.
class Ranks {
 public:
  /// @param controller  of these processes; none for this one alone
  explicit Ranks(vtkMultiProcessController* controller = nullptr) : controller_(controller) {}

  int count() const;  ///< how many there are
  int own() const;    ///< this one, from 0
  bool are_several() const { return count() > 1; }

  /// What each rank gives, on all of them.
  std::vector<std::vector<std::int64_t>> gather(const std::vector<std::int64_t>& numbers) const;
  std::vector<std::string> gather(const std::string& text) const;  ///< the same of texts

  /// Does work on each rank. If it throws on one, all throw: the error of the first rank that has
  /// one as std::runtime_error, else Aborted.
  void together(const std::function<void()>& work) const;

 private:
  vtkMultiProcessController* controller_;
};

}  // namespace tensortopo::filters
