// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/point_boxes.hpp"

#include <algorithm>

#include "certificate_check/check_certificate.hpp"

namespace certificate {

PointBox::PointBox(const Json& claim) : vertex(claim[0]), k(claim[3]) {
  constexpr Number kLongest = 60;
  for (std::size_t n = 0; n < 2; ++n) at[n] = claim[n + 1].get<Number>();
  if (k > kLongest || at[0] > Number{1} << k || at[1] > Number{1} << k)
    throw Malformed("", "no box " + claim.dump());
}

Answer holds(const CurveCase& c, const PointBox& box, const std::array<Vertex, 3>& face,
             const std::array<std::size_t, 3>& corner, FacePoint point) {
  // Weights refer to multiples of the tensors: those of the tensors are in this proportion.
  std::array<mpz_class, 3> scale;
  long largest = c.field.exponent(face[0]);
  for (const Vertex v : face) largest = std::max(largest, c.field.exponent(v));
  for (std::size_t n = 0; n < 3; ++n)
    scale[n] =
        mpz_class(1) << static_cast<unsigned long>(largest - c.field.exponent(face[n]));
  constexpr int kMostCuts = 40;
  for (int cut = 0; cut < kMostCuts; ++cut, point.sharpen()) {
    bool inside = true, outside = false;
    for (const std::size_t n : {0U, 1U})
      for (const int end : {-1, 1}) {
        std::array<mpz_class, 5> form;
        for (std::size_t i = 0; i < 5; ++i) {
          std::array<mpz_class, 3> w;
          for (std::size_t l = 0; l < 3; ++l) w[l] = scale[l] * point.weight(corner[l], i);
          form[i] = end * ((box.middle(n) + end) * (w[0] + w[1] + w[2]) - box.one() * w[n + 1]);
        }
        inside = inside && common_sign(form) > 0;
        outside = outside || common_sign(form) < 0;
      }
    if (outside) return Answer::no;
    if (inside) return Answer::yes;
  }
  return Answer::unsure;
}

std::optional<std::vector<std::size_t>> point_numbers(const CurveCase& c, const CurveFace& face,
                                                      const Json& claim) {
  const std::size_t count = face.level.points.size();
  if (count == 1) return std::vector<std::size_t>{0};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return c.input.points[face.vertices[i]] < c.input.points[face.vertices[j]];
  });
  std::array<Corner, 3> corners;
  std::array<std::size_t, 3> corner{};
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = c.field.corner(face.vertices[order[i]], false);
    corner[order[i]] = i;
  }
  const FacePoints derived = points_in_face(corners, kind_of(c.claims["mode"]));
  if (!derived.decided || derived.points.size() != count) return std::nullopt;
  std::vector<std::size_t> numbers;
  for (std::size_t n = 3; n < claim.size(); ++n) {
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < count; ++i) {
      const Answer answer = holds(c, PointBox(claim[n]), face.vertices, corner, derived.points[i]);
      if (answer == Answer::unsure) return std::nullopt;
      if (answer == Answer::yes) inside.push_back(i);
    }
    if (inside.size() != 1) return std::nullopt;
    numbers.push_back(inside[0]);
  }
  return numbers;
}

}  // namespace certificate
