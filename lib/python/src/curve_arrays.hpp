// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"

namespace tensortopo::python {

/// Hands the arrays of curves over to Python.
inline void put_curves(py::dict& out, CurveMesh&& c) {
  std::vector<std::int64_t> offsets{0};
  std::vector<CurveMesh::Index> connectivity;
  for (const auto& line : c.lines) {
    connectivity.insert(connectivity.end(), line.begin(), line.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  out["points"] = array_of<double>(std::move(c.points));
  out["offsets"] = array_of<std::int64_t>(std::move(offsets));
  out["connectivity"] = array_of<CurveMesh::Index>(std::move(connectivity));
  out["dominant_eigenvectors"] = array_of<double>(std::move(c.dominant_eigenvector));
  out["mode"] = array_of<double>(std::move(c.mode));
  out["residual"] = array_of<double>(std::move(c.residual));
  out["separation"] = array_of<double>(std::move(c.separation));
  out["carrier"] = array_of<std::uint8_t>(std::move(c.carrier));
  out["carrier_vertices"] = array_of<CurveMesh::Index>(std::move(c.carrier_vertices));
  out["tet"] = array_of<CurveMesh::Index>(std::move(c.tet));
  out["component"] = array_of<CurveMesh::Index>(std::move(c.component));
}

}  // namespace tensortopo::python
