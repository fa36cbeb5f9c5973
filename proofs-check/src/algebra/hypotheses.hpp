// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

namespace proofs {

/// The hypotheses that a step uses, recorded while one of these objects lives: relations r^2 = g,
/// by the name of r, and intervals, by that of their variable. One of them can be dropped, which
/// should make the step fail. One at a time.
class Hypotheses {
 public:
  explicit Hypotheses(std::string dropped = {});
  ~Hypotheses();
  Hypotheses(const Hypotheses&) = delete;
  Hypotheses& operator=(const Hypotheses&) = delete;

  const std::set<std::string>& used() const { return used_; }

  /// Notes the use of a hypothesis; false if it is the one that is dropped.
  static bool use(const std::string& name);

 private:
  std::string dropped_;
  std::set<std::string> used_;
};

}  // namespace proofs
