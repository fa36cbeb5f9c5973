// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/options/given_values.hpp"

#include <algorithm>
#include <string>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

void require_given_values(const CommonOptions& common) {
  for (const CLI::Option* option : common.chosen->get_options()) {
    const auto& values = option->results();
    if (std::any_of(values.begin(), values.end(), [](const auto& v) { return v.empty(); }))
      throw UsageError(option->get_name() +
                       ": its value is an empty text; leave it out, or give it a value");
  }
}

}  // namespace tensortopo
