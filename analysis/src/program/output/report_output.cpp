// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/output/report_output.hpp"

#include <nlohmann/json.hpp>

#include "program/output/versions.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;

/// The options and arguments that were given, but for those that no result depends on: true for
/// flags, lists where several are allowed.
Json given_options(const CLI::App& subcommand) {
  Json json = Json::object();
  for (const CLI::Option* option : subcommand.get_options()) {
    if (option->count() == 0) continue;
    std::string name = option->get_lnames().empty() ? option->get_name() : option->get_lnames()[0];
    if (name == "json" || name == "quiet" || name == "threads") continue;
    if (option->get_expected_max() == 0) {
      json[name] = true;
    } else if (option->results().size() == 1 && option->get_expected_max() == 1) {
      json[name] = option->results()[0];
    } else {
      json[name] = option->results();
    }
  }
  return json;
}

}  // namespace

std::string with_provenance(const std::string& text, const CommonOptions& common,
                            std::string_view schema) {
  constexpr int kNumber = 1;
  Json json{{"schema", {{"name", schema}, {"number", kNumber}}},
            {"version", program_version()},
            {"options", common.chosen == nullptr ? Json::object() : given_options(*common.chosen)}};
  const Json report = Json::parse(text);
  for (const auto& [key, value] : report.items())
    if (!json.contains(key)) json[key] = value;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace tensortopo
