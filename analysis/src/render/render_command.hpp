// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene/scene.hpp"
#include "render/scene/texture.hpp"
#include "render/tet/tet_picture.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/quadric/invariant_level.hpp"

namespace tensortopo {

/// From surfaces, a field, or one tetrahedron of a field, to a picture or a row of pictures.
struct RenderCommand {
  std::vector<std::filesystem::path> surfaces;  ///< .vtp
  std::optional<std::filesystem::path> mesh;    ///< the domain: .vtu, .pvtu or legacy .vtk
  ReadOptions read;                             ///< of the mesh
  std::filesystem::path output;                 ///< .png; with frames also .gif, .mp4
  View view;

  /// Surfaces (of 1 and -1 curves) to extract from the mesh and draw; of a tetrahedron the modes
  /// whose generalized surfaces are drawn side by side.
  std::vector<ModeValue> modes;
  bool generalized = false;  ///< with each mode its opposite; of a tetrahedron always
  /// Surfaces of other invariants to extract and draw, instead of `modes`.
  std::vector<InvariantLevel> levels;
  int pieces = 2;                 ///< of these, as in InvariantOptions
  std::vector<ModeValue> frames;  ///< a picture for each of these, instead of `modes`
  Texture texture = Texture::none;
  bool recover = false;  ///< a texture of the smooth field's curvature, by recovered derivatives

  std::optional<std::int64_t> tet;  ///< draw this tetrahedron of the mesh, by its cell in the file
  bool any_tet = false;             ///< or one that the surface meets
  bool one_tet() const { return any_tet || tet.has_value(); }
  std::vector<Panel> panels;        ///< none: the manifold and the surface
  double beyond = 1;                ///< see TetPicture
  std::optional<Vector3<double>> marked;
};

struct RenderReport {
  int width = 0, height = 0;  ///< pixels
  std::vector<double> modes;
  std::vector<double> values;                 ///< of surfaces of other invariants
  std::vector<std::filesystem::path> frames;  ///< the files of an animation
  /// Of a tetrahedron: the mode at which the topology of its generalized mode surface changes,
  /// sqrt(1 - mode^2) of the characteristic tensor.
  std::optional<double> bifurcation_mode;
  std::vector<MarkedPoint> marked;
  std::vector<std::filesystem::path> empty;  ///< surfaces without triangles and without lines
  std::vector<std::string> notes;            ///< what is not drawn, and why
  std::vector<std::string> mesh_notes;       ///< of reading the mesh
  std::uintmax_t bytes = 0;                  ///< of all files
  double seconds = 0;
};

/// "1,-2,0.5", not zero. Throws UsageError.
Vector3<double> parse_direction(std::string_view text);

/// "10,-2,0.5". Throws UsageError.
void parse_focus(std::string_view text, View& view);
/// "1600x1200". Throws UsageError.
void parse_size(std::string_view text, View& view);
/// "azimuth,elevation" in degrees. Throws UsageError.
void parse_view(std::string_view text, View& view);

/// Draws on a private display, so none is needed. Throws UsageError, and IoError also where no
/// picture can be drawn.
RenderReport run_render(const RenderCommand& command, const Progress& progress = {});

}  // namespace tensortopo
