// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

std::string Report::status() const {
  return refuted > 0 ? "refuted" : undecided > 0 ? "undecided" : "certified";
}

std::string to_text(const Report& report) {
  const auto counts = [](const auto& of) {
    return std::to_string(of.certified) + " certified, " + std::to_string(of.refuted) +
           " refuted, " + std::to_string(of.undecided) + " undecided\n";
  };
  std::string text =
      report.status() + ": " + std::to_string(report.claims()) + " claims, " + counts(report);
  for (const Finding& f : report.refutations)
    text += "refuted: " + f.entity + ": claimed " + f.claimed + "; derived " + f.derived + '\n';
  for (const Finding& f : report.open) text += "undecided: " + f.entity + ": " + f.claimed + '\n';
  for (const Verdicts& kind : report.kinds)
    if (kind.certified + kind.refuted + kind.undecided > 0)
      text += "  " + kind.kind + ": " + counts(kind);
  if (report.by_balls + report.by_integers > 0)
    text += "  decided by doubles with an error bound: " + std::to_string(report.by_balls) +
            ", by integers: " + std::to_string(report.by_integers) + '\n';
  return text;
}

std::string to_json(const Report& report) {
  nlohmann::ordered_json json{{"status", report.status()},
                              {"claims", report.claims()},
                              {"certified", report.certified},
                              {"refuted", report.refuted},
                              {"undecided", report.undecided}};
  for (const Verdicts& kind : report.kinds)
    json["kinds"][kind.kind] = {{"certified", kind.certified},
                                {"refuted", kind.refuted},
                                {"undecided", kind.undecided}};
  json["decided"] = {{"by_balls", report.by_balls}, {"by_integers", report.by_integers}};
  auto& refutations = json["witnesses"] = nlohmann::ordered_json::array();
  for (const Finding& f : report.refutations)
    refutations.push_back({{"entity", f.entity}, {"claimed", f.claimed}, {"derived", f.derived}});
  return json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace certificate
