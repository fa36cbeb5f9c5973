// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// A field, the triangles of some levels and the certificate of the program itself, to be altered.
struct Exhibit {
  TetMesh mesh;
  SurfaceMesh surface;
  nlohmann::json certificate;

  /// The certificate gets the hashes that fit the altered numbers.
  void rehash();
  std::string field_text() const;    ///< a .vtu
  std::string surface_text() const;  ///< a .vtp
};

Exhibit exhibit(TetMesh mesh, const std::vector<std::string>& modes);

/// Small meshes whose levels have several sheets in a tetrahedron, several crossings on an edge,
/// closed curves on a face, and more than one mode.
const std::vector<Exhibit>& honest_exhibits();

/// Has files checked, in a folder of its own, which it removes.
class Court {
 public:
  explicit Court(const std::string& name);
  ~Court();
  Court(const Court&) = delete;
  Court& operator=(const Court&) = delete;

  /// "certified", "refuted", "undecided" or "malformed".
  std::string verdict(const std::string& field, const std::string& surface,
                      const std::string& certificate);
  std::string verdict(const Exhibit& e) {
    return verdict(e.field_text(), e.surface_text(), e.certificate.dump());
  }
  std::string report() const { return report_; }  ///< of the last one

 private:
  void put(const char* name, const std::string& text, std::string& last);
  std::filesystem::path folder_;
  std::string field_, surface_, certificate_, report_;
};

/// Do the two certificates say the same, or the second one less, or the same otherwise? A
/// distance may be claimed with other reaches, a larger bound or more coarse tetrahedra, or not at
/// all; and a crossing by a wider or narrower interval: such claims may be true as well.
bool may_be_true(const nlohmann::json& honest, const nlohmann::json& altered);

}  // namespace tensortopo::test
