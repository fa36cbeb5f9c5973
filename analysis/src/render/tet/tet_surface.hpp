// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/input/surface_file.hpp"
#include "render/tet/tet_directions.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"

namespace tensortopo {

/// The generalized mode surface of a linear field in space, and its degenerate curves.
struct TetSurface {
  TetMesh mesh;                       ///< of one tetrahedron, or a cube of six
  std::vector<SurfaceMesh> surfaces;  ///< of mode |mu| and -|mu|, or of mode 0
  std::vector<CurveMesh> curves;      ///< linear, planar
  std::vector<std::string> notes;     ///< one for each tetrahedron that is left out
};

/// In the tetrahedron or, with `beyond` > 1, in a cube around its middle, `beyond` times as large
/// as its longest side.
TetSurface tet_surface(const TetField& field, const ModeValue& mode, double beyond);

/// The directions of a texture at the vertices of a surface of the mesh: principal directions from
/// the derivatives of the field, or dominant eigenvectors.
LineField surface_lines(const SurfaceMesh& surface, const TetMesh& mesh, Texture texture,
                        bool recover = false);

Sheet sheet_of(const SurfaceMesh& surface, double mode, const LineField& lines = {});
Sheet sheet_of(const CurveMesh& curves, double mode);

/// A surface on the sphere: for each triangle its corners' medium eigenvectors, of each pair the
/// one whose point the corner is; at the boundary of the complex domain, where both are, the one
/// next to the other corners. (At mode 0 both are everywhere, and one of them is given.) Nothing
/// for triangles that are torn all the same.
std::vector<std::optional<std::array<Vector3<double>, 3>>> triangles_on_sphere(
    const SurfaceMesh& surface, const TetDirections& directions);

}  // namespace tensortopo
