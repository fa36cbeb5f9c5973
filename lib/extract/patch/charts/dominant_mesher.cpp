// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/dominant_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/patch/charts/chart_mesher.hpp"
#include "extract/patch/charts/dominant_chart.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/degenerate_offset.hpp"

namespace tensortopo {

namespace {

/// From one sample of a boundary loop to the next neither angle of the chart may change by more:
/// the shorter way would be a guess.
constexpr double kLongestStep = 2.5;

/// Places looked at to see whether a sheet is between boundary loops.
constexpr int kProbes = 8;

template <class Scalar>
class DominantMesher : ChartMesher<Scalar> {
  using Base = ChartMesher<Scalar>;
  using Base::add_image, Base::emit, Base::raise_flat_triangles, Base::split_diagonals,
      Base::triangulate;
  using Base::images_, Base::inner_, Base::boundaries_, Base::level_, Base::segments_;
  using Place = DominantChart::Place;

 public:
  DominantMesher(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                 const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
                 const Level<Scalar>& level, const Sampling& sampling, int defect_rounds,
                 DominantChart::About about, Patch<Scalar>& out)
      : Base(manifold, tet, proved, vertices, level, defect_rounds, out),
        chart_(manifold.characteristic, level.parameter, about),
        turn_(sampling.largest_turn()) {}

  bool mesh() {
    return cut_open() && lay_out() && add_loops() && triangulate() && split_diagonals() &&
           raise_flat_triangles() && emit();
  }

 private:
  /// The middle of the widest gap between angles, once around, that `is_free` for sheets.
  template <class IsFree>
  static std::optional<double> widest_gap(std::vector<double> angles, double period,
                                          const IsFree& is_free) {
    std::sort(angles.begin(), angles.end());
    double widest = 0;
    std::optional<double> best;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double gap =
          i + 1 < angles.size() ? angles[i + 1] - angles[i] : angles[0] + period - angles[i];
      const double middle = angles[i] + gap / 2;
      if (gap <= widest || !is_free(middle)) continue;
      widest = gap;
      best = middle;
    }
    return best;
  }

  bool is_reached(const Place& place) const {
    const auto tensor = chart_.tensor(place);
    return tensor && inner_.is_inside(*tensor);
  }

  /// Around the cone there is a part that no sheet reaches, since no arc of the degenerate curve
  /// closes in a tetrahedron.
  bool cut_open() {
    std::vector<double> around;
    for (const auto& boundary : boundaries_)
      for (const auto& v : boundary) around.push_back(chart_.place(v.dominant, v.medium).around);
    const auto cut = widest_gap(around, chart_.period(), [&](double middle) {
      for (int k = 0; k < kProbes; ++k)
        if (is_reached({middle, 2 * std::numbers::pi * (k + 0.3) / kProbes})) return false;
      return true;
    });
    if (cut) chart_.cut_at(*cut);
    return cut.has_value();
  }

  bool lay_out() {
    std::vector<double> turns;
    least_ = 4 * std::numbers::pi, most_ = -4 * std::numbers::pi;
    for (const auto& boundary : boundaries_) {
      places_.emplace_back();
      for (const auto& v : boundary) {
        const auto place = chart_.place(v.dominant, v.medium);
        least_ = std::min(least_, place.around), most_ = std::max(most_, place.around);
        turns.push_back(place.turn);
        places_.back().push_back(place);
      }
    }
    if (!(most_ > least_)) return false;
    const auto cut = widest_gap(turns, 2 * std::numbers::pi, [&](double turn) {
      for (int k = 0; k < kProbes; ++k)
        if (is_reached({least_ + (most_ - least_) * (k + 0.5) / kProbes, turn})) return false;
      return true;
    });
    make_rows();
    // Rows that are as far apart as turns by the same angle are.
    const double height = 2 * (most_ - least_) / static_cast<double>(count_of_rows());
    chart_.lay_out(rows_, height, cut);
    return true;
  }

  std::size_t count_of_rows() const {
    return static_cast<std::size_t>(std::ceil((most_ - least_) / turn_));
  }

