// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "orientation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tensortopo::detail {

int orientation(const Vector3<double>& p, const Vector3<double>& q, const Vector3<double>& r,
                const Vector3<double>& s) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  return static_cast<int>(CGAL::orientation(Point(p.x, p.y, p.z), Point(q.x, q.y, q.z),
                                            Point(r.x, r.y, r.z), Point(s.x, s.y, s.z)));
}

}  // namespace tensortopo::detail
