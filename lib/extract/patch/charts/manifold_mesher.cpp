// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/manifold_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "extract/patch/charts/chart_grid.hpp"
#include "extract/patch/charts/chart_mesher.hpp"
#include "extract/patch/charts/chart_triangulation.hpp"
#include "extract/patch/manifold/manifold_chart.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// Meshes the sheets of one tetrahedron on its medium eigenvector manifold.
template <class Scalar>
class ManifoldMesher : ChartMesher<Scalar> {
  using Base = ChartMesher<Scalar>;
  using Base::add_image, Base::emit, Base::raise_flat_triangles, Base::split_diagonals,
      Base::triangulate;
  using Base::images_, Base::inner_, Base::boundaries_, Base::segments_;

 public:
  ManifoldMesher(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                 const CellTopology<Scalar>& proved,
                 std::span<const SampleRequest<Scalar>> requests, const FaceArcVertices& vertices,
                 const Level<Scalar>& level, const Sampling& sampling, int defect_rounds,
                 Patch<Scalar>& out)
      : Base(manifold, tet, proved, vertices, level, defect_rounds, out),
        on_(manifold),
        chart_(manifold.manifold),
        turn_(sampling.largest_turn()) {
    for (const auto& crossing : requests) {
      if (!crossing.on_boundary) continue;
      const auto f = static_cast<std::size_t>(crossing.face);
      const auto& arc = vertices[f][static_cast<std::size_t>(crossing.arc)];
      std::size_t best = 0;
      for (std::size_t i = 1; i < arc.places.size(); ++i)
        if (std::abs(arc.places[i] - static_cast<double>(crossing.place)) <
            std::abs(arc.places[best] - static_cast<double>(crossing.place)))
          best = i;
      on_boundary_.insert(arc.vertices[best].id);
    }
  }

  bool mesh() {
    return add_loops() && add_boundary_curves() && triangulate() && split_diagonals() &&
           raise_flat_triangles() && emit();
  }

 private:
  /// A vertex of a boundary loop on the complex domain's boundary.
  struct Crossing {
    int loop;
    double phi;
    std::array<std::size_t, 2> images;  ///< of boundary_point(loop, phi) and its antipode
  };

  // Images stand for canonical medium eigenvectors. A vertex on the complex domain's boundary has
  // two, v and -v.
  std::size_t add_image(std::int32_t corner, std::uint8_t faces, const Vector3<double>& v) {
    return add_image(corner, faces, v, chart_(v));
  }

  /// Both images of a point of the complex domain's boundary: that of its parameter first.
  std::array<std::size_t, 2> add_boundary_images(std::int32_t corner, std::uint8_t faces, int loop,
                                                 double phi) {
    const auto v = on_.manifold.boundary_point(loop, phi);
    return {add_image(corner, faces, v, chart_.at_boundary({loop, phi, 1})),
            add_image(corner, faces, -v, chart_.at_boundary({loop, phi, -1}))};
  }

  /// The image of a boundary vertex on the side of `towards`.
  /// (`towards` by value: adding an image may move the images that it comes from.)
  std::size_t boundary_image(const BoundaryVertex& vertex, Vector3<double> towards) {
    auto found = crossings_.find(vertex.id);
    if (found == crossings_.end()) {
      const auto at = on_.boundary_position(vertex.medium, vertex.dominant);
      found = crossings_
                  .emplace(vertex.id,
                           Crossing{at.loop, at.phi,
                                    add_boundary_images(vertex.id, vertex.faces, at.loop, at.phi)})
                  .first;
    }
    const auto& both = found->second.images;
    return both[dot(images_[both[0]].v, towards) > 0 ? 0 : 1];
  }

