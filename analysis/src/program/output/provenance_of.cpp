// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/output/provenance_of.hpp"

#include <algorithm>

namespace tensortopo {

Provenance provenance_of(const CLI::App& app, const CommonOptions& common) {
  Provenance provenance{TENSORTOPO_VERSION, {}};
  const auto names_a_file = [&](const CLI::Option* option) {
    return std::count(common.reads.begin(), common.reads.end(), option) > 0 ||
           std::count(common.writes.begin(), common.writes.end(), option) > 0;
  };
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || names_a_file(option) || name == "--json" || name == "--quiet" ||
        name == "--threads" || name == "--pieces" || name == "--memory" || name == "--stream")
      continue;
    const bool is_flag = option->get_expected_max() == 0;
    provenance.options.emplace_back(name, is_flag ? std::vector<std::string>{} : option->results());
  }
  return provenance;
}

}  // namespace tensortopo
