// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/edge_roots.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo::baselines {

namespace {

/// Of a function that changes sign between a and b, once.
template <class Function>
double bisect(const Function& f, double a, double b) {
  const bool rises = f(b) > 0;
  for (int i = 0; i < 60; ++i) {
    const double m = 0.5 * (a + b);
    ((f(m) > 0) == rises ? b : a) = m;
  }
  return 0.5 * (a + b);
}

}  // namespace

std::vector<Vector3<double>> neutral_points(const FieldPoint& p, const FieldPoint& q) {
  if (comes_first(q.position, p.position)) return neutral_points(q, p);
  const auto d = q.tensor - p.tensor;
  const auto at = [&](double t) { return determinant_form(p.tensor + t * d); };
  // c0 + c1 t + c2 t^2 + c3 t^3 through four values, of which c3 is the determinant of d.
  const double c0 = at(0), c3 = determinant_form(d), up = at(1) - c0 - c3, down = at(-1) - c0 + c3;
  const double c1 = (up - down) / 2, c2 = (up + down) / 2;
  const auto f = [&](double t) { return c0 + t * (c1 + t * (c2 + t * c3)); };
  std::vector<double> ends{0};
  const double disc = c2 * c2 - 3 * c3 * c1;
  if (disc > 0) {
    const double s = -(c2 + std::copysign(std::sqrt(disc), c2));
    for (const double t : {s / (3 * c3), c1 / s})
      if (t > 0 && t < 1) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
  }
  ends.push_back(1);
  std::vector<Vector3<double>> places;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if ((f(ends[i]) > 0) != (f(ends[i + 1]) > 0)) {
      const double t = bisect(f, ends[i], ends[i + 1]);
      places.push_back(p.position + t * (q.position - p.position));
    }
  return places;
}

}  // namespace tensortopo::baselines
