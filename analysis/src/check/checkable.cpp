// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "check/checkable.hpp"

#include <fmt/format.h>

#include "certificate_check/check_certificate.hpp"
#include "counted.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

std::string why_not_checkable(const std::filesystem::path& input,
                              const CertificateSubject& here) {
  try {
    const auto there = certificate::read_subject(input.string(), here.tensor, here.components);
    if (there.points != here.points || there.tetrahedra != here.tetrahedra)
      return fmt::format("it reads {} and {}", counted(there.points, "point"),
                         counted_tets(there.tetrahedra));
    return there.sha256 == here.field_sha256 ? "" : "it reads other numbers";
  } catch (const certificate::Malformed& error) {
    return certificate::printable(error.problem());
  }
}

void require_checkable(const std::filesystem::path& input, const CertificateSubject& subject) {
  const std::string why = why_not_checkable(input, subject);
  if (why.empty()) return;
  const bool has_remedy = why.find("tensortopo convert") != std::string::npos;
  throw IoError(IoError::Kind::inapplicable, input,
                "the checker of certificates does not read this file as it is: " + why +
                    (has_remedy ? "" : "; write it anew with tensortopo convert, and certify that"));
}

}  // namespace tensortopo
