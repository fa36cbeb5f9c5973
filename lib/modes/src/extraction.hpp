// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// All that this folder uses of the extractor, under the names that it has there.
#include <string>
#include <utility>
#include <vector>

#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/certify/extract_within.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/improve_triangles.hpp"
#include "tensortopo/extract/prepared_field.hpp"

namespace tensortopo {

using Counts = std::vector<std::pair<std::string, double>>;

/// Numbers of an extraction that people ask for, with the names that reports use.
inline Counts counted(const ExtractStatistics& s) {
  return {{"tets_screened_out", static_cast<double>(s.tets_screened_out)},
          {"tets_crossed", static_cast<double>(s.tets_crossed)},
          {"tets_refined", static_cast<double>(s.tets_refined)},
          {"tets_undefined", static_cast<double>(s.tets_undefined)},
          {"vertices_on_level", static_cast<double>(s.vertices_on_level)},
          {"zero_deviator_vertices", static_cast<double>(s.zero_deviator_vertices)},
          {"seconds_edges", s.seconds_edges},
          {"seconds_faces", s.seconds_faces},
          {"seconds_tets", s.seconds_tets},
          {"seconds_stitch", s.seconds_stitch}};
}

inline Counts counted(const CurveStatistics& s) {
  return {{"tets_screened_out", static_cast<double>(s.tets_screened_out)},
          {"tets_crossed", static_cast<double>(s.tets_crossed)},
          {"faces", static_cast<double>(s.faces)},
          {"face_points", static_cast<double>(s.face_points)},
          {"seconds_faces", s.seconds_faces},
          {"seconds_tets", s.seconds_tets},
          {"seconds_stitch", s.seconds_stitch}};
}

}  // namespace tensortopo
