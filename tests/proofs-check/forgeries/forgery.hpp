// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// An array of a surface's file.
struct FileArray {
  std::string of;  ///< "points" or "triangles"
  std::string type, name;
  int width = 1;
  std::vector<double> numbers;
};

/// A field, the triangles of some levels and the certificate of the program itself, to be altered.
struct Exhibit {
  TetMesh mesh;
  SurfaceMesh surface;
  std::vector<FileArray> arrays;  ///< besides the geometry and `tet`
  nlohmann::json certificate;
  /// What else is done to the three files' texts: all of a text that is there is replaced.
  struct Edit {
    std::string from, to;
    bool once = false;  ///< the first only
  };
  std::vector<Edit> in_field, in_surface, in_certificate;

  /// The certificate gets the hashes that fit the altered numbers. If it has some of arrays, the
  /// file gets those of the surface.
  void rehash();
  std::string field_text() const;    ///< a .vtu
  std::string surface_text() const;  ///< a .vtp
  std::string certificate_text() const;
};

/// @param levels  modes "-1/2", or invariants with values "magnitude 3/2"
/// @param pieces  as in InvariantOptions
Exhibit exhibit(TetMesh mesh, const std::vector<std::string>& levels, int pieces = 1);
/// The same with the arrays that `write_surface` writes. The levels must be all of modes or all of
/// invariants.
Exhibit exhibit_with_arrays(TetMesh mesh, const std::vector<std::string>& levels);

/// Two tetrahedra that have one edge in common, which modes 0 and 1/4 cross, and magnitudes 29/20.
TetMesh two_tets_at_an_edge();

/// Small meshes whose levels have several sheets in a tetrahedron, several crossings on an edge,
/// closed curves on a face, and more than one mode; of other invariants also closed sheets.
const std::vector<Exhibit>& honest_exhibits();

/// Tensors of a tetrahedron that are zero at a point inside it, inside the face of its first three
/// vertices, on the edge of its first two: small values are around that point.
inline constexpr TetTensors kAroundZero{{{1, -1, 0, 0.25, 0, 0},
                                         {0, 1, -1, 0, 0.5, 0},
                                         {0, 0.5, -0.5, 1, 0, 0.5},
                                         {-1, -0.5, 1.5, -1.25, -0.5, -0.5}}};
inline constexpr TetTensors kZeroInFace{{{1, -1, 0, 0.25, 0, 0},
                                         {0, 1, -1, 0, 0.5, 0},
                                         {-1, 0, 1, -0.25, -0.5, 0},
                                         {0.5, 0.5, -1, 1, 0, 0.75}}};
inline constexpr TetTensors kZeroOnEdge{{{1, -1, 0, 0.25, 0, 0},
                                         {-2, 2, 0, -0.5, 0, 0},
                                         {0, 1, -1, 0, 0.5, 1},
                                         {0.5, 0.5, -1, 1, 0, 0.75}}};

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
    return verdict(e.field_text(), e.surface_text(), e.certificate_text());
  }
  std::string report() const { return report_; }  ///< of the last one

 private:
  void put(const char* name, const std::string& text, std::string& last);
  std::filesystem::path folder_;
  std::string field_, surface_, certificate_, report_;
};

}  // namespace tensortopo::test
