// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "analyze/curvature/level_curvature.hpp"
#include "render/tet/tet_directions.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

const std::array<Vector3<double>, 4> kCorners{{{-4, -3, -2}, {5, -2, -1}, {1, 6, -3}, {0, 1, 7}}};

struct Drawn {
  TetField field;
  ModeValue mode;
  Random random;
};

Drawn drawn() {
  Drawn result{{}, {}, Random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 20)))};
  result.field = {kCorners, result.random.tet_tensors()};
  result.mode = ModeValue::parse("0." + std::to_string(*rc::gen::inRange(1, 100)) + "5");
  return result;
}

Vector3<double> direction(Random& random) {
  return unit(Vector3<double>{random.normal(), random.normal(), random.normal()});
}

// Points at infinity and the boundary of the complex domain have finite neighbourhoods in which
// the lift loses digits.
bool well_placed(const TetField& field, const Vector3<double>& point) {
  const auto w = field.weights(point);
  return std::max(std::abs(*std::max_element(w.begin(), w.end())),
                  std::abs(*std::min_element(w.begin(), w.end()))) < 1e3;
}

RC_GTEST_PROP(TetDirections, PlacesHaveTheModeAndTheMediumEigenvector, ()) {
  Drawn d = drawn();
  const TetDirections directions(d.field, d.mode);
  for (int i = 0; i < 20; ++i) {
    const Vector3<double> v = direction(d.random);
    const DirectionKind kind = directions.kind(v);
    RC_ASSERT(kind == directions.kind(-v));
    int positive = 0, points = 0;
    bool sure = true;
    for (const double sign : {1.0, -1.0}) {
      const auto place = directions.place(sign * v);
      RC_ASSERT(place.has_value() == (kind != DirectionKind::complex_domain));
      if (!place) continue;
      sure = sure && well_placed(d.field, *place);
      if (!sure) break;
      const SymmetricTensor<double> t = d.field.at(*place);
      const double m = mode(deviator(t));
      RC_ASSERT(std::abs(std::abs(m) - d.mode.approx()) < 1e-6);
      const auto system = eigen_decomposition(t);
      RC_ASSERT(std::abs(dot(system.vectors[1], v)) > 1 - 1e-6);
      ++points;
      if (m > 0) ++positive;
      // Inside by the weights, and by the place.
      const auto w = d.field.weights(*place);
      const double least = *std::min_element(w.begin(), w.end());
      if (std::abs(least) > 1e-9)
        RC_ASSERT(directions.sign_inside(sign * v) == (least > 0 ? (m > 0 ? 1 : -1) : 0));
    }
    if (!sure || points < 2) continue;
    RC_ASSERT(kind == (positive == 2   ? DirectionKind::positive
                       : positive == 0 ? DirectionKind::negative
                                       : DirectionKind::mixed));
  }
}

RC_GTEST_PROP(TetDirections, MediumEigenvectorTurnsAsItsDerivativeSays, ()) {
  Drawn d = drawn();
  const Vector3<double> point{d.random.uniform(), d.random.uniform(), d.random.uniform()};
  const auto [values, vectors] = eigen_decomposition(d.field.at(point));
  const double gap = std::min(values[0] - values[1], values[1] - values[2]);
  RC_PRE(gap > 0.1);
  const Vector3<double> step = direction(d.random);
  const double h = 1e-5;
  const auto near = [&](double k) {
    const Vector3<double> v = eigen_decomposition(d.field.at(point + (k * h) * step)).vectors[1];
    return dot(v, vectors[1]) < 0 ? -v : v;
  };
  const Vector3<double> difference = (1 / (2 * h)) * (near(1) - near(-1));
  const Vector3<double> off = difference - medium_eigenvector_derivative(d.field, point, step);
  RC_ASSERT(std::sqrt(dot(off, off)) < 1e-5 / (gap * gap * gap));
}

// The line at v is the principal direction at v's point, carried to the sphere: walking along it in
// space moves the medium eigenvector along the line.
RC_GTEST_PROP(TetDirections, LinesAreTangentAndFollowThePrincipalDirections, ()) {
  Drawn d = drawn();
  const TetDirections directions(d.field, d.mode);
  const Vector3<double> v = direction(d.random);
  const auto place = directions.place(v);
  RC_PRE(place && well_placed(d.field, *place) &&
         directions.manifold().boundary_function(v) > 1e-2);
  const auto curvature = level_curvature(d.field.corners, d.field.tensors, *place);
  RC_PRE(curvature.has_value());
  for (const Texture texture : {Texture::major, Texture::minor, Texture::dominant}) {
    const Vector3<double> line = directions.line(v, texture);
    RC_ASSERT(std::abs(dot(line, line) - 1) < 1e-9);
    RC_ASSERT(std::abs(dot(line, v)) < 1e-9);
    if (texture == Texture::dominant) continue;
    const Vector3<double> along = curvature->directions[texture == Texture::major ? 0 : 1];
    const Vector3<double> turn = medium_eigenvector_derivative(d.field, *place, along);
    const double h = 1e-5 / std::sqrt(dot(turn, turn));
    const auto near = [&](double k) {
      const Vector3<double> e =
          eigen_decomposition(d.field.at(*place + (k * h) * along)).vectors[1];
      return dot(e, v) < 0 ? -e : e;
    };
    RC_ASSERT(std::abs(dot(unit(near(1) - near(-1)), line)) > 1 - 1e-4);
  }
}

TEST(TetDirections, RefusesDependentDeviators) {
  TetField field{kCorners, {}};
  field.tensors[0] = {1, 0, 0, 0, 0, 0};
  field.tensors[1] = {0, 1, 0, 0, 0, 0};
  field.tensors[2] = {0, 0, 1, 0, 0, 0};
  field.tensors[3] = {0, 0, 0, 1, 0, 0};
  EXPECT_THROW(TetDirections(field, ModeValue::parse("1/2")), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
