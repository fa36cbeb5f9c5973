// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tensortopo {

/// A file format of surfaces, which `read_surface_file` reads and `write_surface` writes.
struct SurfaceFormat {
  std::string_view extension;  ///< in lower case, with its dot
  std::string_view name;       ///< for people
  std::string_view fuzzed_as;  ///< the target in tests/fuzz
  bool holds_curves = false;   ///< polylines, too
};

/// All formats of surfaces: the one table that readers, writers, messages, help texts and tests
/// take them from.
const std::vector<SurfaceFormat>& surface_formats();

/// The format of a file by its name; null if there is none.
const SurfaceFormat* surface_format_of(const std::filesystem::path& file);

/// ".vtp, .ply or ...", for messages.
/// @param with_curves  only those that hold curves
std::string surface_extensions(bool with_curves = false);

}  // namespace tensortopo
