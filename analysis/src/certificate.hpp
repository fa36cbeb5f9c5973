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

/// Throws UsageError for options and files that a certificate cannot describe. (Of the input only
/// its reader knows: `ReadOptions::for_certificate`.)
void require_certifiable(const ReadOptions& options, const std::filesystem::path& output,
                         const std::filesystem::path& certificate);

/// Writes the certificate of a surface, whole or not at all. Throws IoError.
/// @param more  arrays that its file has besides
/// @param whole  what to say of the field, where `read` has a part of it only
CertificateReport write_certificate(const std::filesystem::path& file, const ReadResult& read,
                                    const SurfaceMesh& surface,
                                    const std::vector<CellArray>& more,
                                    const std::vector<CertifiedLevel>& levels,
                                    const CertificateSubject* whole = nullptr);
/// The same of degenerate curves.
CertificateReport write_certificate(const std::filesystem::path& file, const ReadResult& read,
                                    const CurveMesh& curves,
                                    const std::vector<CellArray>& more,
                                    const std::vector<CertifiedCurves>& kinds);

}  // namespace tensortopo
