// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/manifold/manifold_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "extract/level/exact_tensors.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// sigma along an arc, with the medium eigenvector continued from a given one.
template <class Scalar>
class SigmaOnArc {
 public:
  SigmaOnArc(const TetManifold& manifold, const FaceArc<Scalar>& arc,
             const std::array<Deviator<Scalar>, 3>& face, const Level<Scalar>& level,
             const Vector3<double>& start)
      : manifold_(manifold), arc_(arc), face_(face), level_(level), start_(start) {}

  double operator()(double place) const {
    const double pieces = static_cast<double>(arc_.pieces.size());
    if (arc_.closed && place >= pieces) place -= pieces;
    const auto point = point_on_arc(arc_, face_, Scalar(place), level_);
    auto medium = vector_cast<double>(point.medium);
    if (dot(medium, start_) < 0) medium = -medium;
    return manifold_.manifold.sigma(
        medium, vector_cast<double>(dominant_eigenvector(point.tensor, level_)));
  }

 private:
  const TetManifold& manifold_;
  const FaceArc<Scalar>& arc_;
  std::array<Deviator<Scalar>, 3> face_;
  const Level<Scalar>& level_;
  Vector3<double> start_;
};

/// A zero of a function with opposite signs at the ends of an interval (Illinois method).
template <class Function>
double bracketed_zero(const Function& f, double a, double fa, double b, double fb) {
  int side = 0;
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 100 && b - a > rounding * (1 + b); ++i) {
    double m = (fa * b - fb * a) / (fa - fb);
    if (!(m > a && m < b) || i % 8 == 7) m = a + (b - a) / 2;
    const double fm = f(m);
    if (fm == 0) return m;
    if ((fm < 0) == (fa < 0)) {
      a = m, fa = fm;
      if (side == -1) fb /= 2;
      side = -1;
    } else {
      b = m, fb = fm;
      if (side == 1) fa /= 2;
      side = 1;
    }
  }
  return a + (b - a) / 2;
}

/// The least product of the mode's s and the medium eigenvalue of the characteristic tensor: the
/// radius of an oval of the complex domain, which is to have some digits of a double.
constexpr double kLeastOval = 0x1p-31;

/// Up to this radius the oval is taken for a circle, with an error of its square.
constexpr double kSmallOval = 0x1p-27;

/// A manifold that is the one asked for as far as a chart can show, and has ovals: a mode next to 0
/// for mode 0, a medium eigenvalue next to 0 for a characteristic tensor of mode 0.
MediumEigenvectorManifold<double> manifold_with_ovals(CharacteristicTensor<double> characteristic,
                                                      ModeParameter<double> mode) {
  auto& [b1, b2, b3] = characteristic.eigenvalues;
  if (mode.s * b2 < kLeastOval && mode.s < 0x1p-16)
    mode = mode_parameter_from_s(std::max(mode.s, std::min(0x1p-16, kLeastOval / b2)), 1);
  if (mode.s * b2 < kLeastOval) {
    const double more = kLeastOval / mode.s - b2;
    b1 -= more / 2, b2 += more, b3 -= more / 2;
  }
  return {characteristic, mode};
}

}  // namespace

template <class Scalar>
std::unique_ptr<TetManifold> tet_manifold(const TetWithCurves<Scalar>& tet,
                                          const Level<Scalar>& level) {
  const auto exact = detail::exact_tensors(tet.simplex);
  if (exact_rank(exact) < 4) return nullptr;
  TetrahedronField<double> field;
  field.vertex = rounded(tet.simplex.tensors);
  const auto characteristic = characteristic_tensor(field);
  const auto lift = FieldLift<double>::of(field);
  if (!characteristic || !lift) return nullptr;
  auto manifold = manifold_with_ovals(*characteristic, level.parameter);
  const bool small_ovals = manifold.c() < 2 * kSmallOval;
  return std::unique_ptr<TetManifold>(
      new TetManifold{*characteristic, std::move(manifold), *lift, level.sign, small_ovals});
}

template <class Scalar>
bool runs_along_singularity(const TetManifold& manifold, const CellTopology<Scalar>& proved,
                            const FaceArcVertices& vertices) {
  if (!manifold.small_ovals) return false;
  const auto is_singular = [&](const BoundaryVertex& v) {
    for (const auto& s : manifold.manifold.singularities()) {
      const auto across = cross(v.medium, s);
      if (dot(across, across) < 0x1p-24) return true;
    }
    return false;
  };
  for (const auto& loop : proved.loops) {
    const auto boundary = loop_vertices(loop, vertices);
    for (std::size_t i = 0; i < boundary.size(); ++i)
      if (is_singular(boundary[i]) && is_singular(boundary[(i + 1) % boundary.size()])) return true;
  }
  return false;
}

