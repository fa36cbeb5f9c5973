// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_identities [--mutate]
//
// Without an option: expands each identity and reports whether it is true. With --mutate: changes
// one constant at a time, in every identity, and reports whether all changes are noticed.
// Exit status: 0 all is as it should be, 1 something is not, 2 wrong usage.
#include <algorithm>
#include <cstring>
#include <exception>
#include <iostream>

#include "identity.hpp"

namespace {

using identities::Constants;
using identities::Identity;

std::vector<Identity> all_identities() {
  std::vector<Identity> all;
  for (const auto& part :
       {identities::form_identities(), identities::polarization_identities(),
        identities::mode_parameter_identities(), identities::boundary_identities(),
        identities::sphero_conal_identities(), identities::critical_point_identities()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

bool holds(const Identity& identity, Constants& constants) {
  const auto differences = identity.differences(constants);
  return !differences.empty() &&
         std::all_of(differences.begin(), differences.end(),
                     [](const auto& difference) { return difference.is_zero(); });
}

/// Prints a verdict for each identity; the number of those refuted.
std::size_t verify(const std::vector<Identity>& all) {
  std::size_t refuted = 0;
  for (const auto& identity : all) {
    Constants constants;
    const bool verified = holds(identity, constants);
    refuted += verified ? 0 : 1;
    std::cout << (verified ? "verified  " : "refuted   ") << identity.id << ": "
              << identity.statement << '\n';
  }
  std::cout << all.size() - refuted << " verified, " << refuted << " refuted\n";
  return refuted;
}

/// Prints for each identity how many changes of a constant were noticed; the number of those that
/// were not. An identity that is false by itself, or has no constants, counts as one that was not.
std::size_t mutate(const std::vector<Identity>& all) {
  std::size_t changes = 0, overlooked = 0;
  for (const auto& identity : all) {
    Constants unchanged;
    std::size_t survivors = !holds(identity, unchanged) || unchanged.count() == 0 ? 1 : 0;
    for (std::size_t i = 0; i < unchanged.count(); ++i) {
      Constants constants(i);
      if (holds(identity, constants)) {
        ++survivors;
        std::cout << "overlooked  " << identity.id << ": change of constant " << i << '\n';
      }
    }
    changes += unchanged.count();
    overlooked += survivors;
    std::cout << (survivors == 0 ? "refuted   " : "verified  ") << identity.id << ": "
              << unchanged.count() << " changes of a constant, " << survivors << " overlooked\n";
  }
  std::cout << changes << " changes, " << overlooked << " overlooked\n";
  return overlooked;
}

}  // namespace

int main(int argc, char** argv) try {
  const bool mutating = argc == 2 && std::strcmp(argv[1], "--mutate") == 0;
  if (argc > 1 && !mutating) {
    std::cerr << "usage: tensortopo_identities [--mutate]\n";
    return 2;
  }
  const auto all = all_identities();
  const std::size_t failures = mutating ? mutate(all) : verify(all);
  std::cout.flush();
  return failures == 0 && std::cout ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "tensortopo_identities: " << error.what() << '\n';
  return 1;
}
