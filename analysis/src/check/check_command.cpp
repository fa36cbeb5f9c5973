// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "check/check_command.hpp"

#include <stdexcept>

#include "certificate_check/check_certificate.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

CheckOutcome run_check(const std::string& input, const std::string& surface,
                       const std::string& certificate, const CheckDemands& demands,
                       const Progress& progress) {
  const certificate::Demands all{demands.modes, demands.tensor, demands.complete};
  try {
    certificate::Report().unmet(all);  // are they understood?
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--expect-mode: ") + error.what());
  }
  try {
    const auto report = certificate::check_certificate(input, surface, certificate, progress);
    const auto unmet = report.unmet(all);
    return {certificate::to_text(report, unmet),
            certificate::to_json(report, unmet),
            report.status() == "certified" && unmet.empty(),
            report.certified,
            report.refuted,
            report.undecided};
  } catch (const certificate::Malformed& error) {
    throw IoError(IoError::Kind::invalid, certificate::printable(error.file()),
                  certificate::printable(error.problem()));
  }
}

}  // namespace tensortopo
