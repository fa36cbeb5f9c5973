// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "tensortopo/analysis/certificate_report.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/cell_array.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// What a certificate says of its input.
CertificateSubject subject_of(const ReadResult& read);

/// Throws UsageError for options and names of files that a certificate cannot describe. (Of the
/// input see `require_checkable`.)
void require_certifiable(const ReadOptions& options, const std::filesystem::path& output,
                         const std::filesystem::path& certificate);

/// Writes the certificate of a surface, whole or not at all. Throws IoError.
/// @param field  what to say of the input
/// @param more  arrays that its file has besides
CertificateReport write_certificate(const std::filesystem::path& file, CertificateSubject field,
                                    const ReadResult& read, const SurfaceMesh& surface,
                                    const std::vector<CellArray>& more,
                                    const std::vector<CertifiedLevel>& levels);
/// The same of degenerate curves.
CertificateReport write_certificate(const std::filesystem::path& file, CertificateSubject field,
                                    const ReadResult& read,
                                    const CurveMesh& curves,
                                    const std::vector<CellArray>& more,
                                    const std::vector<CertifiedCurves>& kinds);

}  // namespace tensortopo
