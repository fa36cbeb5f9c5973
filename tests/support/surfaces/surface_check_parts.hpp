// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "surface_checks.hpp"

namespace tensortopo::test {

/// Violations by kind, of which only the first few of each kind are spelled out.
class Complaints {
 public:
  explicit Complaints(int spelled_out) : spelled_out_(spelled_out) {}

  template <class... Parts>
  void add(const char* kind, const Parts&... parts) {
    if (++count_[kind] > spelled_out_) return;
    std::ostringstream text;
    text << kind << ": ";
    (text << ... << parts);
    texts_.push_back(text.str());
  }

  std::vector<std::string> take();

 private:
  int spelled_out_;
  std::map<std::string, int> count_;
  std::vector<std::string> texts_;
};

/// Whether an edge of the surface lies in one face of the boundary of the domain.
class BoundaryOracle {
 public:
  BoundaryOracle(const SurfaceMesh& surface, const TetMesh& mesh,
                 const SurfaceCheckOptions& options);

  /// The edge from u to v of a triangle in this tetrahedron.
  bool operator()(SurfaceMesh::Index u, SurfaceMesh::Index v, TetMesh::Index tet) const;

 private:
  const SurfaceMesh& surface_;
  const TetMesh& mesh_;
  const SurfaceCheckOptions& options_;
  std::set<std::array<TetMesh::Index, 3>> boundary_faces_;  // corners in order
};

/// Whether the mode is undefined at a vertex: its carrier is an isotropic vertex of the mesh,
/// or lies between such vertices. False for surfaces without carriers.
bool has_no_mode(const SurfaceMesh& surface, const TetMesh& mesh, std::size_t vertex);

/// Coordinates and directions are finite, directions are of unit length: where the mode is
/// undefined eigenvectors are zero, and a normal may be.
bool check_finite(const SurfaceMesh& surface, const TetMesh& mesh, Complaints& complaints);

/// Triangles are counter-clockwise seen from where the vertex normals point.
void check_normals(const SurfaceMesh& surface, const SurfaceCheckOptions& options,
                   Complaints& complaints, SurfaceReport& report);

/// Modes at vertices, and vertices inside their tetrahedra, with 50 digits.
void check_modes(const SurfaceMesh& surface, const TetMesh& mesh,
                 const SurfaceCheckOptions& options, Complaints& complaints, SurfaceReport& report);

}  // namespace tensortopo::test