template <class Scalar>
std::vector<SampleRequest<Scalar>> boundary_crossings(const TetManifold& manifold,
                                                      const TetWithCurves<Scalar>& tet,
                                                      const CellTopology<Scalar>& proved,
                                                      const FaceArcVertices& vertices,
                                                      const Level<Scalar>& level) {
  std::vector<SampleRequest<Scalar>> requests;
  for (const auto& loop : proved.loops)
    for (const auto& piece : loop) {
      const auto f = static_cast<std::size_t>(piece.face), a = static_cast<std::size_t>(piece.arc);
      const auto& arc = tet.arcs[f][a];
      const auto& samples = vertices[f][a];
      const std::size_t n = samples.vertices.size(), segments = arc.closed ? n : n - 1;
      Vector3<double> medium = samples.vertices[0].medium;
      double sigma = manifold.manifold.sigma(medium, samples.vertices[0].dominant);
      for (std::size_t i = 0; i < segments; ++i) {
        const auto& next = samples.vertices[(i + 1) % n];
        auto next_medium = next.medium;
        if (dot(next_medium, medium) < 0) next_medium = -next_medium;
        const double next_sigma = manifold.manifold.sigma(next_medium, next.dominant);
        if ((sigma < 0) != (next_sigma < 0)) {
          const double from = samples.places[i];
          const double to = i + 1 < n ? samples.places[i + 1]
                                      : samples.places[0] + static_cast<double>(arc.pieces.size());
          const SigmaOnArc<Scalar> along(manifold, arc, tet.face_tensors(f), level, medium);
          double place = bracketed_zero(along, from, sigma, to, next_sigma);
          const double pieces = static_cast<double>(arc.pieces.size());
          if (arc.closed && place >= pieces) place -= pieces;
          requests.push_back({piece.face, piece.arc, Scalar(place), true});
        }
        medium = next_medium, sigma = next_sigma;
      }
    }
  return requests;
}

template <class Scalar>
std::vector<SampleRequest<Scalar>> denser_loops(const TetWithCurves<Scalar>& tet,
                                                const CellTopology<Scalar>& proved,
                                                FaceArcVertices& vertices,
                                                const Level<Scalar>& level) {
  std::vector<SampleRequest<Scalar>> requests;
  for (const auto& loop : proved.loops)
    for (const auto& piece : loop) {
      const auto f = static_cast<std::size_t>(piece.face), a = static_cast<std::size_t>(piece.arc);
      const auto& arc = tet.arcs[f][a];
      auto& samples = vertices[f][a];
      const std::size_t n = samples.vertices.size(), segments = arc.closed ? n : n - 1;
      const double pieces = static_cast<double>(arc.pieces.size());
      ArcVertices denser;
      std::vector<double> wrapped;
      for (std::size_t i = 0; i < n; ++i) {
        denser.vertices.push_back(samples.vertices[i]);
        denser.places.push_back(samples.places[i]);
        if (i >= segments) continue;
        const double to = i + 1 < n ? samples.places[i + 1] : samples.places[0] + pieces;
        double middle = samples.places[i] + (to - samples.places[i]) / 2;
        const bool wraps = middle >= pieces;
        if (wraps) middle -= pieces;
        requests.push_back({piece.face, piece.arc, Scalar(middle), false});
        const auto point = point_on_arc(arc, tet.face_tensors(f), Scalar(middle), level);
        BoundaryVertex vertex;
        vertex.medium = vector_cast<double>(point.medium);
        vertex.dominant = vector_cast<double>(dominant_eigenvector(point.tensor, level));
        // The samples of a closed arc start at its smallest place.
        const auto at = wraps ? 0 : static_cast<std::ptrdiff_t>(denser.vertices.size());
        denser.vertices.insert(denser.vertices.begin() + at, vertex);
        denser.places.insert(denser.places.begin() + at, middle);
      }
      samples = std::move(denser);
    }
  return requests;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                  \
  template std::unique_ptr<TetManifold> tet_manifold(const TetWithCurves<Scalar>&,      \
                                                     const Level<Scalar>&);             \
  template bool runs_along_singularity(const TetManifold&, const CellTopology<Scalar>&, \
                                       const FaceArcVertices&);                         \
  template std::vector<SampleRequest<Scalar>> boundary_crossings(                       \
      const TetManifold&, const TetWithCurves<Scalar>&, const CellTopology<Scalar>&,    \
      const FaceArcVertices&, const Level<Scalar>&);                                    \
  template std::vector<SampleRequest<Scalar>> denser_loops(                             \
      const TetWithCurves<Scalar>&, const CellTopology<Scalar>&, FaceArcVertices&,      \
      const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
