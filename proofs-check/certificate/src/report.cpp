// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

std::string Report::status() const {
  return refuted > 0 ? "refuted" : undecided > 0 ? "undecided" : "certified";
}

std::string to_text(const Report& report) {
  std::string text = report.status() + ": " + std::to_string(report.claims()) + " claims, " +
                     std::to_string(report.certified) + " certified, " +
                     std::to_string(report.refuted) + " refuted, " +
                     std::to_string(report.undecided) + " undecided\n";
  for (const Finding& f : report.refutations)
    text += "refuted: " + f.entity + ": claimed " + f.claimed + "; derived " + f.derived + '\n';
  for (const Finding& f : report.open) text += "undecided: " + f.entity + ": " + f.claimed + '\n';
  return text;
}

std::string to_json(const Report& report) {
  nlohmann::ordered_json json{{"status", report.status()},
                              {"claims", report.claims()},
                              {"certified", report.certified},
                              {"refuted", report.refuted},
                              {"undecided", report.undecided}};
  auto& refutations = json["witnesses"] = nlohmann::ordered_json::array();
  for (const Finding& f : report.refutations)
    refutations.push_back({{"entity", f.entity}, {"claimed", f.claimed}, {"derived", f.derived}});
  return json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace certificate
