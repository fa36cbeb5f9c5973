// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "counted.hpp"
#include "extract/report/certificate_report_output.hpp"
#include "program/options/common_options.hpp"
#include "tensortopo/analysis/certificate_report.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

/// Writes to standard output, and means it. Throws IoError.
inline void print(std::string_view text) {
  std::cout << text << std::flush;
  if (!std::cout) throw IoError(IoError::Kind::unwritable, "standard output", "cannot write");
}

/// A report's JSON object with what made it in front: `schema` (name and number: the file
/// analysis/schema/NAME.json), `version` of the program, and `options` that were given.
std::string with_provenance(const std::string& json, const CommonOptions& common,
                            std::string_view schema);

/// Prints a report as JSON or text. Of subcommands whose result is a file `--quiet` prints no text.
template <class Json, class Text>
void print_report(const CommonOptions& common, std::string_view schema, const Json& json,
                  const Text& text, bool is_result = false) {
  if (common.json) {
    print(with_provenance(json(), common, schema));
  } else if (is_result || !common.quiet) {
    print(text());
  }
}

/// Says, unless it is to be quiet, what there is to say of a file; a line each.
inline void say_notes(const std::filesystem::path& file, const std::vector<std::string>& notes,
                      bool quiet) {
  if (quiet) return;
  for (const std::string& note : notes)
    std::cerr << "tensortopo: " << file.string() << ": " << note << '\n';
}

/// Says, unless it is to be quiet, how much a certificate leaves undecided. False if nothing.
/// Also what the checker may leave open, though it is proved.
inline bool say_undecided(const std::optional<CertificateReport>& certificate, bool quiet) {
  if (!certificate) return false;
  std::vector<std::string> notes;
  if (certificate->tubes > 0)
    notes.push_back(counted(certificate->tubes, "thin tube") +
                    " proved by the degenerate curves inside; tensortopo check cuts them into "
                    "small parts instead, which takes longer and may leave some open");
  if (certificate->at_critical > 0)
    notes.push_back(counted_tets(certificate->at_critical) +
                    " proved at a mode next to a critical one; tensortopo check has no such proof "
                    "and may leave this open");
  if (!certificate->counts_beyond_checker)
    notes.emplace_back(
        "in pieces it is not counted what tensortopo check may leave open (thin "
        "tubes next to modes 1 and -1, critical modes)");
  const bool is_undecided = certificate->undecided_cells > 0;
  if (is_undecided)
    notes.push_back(counted_tets(certificate->undecided_cells) +
                    " undecided, so that nothing is certified of the surface there: " +
                    undecided_text(*certificate));
  say_notes(certificate->path, notes, quiet);
  return is_undecided;
}

}  // namespace tensortopo
