// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surfaces/write_formats.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo::detail {
namespace {

/// Appends a number's bytes, lowest first.
template <class Number>
void append(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

float to_float(double x) {
  if (!(std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max())))
    throw std::range_error("a coordinate is too large for STL, whose numbers are float32");
  return static_cast<float>(x);
}

void append_float3(std::string& bytes, const Vector3<double>& v) {
  for (const double x : {v.x, v.y, v.z}) append(bytes, to_float(x));
}

/// Unit normal of a triangle; zero if it has none.
Vector3<double> unit_normal(const Vector3<double>& p, const Vector3<double>& q,
                            const Vector3<double>& r) {
  const Vector3<double> n = cross(q - p, r - p);
  const double length = elementary::hypot(n.x, n.y, n.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {n.x / length, n.y / length, n.z / length};
}

/// The level that each vertex belongs to, of the surface and then of curves.
struct Levels {
  std::string name;  ///< "mode" or "value"; empty if vertices have none
  std::vector<double> values;
};

Levels levels_of(const SurfaceMesh& surface, const CurveMesh& curves) {
  const bool are_modes =
      surface.mode.size() == surface.points.size() && curves.mode.size() == curves.points.size();
  if (are_modes) {
    Levels levels{"mode", surface.mode};
    levels.values.insert(levels.values.end(), curves.mode.begin(), curves.mode.end());
    return levels;
  }
  if (surface.value.size() == surface.points.size() && curves.points.empty())
    return {"value", surface.value};
  return {};
}

}  // namespace

std::string to_ply(const SurfaceMesh& surface, const CurveMesh& curves) {
  std::size_t segments = 0;
  for (const auto& line : curves.lines) segments += line.size() - 1;
  const std::size_t points = surface.points.size() + curves.points.size();
  const Levels levels = levels_of(surface, curves);
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double "
      "y\n"
      "property double z\n{}element face {}\nproperty list uchar int vertex_indices\n",
      points, levels.name.empty() ? "" : "property double " + levels.name + "\n",
      surface.triangles.size());
  if (segments > 0)
    bytes += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", segments);
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + 32 * points + 13 * surface.triangles.size() + 8 * segments);
  std::size_t vertex = 0;
  for (const auto* list : {&surface.points, &curves.points})
    for (const auto& p : *list) {
      for (const double x : {p.x, p.y, p.z}) append(bytes, x);
      if (!levels.name.empty()) append(bytes, levels.values[vertex++]);
    }
  for (const auto& t : surface.triangles) {
    append(bytes, std::uint8_t{3});
    for (const auto v : t) append(bytes, v);
  }
  const auto first = static_cast<CurveMesh::Index>(surface.points.size());
  for (const auto& line : curves.lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      append(bytes, first + line[i]);
      append(bytes, first + line[i + 1]);
    }
  return bytes;
}

std::string to_obj(const SurfaceMesh& surface, const CurveMesh& curves) {
  std::string text;
  for (const auto* list : {&surface.points, &curves.points})
    for (const auto& p : *list) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const auto& t : surface.triangles)
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  const auto first = static_cast<CurveMesh::Index>(surface.points.size()) + 1;
  for (const auto& line : curves.lines) {
    text += 'l';
    for (const auto v : line) text += fmt::format(" {}", first + v);
    text += '\n';
  }
  return text;
}

std::string to_off(const SurfaceMesh& surface) {
  std::string text = fmt::format("OFF\n{} {} 0\n", surface.points.size(), surface.triangles.size());
  for (const auto& p : surface.points) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
  for (const auto& t : surface.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

std::string to_stl(const SurfaceMesh& surface) {
  if (surface.triangles.size() > UINT32_MAX) throw std::range_error("too many triangles for STL");
  std::string bytes = "binary STL by tensortopo";
  bytes.resize(80, ' ');
  bytes.reserve(84 + 50 * surface.triangles.size());
  append(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& t : surface.triangles) {
    const auto point = [&](std::size_t i) -> const Vector3<double>& {
      return surface.points[static_cast<std::size_t>(t[i])];
    };
    append_float3(bytes, unit_normal(point(0), point(1), point(2)));
    for (std::size_t i = 0; i < 3; ++i) append_float3(bytes, point(i));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace tensortopo::detail
