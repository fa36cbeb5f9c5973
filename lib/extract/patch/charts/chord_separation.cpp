// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/chord_separation.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "extract/patch/manifold/manifold_chart.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

using Point = std::array<double, 2>;

/// A step along a boundary loop from one sample to the next, and its chord in the chart.
struct Step {
  int face, arc;
  double from, to;       ///< places; `to` may be a full turn later on a closed arc
  Vector3<double> v, w;  ///< canonical medium eigenvectors at its ends
  Point p, q;
};

double turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Chords that have no end in common and cross. A guide for samples only: the triangulation that
/// follows decides exactly.
bool cross_each_other(const Step& s, const Step& t) {
  if (s.p == t.p || s.p == t.q || s.q == t.p || s.q == t.q) return false;
  for (std::size_t k = 0; k < 2; ++k)
    if (std::max(s.p[k], s.q[k]) < std::min(t.p[k], t.q[k]) ||
        std::max(t.p[k], t.q[k]) < std::min(s.p[k], s.q[k]))
      return false;
  return (turn(s.p, s.q, t.p) > 0) != (turn(s.p, s.q, t.q) > 0) &&
         (turn(t.p, t.q, s.p) > 0) != (turn(t.p, t.q, s.q) > 0);
}

/// How often a step is halved, and the number of steps at which it is given up: pairs are compared.
constexpr int kChordRounds = 6;
constexpr std::size_t kMostSteps = 600;

template <class Scalar>
class Separation {
 public:
  Separation(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
             const Level<Scalar>& level)
      : on_(manifold), chart_(manifold.manifold), tet_(tet), level_(level) {}

  void add_arc(const BoundaryArc& piece, const ArcVertices& samples,
               std::span<const SampleRequest<Scalar>> crossings) {
    struct Sample {
      double place;
      Vector3<double> medium;
      std::optional<BoundaryPosition<double>> boundary;
    };
    std::vector<Sample> list;
    for (std::size_t i = 0; i < samples.vertices.size(); ++i) {
      const auto& v = samples.vertices[i];
      const bool canonical = on_.manifold.sigma(v.medium, v.dominant) <= 0;
      list.push_back({samples.places[i], canonical ? v.medium : -v.medium, {}});
    }
    const auto& arc = arc_of(piece.face, piece.arc);
    for (const auto& c : crossings)
      if (c.face == piece.face && c.arc == piece.arc) {
        const auto point = point_on_arc(arc, face_of(piece.face), c.place, level_);
        const auto dominant = vector_cast<double>(dominant_eigenvector(point.tensor, level_));
        const auto at = on_.boundary_position(vector_cast<double>(point.medium), dominant);
        list.push_back({static_cast<double>(c.place),
                        at.sign * on_.manifold.boundary_point(at.loop, at.phi), at});
      }
    std::sort(list.begin(), list.end(),
              [](const Sample& a, const Sample& b) { return a.place < b.place; });
    const std::size_t n = list.size(), count = arc.closed ? n : n - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const auto &a = list[i], &b = list[(i + 1) % n];
      Step step{piece.face, piece.arc, a.place, b.place, a.medium, b.medium, {}, {}};
      if (i + 1 == n) step.to += static_cast<double>(arc.pieces.size());
      // A crossing of the complex domain's boundary is seen from the side of the other end.
      const auto place = [&](const Sample& sample, Vector3<double>& v,
                             const Vector3<double>& other) {
        if (!sample.boundary) return chart_(v);
        auto at = *sample.boundary;
        if (dot(v, other) < 0) v = -v, at.sign = -at.sign;
        return chart_.at_boundary(at);
      };
      step.p = place(a, step.v, step.w), step.q = place(b, step.w, step.v);
      if (a.boundary && b.boundary)
        halve(step);  // only a sample between them tells on which side the curve runs
      else
        steps_.push_back(step);
    }
  }

  std::vector<SampleRequest<Scalar>> separate() {
    for (int round = 0; round < kChordRounds && steps_.size() <= kMostSteps; ++round) {
      std::vector<char> crossed(steps_.size(), 0);
      for (std::size_t i = 0; i < steps_.size(); ++i)
        for (std::size_t j = i + 1; j < steps_.size(); ++j)
          if (cross_each_other(steps_[i], steps_[j])) crossed[i] = crossed[j] = 1;
      auto last = std::move(steps_);
      steps_.clear();
      bool any = false;
      for (std::size_t i = 0; i < last.size(); ++i) {
        any |= crossed[i] != 0;
        if (crossed[i])
          halve(last[i]);
        else
          steps_.push_back(last[i]);
      }
      if (!any) break;
    }
    return std::move(requests_);
  }

 private:
  const FaceArc<Scalar>& arc_of(int face, int arc) const {
    return tet_.arcs[static_cast<std::size_t>(face)][static_cast<std::size_t>(arc)];
  }

  std::array<Deviator<Scalar>, 3> face_of(int face) const {
    return tet_.face_tensors(static_cast<std::size_t>(face));
  }

  void halve(const Step& step) {
    const auto& arc = arc_of(step.face, step.arc);
    const double middle = step.from + (step.to - step.from) / 2;
    const double turns = static_cast<double>(arc.pieces.size());
    const Scalar place(arc.closed && middle >= turns ? middle - turns : middle);
    const auto point = point_on_arc(arc, face_of(step.face), place, level_);
    requests_.push_back({step.face, step.arc, place, false});
    auto medium = vector_cast<double>(point.medium);
    const double sigma =
        on_.manifold.sigma(medium, vector_cast<double>(dominant_eigenvector(point.tensor, level_)));
    if (sigma > 0) medium = -medium;
    const Point at = chart_(medium);
    steps_.push_back({step.face, step.arc, step.from, middle, step.v, medium, step.p, at});
    steps_.push_back({step.face, step.arc, middle, step.to, medium, step.w, at, step.q});
  }

  const TetManifold& on_;
  ManifoldChart chart_;
  const TetWithCurves<Scalar>& tet_;
  const Level<Scalar>& level_;
  std::vector<Step> steps_;
  std::vector<SampleRequest<Scalar>> requests_;
};

}  // namespace

template <class Scalar>
std::vector<SampleRequest<Scalar>> separating_samples(
    const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
    const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
    std::span<const SampleRequest<Scalar>> crossings, const Level<Scalar>& level) {
  Separation<Scalar> separation(manifold, tet, level);
  for (const auto& loop : proved.loops)
    for (const auto& piece : loop)
      separation.add_arc(
          piece,
          vertices[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)],
          crossings);
  return separation.separate();
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                               \
  template std::vector<SampleRequest<Scalar>> separating_samples(                    \
      const TetManifold&, const TetWithCurves<Scalar>&, const CellTopology<Scalar>&, \
      const FaceArcVertices&, std::span<const SampleRequest<Scalar>>, const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
