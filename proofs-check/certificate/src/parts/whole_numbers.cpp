// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/whole_numbers.hpp"

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace certificate {

bool compare_whole_numbers(const std::vector<std::vector<SaidNumber>>& parts,
                           const std::vector<std::size_t>& numbers, std::size_t count,
                           Ledger& ledger) {
  std::map<std::size_t, double> said;
  std::set<double> all;
  std::size_t i = 0, silent = 0;
  const auto wrong = [&](std::size_t part, const std::string& what) {
    ledger.refute("whole_component",
                   "the components of the whole, each with a number of its own from 0",
                   what + " in part " + std::to_string(part));
    return false;
  };
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const SaidNumber& part : parts[p]) {
      const std::size_t number = numbers[i++];
      if (!part.whole) {
        ++silent;
        continue;
      }
      if (!part.whole_is_one) return wrong(p, "several numbers on one component");
      const auto [known, is_new] = said.try_emplace(number, *part.whole);
      if (known->second != *part.whole) return wrong(p, "another number for the same component");
      if (is_new && !all.insert(*part.whole).second)
        return wrong(p, "the number of another component");
      if (!(*part.whole >= 0 && *part.whole < static_cast<double>(count)) ||
          *part.whole != std::floor(*part.whole))
        return wrong(p, "what is no number of a component");
    }
  if (silent == i) return false;  // nothing is claimed
  if (silent > 0) return wrong(0, "no array, though other parts have one, or none");
  ledger.certify();
  return true;
}

}  // namespace certificate
