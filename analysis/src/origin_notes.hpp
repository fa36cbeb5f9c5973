// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tensortopo/analysis/provenance.hpp"
#include "tensortopo/io/write_surface.hpp"

namespace tensortopo {

/// What a .vtp says of its origin as field data.
/// @param report  of what was read and how: it has `provenance`, `sha256`, `tensor_name`,
///                `components`
template <class Report>
std::vector<FileNote> origin_notes(const Report& report) {
  Provenance other = report.provenance;  // what no other note says
  std::erase_if(other.options, [](const auto& option) {
    for (const char* said : {"--mode", "--generalized", "--value", "--tensor", "--components"})
      if (option.first == said) return true;
    return false;
  });
  return {{"tensortopo_version", report.provenance.version},
          {"options", other.options_text()},
          {"input_sha256", report.sha256},
          {"tensor", report.tensor_name},
          {"components", std::string(name_of(report.components.order))}};
}

}  // namespace tensortopo
