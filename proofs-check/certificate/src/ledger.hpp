// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

/// Keeps account of claims while they are checked.
class Ledger {
 public:
  explicit Ledger(Report& report) : report_(report) {}

  void certify() { ++report_.certified; }
  void refute(const std::string& entity, const std::string& claimed, const std::string& derived) {
    ++report_.refuted;
    keep(report_.refutations, {level + entity, claimed, derived});
  }
  void leave_open(const std::string& entity, const std::string& why) {
    ++report_.undecided;
    keep(report_.open, {level + entity, why, ""});
  }
  void settle(bool holds, const std::string& entity, const std::string& claimed,
              const std::string& derived) {
    if (holds) {
      certify();
    } else {
      refute(entity, claimed, derived);
    }
  }
  std::string level;  ///< put before each entity

 private:
  static void keep(std::vector<Finding>& findings, Finding finding) {
    constexpr std::size_t kShown = 10;
    if (findings.size() < kShown) findings.push_back(std::move(finding));
  }
  Report& report_;
};

/// Numbers, and numbers of numbers, as JSON has them.
template <class T>
std::string text(const T& item) {
  if constexpr (requires { item.begin(); }) {
    std::string result = "[";
    for (const auto& x : item) result += (result.size() > 1 ? ", " : "") + text(x);
    return result + "]";
  } else {
    return std::to_string(item);
  }
}

}  // namespace certificate
