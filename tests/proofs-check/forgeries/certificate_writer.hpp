// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {

/// A field, a surface and a certificate, written to files in a folder of their own.
struct CertifiedSurface {
  std::filesystem::path folder;
  nlohmann::json certificate;

  std::string input() const { return (folder / "field.vtu").string(); }
  std::string surface() const { return (folder / "surface.vtp").string(); }
  /// Writes a certificate to a file, and returns its name.
  std::string write(const nlohmann::json& document, const std::string& name = "c.json") const;
};

/// Adds what files hold of a level's surface to those of other levels: points, triangles,
/// tetrahedra.
void append_level(SurfaceMesh& all, const SurfaceMesh& level);

/// Extracts the levels, and reads the claims off the triangles and where their vertices lie: what
/// the extractor believes, which the checker is to judge.
CertifiedSurface certified_surface(const TetMesh& mesh, const std::vector<std::string>& modes,
                                   const std::filesystem::path& folder);

}  // namespace tensortopo::test
