// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate_check/check_certificate.hpp"
#include "files/file.hpp"
#include "parts/part_border.hpp"
#include "parts/part_curves.hpp"

namespace certificate {

/// A part's own certificate, checked, and what is needed of the part to put it together with
/// others.
struct CheckedPart {
  Report report;
  PartBorder border;
};

/// As `check_certificate`. The certificate must be of a surface with one level.
CheckedPart check_part(const File& input, const File& surface, const File& certificate,
                       const Progress& progress);

/// The same of degenerate curves.
struct CheckedCurves {
  Report report;
  PartCurves curves;
};

/// As `check_certificate`. The certificate must be of curves with one level.
CheckedCurves check_curve_part(const File& input, const File& polylines, const File& certificate,
                               const Progress& progress);

}  // namespace certificate
