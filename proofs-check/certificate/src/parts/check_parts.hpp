// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

/// Checks a certificate of parts: each part by its own certificate, one after the other, then the
/// seams.
/// @param input  a .pvtu
/// @param surface  a .pvtp, of a surface or of curves
Report check_parts(const std::string& input, const std::string& surface,
                   const std::string& certificate, const Progress& progress);

}  // namespace certificate
