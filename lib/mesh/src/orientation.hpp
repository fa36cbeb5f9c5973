// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo::detail {

/// Sign of the volume of the tetrahedron p q r s, exact for finite coordinates of any size.
int orientation(const Vector3<double>& p, const Vector3<double>& q, const Vector3<double>& r,
                const Vector3<double>& s);

}  // namespace tensortopo::detail
