// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "baselines/triangle_soup.hpp"

namespace tensortopo::baselines {

/// The neutral points of the linear field between two places, strictly between them, as places:
/// the same bits whichever way the two are given. Roots of a cubic in doubles, none of them proved.
std::vector<Vector3<double>> neutral_points(const FieldPoint& p, const FieldPoint& q);

}  // namespace tensortopo::baselines