  bool add_loops() {
    for (const auto& boundary : boundaries_) {
      const std::size_t n = boundary.size();
      std::vector<std::size_t> image(n, 0);
      for (std::size_t i = 0; i < n; ++i) {
        if (on_boundary_.contains(boundary[i].id)) continue;
        const double sigma = on_.manifold.sigma(boundary[i].medium, boundary[i].dominant);
        image[i] = add_image(boundary[i].id, boundary[i].faces,
                             sigma <= 0 ? boundary[i].medium : -boundary[i].medium);
      }
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const bool i_on = on_boundary_.contains(boundary[i].id),
                   j_on = on_boundary_.contains(boundary[j].id);
        if (i_on && j_on) return false;  // no sample tells on which side the curve runs
        const std::size_t a = i_on ? boundary_image(boundary[i], images_[image[j]].v) : image[i];
        const std::size_t b = j_on ? boundary_image(boundary[j], images_[image[i]].v) : image[j];
        // Without a crossing between them the canonical vectors lie side by side.
        if (!(dot(images_[a].v, images_[b].v) > 0)) return false;
        segments_.push_back({a, b});
      }
    }
    return true;
  }

  bool boundary_is_inside(int loop, double phi) const {
    return inner_.is_inside(
        on_.manifold.tensor_at_boundary(on_.manifold.boundary_point(loop, phi)));
  }

  /// The parts of the complex domain's boundary inside the tetrahedron, between the crossings of
  /// the face curves; a whole curve that crosses no face included.
  bool add_boundary_curves() {
    std::vector<std::vector<Crossing>> ends(static_cast<std::size_t>(on_.manifold.loop_count()));
    for (const auto& [id, crossing] : crossings_)
      ends[static_cast<std::size_t>(crossing.loop)].push_back(crossing);
    for (std::size_t l = 0; l < ends.size(); ++l) {
      const int loop = static_cast<int>(l);
      auto& list = ends[l];
      std::sort(list.begin(), list.end(),
                [](const Crossing& p, const Crossing& q) { return p.phi < q.phi; });
      if (list.empty()) {
        bool in[3];
        for (int k = 0; k < 3; ++k)
          in[k] = boundary_is_inside(loop, 0.3 + 2 * std::numbers::pi * k / 3);
        if (in[0] != in[1] || in[1] != in[2]) return false;
        if (in[0] && !add_whole_curve(loop)) return false;
        continue;
      }
      if (list.size() % 2 != 0) return false;
      bool previous = false;
      for (std::size_t k = 0; k < list.size(); ++k) {
        const auto& from = list[k];
        const auto& to = list[(k + 1) % list.size()];
        const double end = k + 1 < list.size() ? to.phi : to.phi + 2 * std::numbers::pi;
        const bool in = boundary_is_inside(loop, (from.phi + end) / 2);
        if (k > 0 && in == previous) return false;  // the curve goes in and out by turns
        previous = in;
        if (in && !add_curve(loop, from.phi, end, from.images, to.images)) return false;
      }
    }
    return true;
  }

  /// By the turning of the eigenvectors: the medium hardly turns along a small oval.
  int steps(int loop, double from, double to) const {
    double length = 0;
    auto last = on_.manifold.boundary_point(loop, from);
    auto last_dominant = on_.manifold.dominant_eigenvector(last);
    for (int k = 1; k <= 24; ++k) {
      const auto next = on_.manifold.boundary_point(loop, from + (to - from) * k / 24);
      const auto dominant = on_.manifold.dominant_eigenvector(next);
      const auto d = next - last, turned = cross(dominant, last_dominant);
      length += std::sqrt(std::max(dot(d, d), dot(turned, turned)));
      last = next, last_dominant = dominant;
    }
    return std::max(1, static_cast<int>(std::ceil(length / turn_)));
  }

  std::optional<std::array<std::size_t, 2>> add_boundary_sample(int loop, double phi) {
    const auto v = on_.manifold.boundary_point(loop, phi);
    const auto vertex = inner_.at(on_.manifold.tensor_at_boundary(v));
    if (!vertex) return std::nullopt;
    return add_boundary_images(inner_.add(*vertex), 0, loop, phi);
  }

  bool add_curve(int loop, double from, double to, const std::array<std::size_t, 2>& first,
                 const std::array<std::size_t, 2>& last) {
    // At least one sample inside: the ends may be joined by an edge of the boundary loop as well.
    const int n = std::max(2, steps(loop, from, to));
    auto previous = first;
    for (int k = 1; k < n; ++k) {
      const auto sample = add_boundary_sample(loop, from + (to - from) * k / n);
      if (!sample) continue;  // close to the face: the curve is straight enough without it
      for (std::size_t side = 0; side < 2; ++side)
        segments_.push_back({previous[side], (*sample)[side]});
      previous = *sample;
    }
    for (std::size_t side = 0; side < 2; ++side) segments_.push_back({previous[side], last[side]});
    return true;
  }

  bool add_whole_curve(int loop) {
    const int n = std::max(6, steps(loop, 0, 2 * std::numbers::pi));
    std::vector<std::array<std::size_t, 2>> samples;
    for (int k = 0; k < n; ++k) {
      const auto sample = add_boundary_sample(loop, 2 * std::numbers::pi * k / n);
      if (!sample) return false;
      samples.push_back(*sample);
    }
    for (std::size_t k = 0; k < samples.size(); ++k)
      for (std::size_t side = 0; side < 2; ++side)
        segments_.push_back({samples[k][side], samples[(k + 1) % samples.size()][side]});
    return true;
  }

  /// Points of a grid, even in the chart, that lie in the region, clear of its boundary.
  std::vector<ChartTriangulation::Point> grid_samples(
      const ChartTriangulation::Clearance& clearance) override {
    // The region lies in the cap around its boundary: the rest of the sphere holds the complex
    // domain, whose boundary would be the region's too.
    Vector3<double> centre{0, 0, 0};
    for (const auto& image : images_) centre += image.v;
    double least = 0;
    if (length(centre) > 0) {
      centre = unit(centre);
      least = 1;
      for (const auto& image : images_) least = std::min(least, dot(image.v, centre));
    }
    if (!(least > 0.1)) least = -2;
    std::vector<ChartTriangulation::Point> samples;
    const auto is_wanted = [&](int quadrant) {
      return chart_.largest_product(quadrant, centre) > least - 1e-9;  // for rounding
    };
    visit_grid(chart_, turn_, is_wanted,
               [&](const auto& v, const auto& point, const auto& spacing) {
                 if (dot(v, centre) < least) return;
                 const auto tensor = on_.manifold.tensor_at(v);
                 if (!inner_.is_inside(tensor)) return;
                 const auto place = point();
                 if (!(clearance(place) > 0.5 * spacing())) return;
                 const auto vertex = inner_.at(tensor);
                 if (!vertex) return;
                 add_image(inner_.add(*vertex), 0, v, place);
                 samples.push_back(place);
               });
    return samples;
  }

  /// An inner vertex of the level with the medium eigenvector along v, if there is one.
  std::optional<std::size_t> add_inner_image(const Vector3<double>& along) override {
    if (!(length(along) > 0)) return std::nullopt;
    const auto v = unit(along);
    if (!on_.manifold.in_real_domain(v)) return std::nullopt;
    const auto vertex = inner_.at(on_.manifold.tensor_at(v));
    if (!vertex) return std::nullopt;
    return add_image(inner_.add(*vertex), 0, v);
  }

  const TetManifold& on_;
  ManifoldChart chart_;
  double turn_;

  std::set<std::int32_t> on_boundary_;
  std::map<std::int32_t, Crossing> crossings_;
};

}  // namespace

template <class Scalar>
bool mesh_on_manifold(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                      const CellTopology<Scalar>& proved,
                      std::span<const SampleRequest<Scalar>> requests,
                      const FaceArcVertices& vertices, const Level<Scalar>& level,
                      const Sampling& sampling, int defect_rounds, Patch<Scalar>& out) {
  Patch<Scalar> patch;
  if (!ManifoldMesher<Scalar>(manifold, tet, proved, requests, vertices, level, sampling,
                              defect_rounds, patch)
           .mesh())
    return false;
  out = std::move(patch);
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template bool mesh_on_manifold(const TetManifold&, const TetWithCurves<Scalar>&,               \
                                 const CellTopology<Scalar>&,                                    \
                                 std::span<const SampleRequest<Scalar>>, const FaceArcVertices&, \
                                 const Level<Scalar>&, const Sampling&, int, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
