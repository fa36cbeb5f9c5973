// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_theory_search [--seed N] [--walks N] [--steps N] [ID]...
//
// Looks for fields at which a corrected statement fails: walks that start at random fields and go
// towards the exceptional ones, where the paper's wording fails, while the statement's hypotheses
// hold. Prints, for each statement, the fields closest to them at which it was tried and held, as
// initializers, and every field at which it failed.
// Exit status: 0 none failed, 1 one did, 2 wrong usage.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "candidate.hpp"
#include "tensortopo/theory/statement.hpp"

namespace {

using namespace tensortopo::theory;

struct Options {
  std::uint64_t seed = 1;
  int walks = 6, steps = 12;
  std::vector<std::string> ids;
};

struct Found {
  double distance;
  Candidate candidate;
};

struct Search {
  int tried = 0, failed = 0;
  std::vector<Found> held;  // one a walk
};

Search search(const Statement& statement, const Options& options) {
  Search result;
  Random random(options.seed);
  for (const char c : statement.id) random = Random(random.next() + static_cast<unsigned char>(c));
  for (int walk = 0; walk < options.walks; ++walk) {
    Candidate at = random_candidate(random);
    double distance = 2;
    bool held = false;
    for (int step = 0; step < options.steps; ++step) {
      const Candidate next = step == 0 ? at : changed(at, random);
      const double reached = distance_from_exceptional(next);
      if (step > 0 && (reached == 0 || reached > distance)) continue;
      const Outcome outcome = statement.check(trial_of(next));
      if (outcome.kind == Outcome::Kind::not_applicable) {
        if (step == 0) at = random_candidate(random);
        continue;
      }
      ++result.tried;
      if (outcome.kind == Outcome::Kind::violated) {
        ++result.failed;
        std::cout << "FAILS " << statement.id << ' ' << text(next) << ": " << outcome.detail
                  << '\n';
      }
      if (outcome.kind != Outcome::Kind::holds) continue;
      at = next, distance = reached, held = true;
    }
    if (held) result.held.push_back({distance, at});
  }
  std::stable_sort(result.held.begin(), result.held.end(),
                   [](const Found& p, const Found& q) { return p.distance < q.distance; });
  return result;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--seed" && i + 1 < argc) {
      options.seed = std::stoull(argv[++i]);
    } else if (word == "--walks" && i + 1 < argc) {
      options.walks = std::stoi(argv[++i]);
    } else if (word == "--steps" && i + 1 < argc) {
      options.steps = std::stoi(argv[++i]);
    } else if (find_statement(word) != nullptr) {
      options.ids.push_back(word);
    } else {
      std::cerr << "usage: tensortopo_theory_search [--seed N] [--walks N] [--steps N] [ID]...\n";
      return 2;
    }
  }
  int failed = 0;
  for (const Statement& statement : statements()) {
    const bool is_named =
        std::find(options.ids.begin(), options.ids.end(), statement.id) != options.ids.end();
    if (options.ids.empty() ? statement.corrected.empty() : !is_named) continue;
    const Search found = search(statement, options);
    std::cout << "// " << statement.id << ": " << found.tried << " tried, " << found.failed
              << " failed\n";
    for (std::size_t i = 0; i < std::min<std::size_t>(2, found.held.size()); ++i) {
      std::cout << "{\"" << statement.id << "\", " << text(found.held[i].candidate) << "},  // "
                << found.held[i].distance << '\n';
    }
    std::cout.flush();
    failed += found.failed;
  }
  return failed == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "tensortopo_theory_search: " << error.what() << '\n';
  return 2;
}
