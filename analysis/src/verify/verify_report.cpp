// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "verify/verify_command.hpp"

#include "append_format.hpp"

namespace tensortopo {
namespace {

using theory::StatementVerdict;

std::string_view words(StatementVerdict verdict) {
  switch (verdict) {
    case StatementVerdict::holds:
      return "holds";
    case StatementVerdict::corrected:
      return "holds as corrected";
    case StatementVerdict::refuted:
      return "refuted with a witness";
    case StatementVerdict::undecided:
      break;
  }
  return "undecided";
}

}  // namespace

std::string to_json(const VerifyReport& report) {
  using Json = nlohmann::ordered_json;
  const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  Json json;
  if (report.mesh) {
    const MeshStrata& m = *report.mesh;
    json["input"] = {
        {"path", m.file.string()},
        {"sha256", m.sha256},
        {"components", name_of(m.components.order)},
        {"tetrahedra", m.tetrahedra},
        {"tried", m.tried},
        {"of_rank", m.of_rank},
        {"with_zero_vertex", m.with_zero_vertex},
        {"with_common_eigenvector", m.with_common_eigenvector},
        {"neutral_characteristic", m.neutral_characteristic},
        {"degenerate_characteristic", m.degenerate_characteristic},
        {"characteristic_mode",
         m.characteristic_modes ? Json(*m.characteristic_modes) : Json::array({nullptr, nullptr})}};
  }
  Json list = Json::array();
  for (const theory::Verification& v : report.statements) {
    const theory::Statement& statement = *theory::find_statement(v.id);
    Json row;
    row["id"] = v.id;
    row["paper"] = statement.paper;
    row["claim"] = statement.claim;
    row["corrected"] = or_null(statement.corrected);
    row["verdict"] = theory::name(v.verdict);
    row["tried"] = v.tried;
    row["configurations"] = v.configurations;
    row["not_applicable"] = v.not_applicable;
    row["witness"] = or_null(v.witness);
    row["scalar"] = theory::name(report.arithmetic);
    row["seconds"] = v.seconds;
    list.push_back(std::move(row));
  }
  json["statements"] = std::move(list);
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const VerifyReport& report) {
  std::string text;
  if (report.mesh) {
    const MeshStrata& m = *report.mesh;
    append_format(text,
                  "{}: {} tetrahedra; of rank 4: {}, 3: {}, 2: {}, 1: {}, 0: {}\n"
                  "    with a zero tensor at a vertex {}, with a common eigenvector {}, with a "
                  "characteristic tensor of determinant 0 {}, of mode -1 {}{}\n",
                  m.file.string(), m.tetrahedra, m.of_rank[4], m.of_rank[3], m.of_rank[2],
                  m.of_rank[1], m.of_rank[0], m.with_zero_vertex, m.with_common_eigenvector,
                  m.neutral_characteristic, m.degenerate_characteristic,
                  m.characteristic_modes
                      ? fmt::format("; its modes are {:.10f} to {:.2e}",
                                    m.characteristic_modes->front(), m.characteristic_modes->back())
                      : "");
    append_format(text, "    statements are tried on {} of the {} tetrahedra (--fields)\n", m.tried,
                  m.tetrahedra);
  }
  append_format(text, "{:<28} {:<22} {:>6} {:>8}  {} | {}\n", "id", "verdict", "fields", "seconds",
                "in the paper", "what it says");
  std::map<StatementVerdict, int> count;
  for (const theory::Verification& v : report.statements) {
    const theory::Statement& statement = *theory::find_statement(v.id);
    append_format(text, "{:<28} {:<22} {:>6} {:>8.3f}  {} | {}\n", v.id, words(v.verdict), v.tried,
                  v.seconds, statement.paper, statement.claim);
    ++count[v.verdict];
    if (v.tried > 0 && v.configurations < theory::kFewConfigurations) {
      append_format(text, "    few: the fields are {} configurations, up to rotation and scaling\n",
                    v.configurations);
    }
    if (!statement.corrected.empty()) {
      append_format(text, "    corrected: {}\n", statement.corrected);
    }
    const bool reason = v.verdict == StatementVerdict::undecided;
    if (!v.witness.empty()) {
      append_format(text, "    {}: {}\n", reason ? "why" : "witness", v.witness);
    }
    for (const auto& [why, lacking] : v.not_applicable) {
      append_format(text, "    not on {} fields: {}\n", lacking, why);
    }
  }
  append_format(text,
                "{} statements over {}: {} hold, {} hold as corrected, {} refuted, {} undecided\n",
                report.statements.size(), theory::name(report.arithmetic),
                count[StatementVerdict::holds], count[StatementVerdict::corrected],
                count[StatementVerdict::refuted], count[StatementVerdict::undecided]);
  return text;
}

}  // namespace tensortopo
