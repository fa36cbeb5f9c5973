// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tensortopo/analysis/baseline.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Each mode and its opposite, each once, in order.
std::vector<ModeValue> with_opposites(std::span<const ModeValue> modes);

/// The modes in doubles, which contour filters take.
std::vector<double> approximations(std::span<const ModeValue> modes);

/// Our surfaces, at a resolution; what the modes have in common is computed once.
/// @param stages  if given: the seconds of edges, faces, tets, stitch
std::vector<SurfaceMesh> our_surfaces(const TetMesh& mesh, std::span<const ModeValue> modes,
                                      double resolution,
                                      std::map<std::string, double>* stages = nullptr,
                                      MeshingMethod drawing = MeshingMethod::bisection);

/// Our surfaces with all that a certificate claims about them: triangles made.
std::size_t certify_all(const TetMesh& mesh, std::span<const ModeValue> modes, double resolution);

std::vector<SurfaceMesh> baseline_surfaces(Baseline method, const TetMesh& mesh,
                                           std::span<const ModeValue> modes,
                                           const BaselineOptions& options = {});

std::size_t triangles_of(std::span<const SurfaceMesh> surfaces);

}  // namespace tensortopo
