// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/mesh/validate.hpp"
#include "tensortopo/modes/mode_extractor.hpp"

namespace tensortopo::python {

/// A mesh with what is wrong with it. Nothing but `defects` may be asked of one that has any.
struct Mesh {
  TetMesh mesh;
  std::vector<MeshDefect> defects;
  std::size_t reoriented = 0;  ///< tetrahedra turned around
  std::unique_ptr<ModeExtractor> extractor;

  /// Turns tetrahedra of negative volume around, and looks for defects.
  explicit Mesh(TetMesh given);
};

void define_mesh(pybind11::module_& m);
void define_partition(pybind11::module_& m, pybind11::class_<Mesh>& mesh);
void define_merged_curves(pybind11::module_& m);
void define_curve_pieces(pybind11::module_& m, pybind11::class_<Mesh>& mesh);
void define_extraction(pybind11::class_<Mesh>& mesh);
void define_persistence(pybind11::class_<Mesh>& mesh);
void define_sweep(pybind11::class_<Mesh>& mesh);
void define_families(pybind11::module_& m);
void define_tensors(pybind11::module_& m);

}  // namespace tensortopo::python
