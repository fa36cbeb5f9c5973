// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "honest_verdict.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace tensortopo::test {

HonestCourt::HonestCourt(const std::string& name)
    : folder_(std::filesystem::path(testing::TempDir()) /
              ("honest_" + name + '_' + std::to_string(getpid()))) {
  std::filesystem::create_directories(folder_);
}

HonestCourt::~HonestCourt() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

HonestVerdict HonestCourt::judge(const Exhibit& e) const {
  const auto write = [&](const char* name, const std::string& text) {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  };
  const std::string field = write("field.vtu", e.field_text()),
                    surface = write("surface.vtp", e.surface_text()),
                    claims = write("claims.json", e.certificate.dump());
  HonestVerdict result;
  result.triangles = e.surface.triangles.size();
  try {
    const certificate::Report report = certificate::check_certificate(field, surface, claims);
    result.status = report.status();
    result.claims = report.claims();
    result.report = to_text(report);
    for (const auto& level : report.levels)
      for (const auto& [name, shown] : level.vectors)
        result.vectors += level.vertices, result.vectors_shown += shown;
    for (const auto& kind : report.kinds)
      if (kind.undecided > 0 && kind.kind != "left out")
        result.open["checker: " + kind.kind] += static_cast<int>(kind.undecided);
  } catch (const certificate::Malformed& error) {
    result.status = "malformed";
    result.report = error.what();
  }
  for (const auto& level : e.certificate["levels"])
    for (const auto& cell : level["undecided"])
      ++result.open["extractor: " + cell[1].get<std::string>()];
  return result;
}

}  // namespace tensortopo::test
