// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "check/check_command.hpp"

#include "certificate_check/check_certificate.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

CheckOutcome run_check(const std::string& input, const std::string& surface,
                       const std::string& certificate, const Progress& progress) {
  try {
    const auto report = certificate::check_certificate(input, surface, certificate, progress);
    return {certificate::to_text(report), certificate::to_json(report),
            report.status() == "certified", report.certified, report.refuted, report.undecided};
  } catch (const certificate::Malformed& error) {
    throw IoError(IoError::Kind::invalid, error.file(), error.problem());
  }
}

}  // namespace tensortopo
