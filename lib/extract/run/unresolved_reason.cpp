// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/unresolved_reason.hpp"

namespace tensortopo {

std::string_view name_of(UnresolvedReason reason) {
  switch (reason) {
    case UnresolvedReason::zero_deviator_inside:
      return "zero_deviator_inside";
    case UnresolvedReason::level_constant_in_cell:
      return "level_constant_in_cell";
    case UnresolvedReason::level_constant_on_face:
      return "level_constant_on_face";
    case UnresolvedReason::level_constant_on_edge:
      return "level_constant_on_edge";
    case UnresolvedReason::critical_value_in_cell:
      return "critical_value_in_cell";
    case UnresolvedReason::critical_value_on_face:
      return "critical_value_on_face";
    case UnresolvedReason::critical_value_on_edge:
      return "critical_value_on_edge";
    case UnresolvedReason::budget_exhausted:
      return "budget_exhausted";
    case UnresolvedReason::inconsistent_samples:
      return "inconsistent_samples";
  }
  return "unknown";
}

}  // namespace tensortopo
