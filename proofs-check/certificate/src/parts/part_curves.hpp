// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What of a part is needed to put degenerate curves in parts together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "claims/compare_curves.hpp"
#include "parts/mesh_border.hpp"
#include "parts/whole_numbers.hpp"

namespace certificate {

/// A degenerate point on a face of the border.
struct BorderCurvePoint {
  std::uint32_t face = 0;
  /// Which one of the face's points it is, the same for all parts that have the face. Nothing if
  /// that is not known.
  std::optional<std::size_t> number;
  std::uint32_t vertex = 0;  ///< of the part's polylines
  BorderPlace place{};       ///< of the vertex
};

/// A component of the part's polylines.
struct PartCurve {
  std::size_t vertices = 0, lines = 0;
  SaidNumber said;
};

struct PartCurves : MeshBorder {
  std::vector<BorderCurvePoint> ends;      ///< by face
  std::vector<std::uint32_t> component;    ///< of each vertex of the polylines
  std::vector<std::uint32_t> line_ends;    ///< of each vertex, how many lines end there
  std::vector<PartCurve> components;       ///< in the order of their first lines
  /// The array `whole_component` is there, but not one number of each line.
  bool whole_is_elsewhere = false;
};

/// Adds what the polylines have there, after these were found to be as claimed.
void add_curves(const CurveCase& c, PartCurves& part);

}  // namespace certificate
