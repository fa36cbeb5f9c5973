// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo::python {

/// Hands the arrays of a surface over to Python, but for the components.
inline void put_surface(py::dict& out, SurfaceMesh&& s) {
  out["points"] = array_of<double>(std::move(s.points));
  out["triangles"] = array_of<SurfaceMesh::Index>(std::move(s.triangles));
  out["normals"] = array_of<double>(std::move(s.normal));
  out["medium_eigenvectors"] = array_of<double>(std::move(s.medium_eigenvector));
  out["dominant_eigenvectors"] = array_of<double>(std::move(s.dominant_eigenvector));
  out["mode"] = array_of<double>(std::move(s.mode));
  out["residual"] = array_of<double>(std::move(s.residual));
  out["carrier"] = array_of<std::uint8_t>(std::move(s.carrier));
  out["carrier_vertices"] = array_of<SurfaceMesh::Index>(std::move(s.carrier_vertices));
  out["tet"] = array_of<SurfaceMesh::Index>(std::move(s.tet));
}

}  // namespace tensortopo::python
