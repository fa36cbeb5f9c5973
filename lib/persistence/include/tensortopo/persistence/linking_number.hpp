// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// The linking number of two closed polygons, exactly: of the polygons with these vertices, the
/// first one following the last. Whether the curves that they stand for are linked as the polygons
/// are is another question.
///
/// Half the sum of the signs of the crossings in a projection; all signs are exact. Changes sign
/// with the direction of either polygon.
/// @return nothing if the polygons meet, or if no projection of several was in general position
std::optional<int> linking_number(std::span<const Vector3<double>> a,
                                  std::span<const Vector3<double>> b);

}  // namespace tensortopo
