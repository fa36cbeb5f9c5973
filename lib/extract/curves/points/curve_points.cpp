// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/curve_points.hpp"

namespace tensortopo {

std::string_view name_of(CurveObstacle obstacle) {
  switch (obstacle) {
    case CurveObstacle::zero_deviator_vertex:
      return "zero_deviator_vertex";
    case CurveObstacle::dependent_tensors_on_face:
      return "dependent_tensors_on_face";
    case CurveObstacle::degenerate_conic_on_face:
      return "degenerate_conic_on_face";
    case CurveObstacle::coincident_points_on_face:
      return "coincident_points_on_face";
    case CurveObstacle::degenerate_point_on_edge:
      return "degenerate_point_on_edge";
    case CurveObstacle::dependent_tensors_in_cell:
      return "dependent_tensors_in_cell";
    case CurveObstacle::neutral_characteristic:
      return "neutral_characteristic";
    case CurveObstacle::degenerate_on_a_surface:
      return "degenerate_on_a_surface";
    case CurveObstacle::degenerate_throughout:
      return "degenerate_throughout";
    case CurveObstacle::no_deviator_in_cell:
      return "no_deviator_in_cell";
    case CurveObstacle::points_not_told_apart:
      return "points_not_told_apart";
  }
  return "unknown";
}

}  // namespace tensortopo
