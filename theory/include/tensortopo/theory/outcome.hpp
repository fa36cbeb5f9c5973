// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

namespace tensortopo::theory {

/// What one trial says about a statement.
struct Outcome {
  enum class Kind {
    holds,
    violated,        ///< `detail` is a witness
    not_applicable,  ///< the trial lacks a hypothesis, named in `detail`
    undecided,       ///< `detail` is the reason
  };
  Kind kind = Kind::holds;
  std::string detail;
  /// If undecided between 0 and not 0: a bound on how far from 0.
  double reach = 0;
  /// Numbers that determine what was tried, up to rotation and scaling; no part of the outcome.
  std::string configuration{};

  static Outcome holds() { return {}; }
  static Outcome violated(std::string witness) {
    return {Kind::violated, std::move(witness), 0, {}};
  }
  static Outcome not_applicable(std::string why) {
    return {Kind::not_applicable, std::move(why), 0, {}};
  }
  static Outcome undecided(std::string why, double reach = 0) {
    return {Kind::undecided, std::move(why), reach, {}};
  }
  friend bool operator==(const Outcome& p, const Outcome& q) {
    return p.kind == q.kind && p.detail == q.detail && p.reach == q.reach;
  }
};

}  // namespace tensortopo::theory