  /// Rows along which eigenvectors turn no more than they should, and chords do not sag.
  void make_rows() {
    const std::size_t count = count_of_rows();
    rows_.push_back(least_);
    for (std::size_t i = 0; i < count; ++i) {
      const double from = rows_.back(), to = least_ + (most_ - least_) *
                                                          static_cast<double>(i + 1) /
                                                          static_cast<double>(count);
      const int halvings = is_near_degenerate(level_) ? halvings_between(from, to) : 0;
      const int parts = 1 << halvings;
      for (int k = 1; k <= parts; ++k) rows_.push_back(from + (to - from) * k / parts);
    }
  }

  /// How often a row is to be halved so that chords along it do not sag; each halving leaves a
  /// quarter. None if it would be too often.
  int halvings_between(double from, double to) const {
    for (int k = 0; k < kProbes; ++k) {
      const double turn = 2 * std::numbers::pi * (k + 0.3) / kProbes;
      const auto first = chart_.tensor({from, turn}), last = chart_.tensor({to, turn});
      if (!first || !last) continue;
      return detail::sag_halvings(detail::sag_of_chord(deviator(*first), deviator(*last), 1));
    }
    return 0;
  }

  std::size_t add_place(std::int32_t corner, std::uint8_t faces, const Place& place) {
    const auto point = chart_.point(place);
    return add_image(corner, faces, {point[0], point[1], 1}, point);
  }

  bool add_loops() {
    for (std::size_t r = 0; r < boundaries_.size(); ++r) {
      const auto& boundary = boundaries_[r];
      const std::size_t first = images_.size(), n = boundary.size();
      for (std::size_t i = 0; i < n; ++i)
        add_place(boundary[i].id, boundary[i].faces, places_[r][i]);
      for (std::size_t i = 0; i < n; ++i) {
        const auto &p = places_[r][i], &q = places_[r][(i + 1) % n];
        if (std::abs(q.around - p.around) > kLongestStep ||
            std::abs(std::remainder(q.turn - p.turn, 2 * std::numbers::pi)) > kLongestStep)
          return false;
        segments_.push_back({first + i, first + (i + 1) % n});
      }
    }
    return true;
  }

  std::vector<ChartTriangulation::Point> grid_samples(
      const ChartTriangulation::Clearance& clearance) override {
    const int turns = std::max(4, static_cast<int>(std::ceil(std::numbers::pi / turn_)));
    std::vector<ChartTriangulation::Point> samples;
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i)
      for (int k = 0; k < turns; ++k) {
        const Place place{(rows_[i] + rows_[i + 1]) / 2,
                          2 * std::numbers::pi * (k + (i % 2 == 0 ? 0.25 : 0.75)) / turns};
        const auto point = chart_.point(place);
        if (!(clearance(point) > 0.5 * chart_.length_of(turn_, point))) continue;
        if (add_inner_place(place)) samples.push_back(point);
      }
    return samples;
  }

  std::optional<std::size_t> add_inner_place(const Place& place) {
    const auto tensor = chart_.tensor(place);
    if (!tensor) return std::nullopt;
    const auto vertex = inner_.at(*tensor);
    if (!vertex) return std::nullopt;
    return add_place(inner_.add(*vertex), 0, place);
  }

  /// Images are points of the plane, in homogeneous coordinates.
  std::optional<std::size_t> add_inner_image(const Vector3<double>& along) override {
    return add_inner_place(chart_.place_at({along.x / along.z, along.y / along.z}));
  }

  DominantChart chart_;
  double turn_;
  std::vector<std::vector<Place>> places_;  ///< of the boundary loops
  double least_ = 0, most_ = 0;             ///< of these, around the axis
  std::vector<double> rows_;                ///< between these
};

}  // namespace

template <class Scalar>
bool mesh_by_dominant(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                      const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
                      const Level<Scalar>& level, const Sampling& sampling, int defect_rounds,
                      Patch<Scalar>& out) {
  using About = DominantChart::About;
  for (const auto about : {About::cone, About::first_plane, About::second_plane}) {
    Patch<Scalar> patch;
    DominantMesher<Scalar> meshing(manifold, tet, proved, vertices, level, sampling, defect_rounds,
                                   about, patch);
    if (!meshing.mesh()) continue;
    out = std::move(patch);
    return true;
  }
  return false;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                \
  template bool mesh_by_dominant(const TetManifold&, const TetWithCurves<Scalar>&,    \
                                 const CellTopology<Scalar>&, const FaceArcVertices&, \
                                 const Level<Scalar>&, const Sampling&, int, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
