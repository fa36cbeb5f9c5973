// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

/// Keeps account of claims while they are checked.
class Ledger {
 public:
  explicit Ledger(Report& report) : report_(report) {}

  /// What the claims that follow are about.
  void begin(const std::string& kind) {
    const auto is_it = [&](const Verdicts& v) { return v.kind == kind; };
    kind_ = static_cast<std::size_t>(
        std::find_if(report_.kinds.begin(), report_.kinds.end(), is_it) - report_.kinds.begin());
    if (kind_ == report_.kinds.size()) report_.kinds.push_back({kind, 0, 0, 0});
  }
  /// The claims that follow are about a level, or about none.
  void begin_level(const std::string& name) {
    prefix = name + ", ";
    report_.levels.emplace_back().name = name;
  }
  LevelReport& of_level() { return report_.levels.back(); }
  void certify() {
    ++report_.certified, ++report_.kinds.at(kind_).certified;
    if (!report_.levels.empty()) ++of_level().certified;
  }
  /// @param witness  tells what a reader can look at beside both; asked only if it is shown
  template <class Witness>
  void refute(const std::string& entity, const std::string& claimed, const std::string& derived,
              const Witness& witness) {
    const bool is_shown = report_.refutations.size() < kShown;
    refute(entity, claimed, derived);
    if (is_shown) report_.refutations.back().witness = witness();
  }
  void refute(const std::string& entity, const std::string& claimed, const std::string& derived) {
    ++report_.refuted, ++report_.kinds.at(kind_).refuted;
    if (!report_.levels.empty()) ++of_level().refuted;
    keep(report_.refutations, {prefix + entity, claimed, derived, ""});
  }
  void leave_open(const std::string& entity, const std::string& why) {
    ++report_.undecided, ++report_.kinds.at(kind_).undecided;
    if (!report_.levels.empty()) ++of_level().undecided;
    keep(report_.open, {prefix + entity, why, "", ""});
  }
  /// @param witness  as `refute` has it, or nothing
  template <class... Witness>
  void settle(bool holds, const std::string& entity, const std::string& claimed,
              const std::string& derived, const Witness&... witness) {
    if (holds) {
      certify();
    } else {
      refute(entity, claimed, derived, witness...);
    }
  }
  bool has_refuted() const { return report_.refuted > 0; }
  std::size_t open() const { return report_.undecided; }
  /// Adds what came of a level that was checked by itself.
  void add(Report level) {
    for (const Verdicts& v : level.kinds) {
      begin(v.kind);
      Verdicts& all = report_.kinds.at(kind_);
      all.certified += v.certified, all.refuted += v.refuted, all.undecided += v.undecided;
    }
    report_.certified += level.certified, report_.refuted += level.refuted;
    report_.undecided += level.undecided;
    for (Finding& finding : level.refutations) keep(report_.refutations, std::move(finding));
    for (Finding& finding : level.open) keep(report_.open, std::move(finding));
    std::move(level.levels.begin(), level.levels.end(), std::back_inserter(report_.levels));
    count(level.by_balls, level.by_integers);
  }
  /// Adds to how often each arithmetic decided.
  void count(std::uint64_t by_balls, std::uint64_t by_integers) {
    report_.by_balls += by_balls, report_.by_integers += by_integers;
  }
  std::string prefix;  ///< put before each entity

 private:
  static constexpr std::size_t kShown = 10;
  static void keep(std::vector<Finding>& findings, Finding finding) {
    if (findings.size() < kShown) findings.push_back(std::move(finding));
  }
  Report& report_;
  std::size_t kind_ = 0;
};

}  // namespace certificate
