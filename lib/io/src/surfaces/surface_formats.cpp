// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/surface_formats.hpp"

#include <algorithm>

#include "surfaces/read_formats.hpp"
#include "surfaces/surface_format.hpp"
#include "surfaces/write_formats.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {
namespace {

const std::vector<detail::SurfaceFormatEntry>& entries() {
  static const std::vector<detail::SurfaceFormatEntry> table{
      {{.extension = ".vtp", .name = "VTK XML polygons", .fuzzed_as = "vtp", .holds_curves = true},
       nullptr,
       nullptr},
      {{.extension = ".ply", .name = "PLY", .fuzzed_as = "ply", .holds_curves = true},
       detail::read_ply,
       detail::to_ply},
      {{.extension = ".obj", .name = "Wavefront OBJ", .fuzzed_as = "obj", .holds_curves = true},
       detail::read_obj,
       detail::to_obj},
      {{.extension = ".off", .name = "OFF", .fuzzed_as = "off"},
       detail::read_off,
       [](const SurfaceMesh& surface, const CurveMesh&) { return detail::to_off(surface); }},
      {{.extension = ".stl", .name = "STL", .fuzzed_as = "stl"},
       detail::read_stl,
       [](const SurfaceMesh& surface, const CurveMesh&) { return detail::to_stl(surface); }}};
  return table;
}

}  // namespace

const detail::SurfaceFormatEntry* detail::surface_entry_of(const std::filesystem::path& file) {
  const auto entry = std::find_if(entries().begin(), entries().end(),
                                  [extension = lower_extension(file)](const auto& e) {
                                    return e.format.extension == extension;
                                  });
  return entry != entries().end() ? &*entry : nullptr;
}

const std::vector<SurfaceFormat>& surface_formats() {
  static const std::vector<SurfaceFormat> formats = [] {
    std::vector<SurfaceFormat> list;
    for (const auto& entry : entries()) list.push_back(entry.format);
    return list;
  }();
  return formats;
}

const SurfaceFormat* surface_format_of(const std::filesystem::path& file) {
  const auto* const entry = detail::surface_entry_of(file);
  return entry != nullptr ? &entry->format : nullptr;
}

std::string surface_extensions(bool with_curves) {
  std::vector<std::string_view> names;
  for (const SurfaceFormat& format : surface_formats())
    if (format.holds_curves || !with_curves) names.push_back(format.extension);
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list.append(i == 0 ? "" : i + 1 < names.size() ? ", " : " or ").append(names[i]);
  return list;
}

}  // namespace tensortopo
