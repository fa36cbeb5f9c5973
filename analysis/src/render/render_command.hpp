// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene.hpp"
#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

/// From surfaces, and the field that they were extracted from, to a picture.
struct RenderCommand {
  std::vector<std::filesystem::path> surfaces;  ///< .vtp
  std::optional<std::filesystem::path> mesh;    ///< the domain: .vtu, .pvtu or legacy .vtk
  std::filesystem::path output;                 ///< .png
  View view;
};

struct RenderReport {
  std::vector<double> modes;
  std::uintmax_t bytes = 0;
  double seconds = 0;
};

/// "1600x1200". Throws UsageError.
void parse_size(std::string_view text, View& view);
/// "azimuth,elevation" in degrees. Throws UsageError.
void parse_view(std::string_view text, View& view);

/// Draws on a private display, so none is needed. Throws UsageError, and IoError also where no
/// picture can be drawn.
RenderReport run_render(const RenderCommand& command, const Progress& progress = {});

}  // namespace tensortopo
