// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "polynomial.hpp"

namespace identities {

/// The numbers that an identity claims. Each is asked for by value, in the order in which the
/// identity uses them; one of them can be changed (increased by one), which should make the
/// identity false.
class Constants {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  explicit Constants(std::size_t changed = none) : changed_(changed) {}

  Polynomial operator()(long numerator, long denominator = 1) {
    mpq_class value(numerator, denominator);
    value.canonicalize();
    if (count_++ == changed_) value += 1;
    return value;
  }
  /// How many were asked for.
  std::size_t count() const { return count_; }

 private:
  std::size_t changed_, count_ = 0;
};

/// A statement together with polynomials that vanish if and only if it holds: left sides minus
/// right sides, in normal form modulo the relations that the statement names.
struct Identity {
  std::string id, statement;
  std::function<std::vector<Polynomial>(Constants&)> differences;
};

inline Polynomial variable(const std::string& name) { return Polynomial::variable(name); }

std::vector<Identity> form_identities();
std::vector<Identity> polarization_identities();
std::vector<Identity> mode_parameter_identities();
std::vector<Identity> boundary_identities();
std::vector<Identity> sphero_conal_identities();
std::vector<Identity> critical_point_identities();

}  // namespace identities
