// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "extract/report/topology_json.hpp"
#include "tensortopo/analysis/certificate_report.hpp"

namespace tensortopo {

/// What reports say of a certificate: an object, or null.
inline nlohmann::ordered_json certificate_json(
    const std::optional<CertificateReport>& certificate) {
  if (!certificate) return nullptr;
  auto undecided = nlohmann::ordered_json::object();
  for (const auto& [reason, count] : certificate->undecided) undecided[reason] = count;
  auto kinds = nlohmann::ordered_json::object();
  for (const auto& [kind, count] : certificate->kinds) kinds[kind] = count;
  nlohmann::ordered_json beyond;
  if (certificate->counts_beyond_checker)
    beyond = {{"tubes", certificate->tubes}, {"critical", certificate->at_critical}};
  return {{"status", certificate->undecided.empty() ? "certified" : "undecided"},
          {"certified", certificate->certified},
          {"kinds", std::move(kinds)},
          {"refuted", 0},
          {"undecided", std::move(undecided)},
          {"undecided_cells",
           listed_cells_json(certificate->listed,
                             [](const auto& listed) -> nlohmann::ordered_json {
                               return {{"cell", listed.first}, {"reason", listed.second}};
                             })},
          {"beyond_checker", std::move(beyond)},
          {"path", certificate->path.string()},
          {"bytes", certificate->bytes}};
}

/// How many tetrahedra are undecided for each reason, and the first of them.
inline std::string undecided_text(const CertificateReport& certificate) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (const auto& [reason, count] : certificate.undecided) {
    text += fmt::format("{}{} {} (cell{}", text.empty() ? "" : ", ", count, reason,
                        count == 1 ? "" : "s");
    std::size_t named = 0;
    for (const auto& [cell, why] : certificate.listed)
      if (why == reason && named++ < kMost) text += fmt::format(" {}", cell);
    text += named > kMost || named < count ? " ...)" : ")";
  }
  return text;
}

/// A line, or nothing.
inline std::string text_of(const std::optional<CertificateReport>& certificate) {
  if (!certificate) return {};
  return fmt::format("{}: {} bytes, {} claims certified ({:.2f} s)\n", certificate->path.string(),
                     certificate->bytes, certificate->certified, certificate->seconds);
}

}  // namespace tensortopo
