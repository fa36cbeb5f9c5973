// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace tensortopo {

/// Why the level in a tetrahedron was not extracted. Critical values leave a tetrahedron out only
/// where no level next to mu could be meshed for mu + 0 either.
enum class UnresolvedReason {
  zero_deviator_inside,    ///< the deviator vanishes in the tetrahedron, not at a vertex
  level_constant_in_cell,  ///< the mode is mu everywhere in the tetrahedron
  level_constant_on_face,  ///< the mode is mu everywhere on a face
  level_constant_on_edge,  ///< the mode is mu everywhere on an edge
  critical_value_in_cell,  ///< mu is the mode of the one saddle, which is inside
  critical_value_on_face,  ///< +-mu is critical in the plane of a face
  critical_value_on_edge,  ///< mu is critical along an edge: the level touches it
  budget_exhausted,        ///< no proof within the budget, and none of these
  inconsistent_samples,    ///< the proved topology could not be meshed with the samples at hand
};

/// The name that reports use.
std::string_view name_of(UnresolvedReason reason);

}  // namespace tensortopo
