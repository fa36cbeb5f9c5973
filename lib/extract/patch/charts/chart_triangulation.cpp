// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/chart_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <numeric>

namespace tensortopo {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;  // segments to outside
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_tag>;

/// Numbers each face by how many segments separate it from the infinite face.
void mark_regions(Triangulation& triangulation) {
  for (auto face : triangulation.all_face_handles()) face->info() = -1;
  std::list<Triangulation::Edge> border;
  const auto flood = [&](Triangulation::Face_handle start, int depth) {
    std::vector<Triangulation::Face_handle> stack{start};
    while (!stack.empty()) {
      const auto face = stack.back();
      stack.pop_back();
      if (face->info() != -1) continue;
      face->info() = depth;
      for (int i = 0; i < 3; ++i) {
        if (face->neighbor(i)->info() != -1) continue;
        if (triangulation.is_constrained({face, i}))
          border.emplace_back(face, i);
        else
          stack.push_back(face->neighbor(i));
      }
    }
  };
  flood(triangulation.infinite_face(), 0);
  while (!border.empty()) {
    const auto [face, i] = border.front();
    border.pop_front();
    if (face->neighbor(i)->info() == -1) flood(face->neighbor(i), face->info() + 1);
  }
}

bool inside(Triangulation::Face_handle face) { return face->info() % 2 == 1; }

/// Along the outline while it is short: neighbours are near. A long outline would so take squared
/// time, each point undoing many triangles of those before it; in a random order few are undone.
std::vector<std::size_t> order_of_insertion(const std::vector<Kernel::Point_2>& points) {
  constexpr std::size_t short_outline = 256;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.size() <= short_outline) return order;
  using Traits = CGAL::Spatial_sort_traits_adapter_2<
      Kernel, CGAL::Pointer_property_map<Kernel::Point_2>::const_type>;
  CGAL::spatial_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(points)));
  return order;
}

/// False if segments cross or points coincide. Numbers the regions.
bool insert_outline(const std::vector<ChartTriangulation::Point>& points,
                    const std::vector<std::array<std::size_t, 2>>& segments,
                    Triangulation& triangulation) {
  std::vector<Kernel::Point_2> places;
  places.reserve(points.size());
  for (const auto& p : points) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1])) return false;
    places.emplace_back(p[0], p[1]);
  }
  std::vector<Triangulation::Vertex_handle> handles(points.size());
  Triangulation::Face_handle near;
  for (const std::size_t i : order_of_insertion(places)) {
    handles[i] = triangulation.insert(places[i], near);
    near = handles[i]->face();
    handles[i]->info() = i;
  }
  if (triangulation.number_of_vertices() != points.size()) return false;
  try {
    for (const auto& [a, b] : segments) triangulation.insert_constraint(handles[a], handles[b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  mark_regions(triangulation);
  return true;
}

std::array<std::size_t, 3> corners_of(Triangulation::Face_handle face) {
  return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
}

/// Where to cut a triangle, with the triangle that holds the place.
ChartTriangulation::Place place_of(const Triangulation& triangulation,
                                   Triangulation::Face_handle face, ChartTriangulation::Cut cut) {
  using Cut = ChartTriangulation::Cut;
  const auto middle = [&](std::array<double, 3> weights) {
    ChartTriangulation::Place place{{0, 0}, corners_of(face), weights};
    for (int i = 0; i < 3; ++i) {
      const double w = weights[static_cast<std::size_t>(i)];
      place.at[0] += w * face->vertex(i)->point().x();
      place.at[1] += w * face->vertex(i)->point().y();
    }
    return place;
  };
  if (cut == Cut::edge0) return middle({0, 0.5, 0.5});
  if (cut == Cut::edge1) return middle({0.5, 0, 0.5});
  if (cut == Cut::edge2) return middle({0.5, 0.5, 0});
  const auto centroid = middle({1.0 / 3, 1.0 / 3, 1.0 / 3});
  const auto centre = triangulation.circumcenter(face);
  if (!std::isfinite(centre.x()) || !std::isfinite(centre.y())) return centroid;
  const auto holder = triangulation.locate(centre, face);
  if (triangulation.is_infinite(holder) || !inside(holder)) return centroid;
  std::array<double, 3> weights;
  double total = 0;
  for (int i = 0; i < 3; ++i) {
    const auto &a = holder->vertex(holder->cw(i))->point(),
               &b = holder->vertex(holder->ccw(i))->point();
    if (triangulation.is_constrained({holder, i}) &&
        CGAL::scalar_product(a - centre, b - centre) < 0)
      return centroid;
    const double w = std::abs(CGAL::area(centre, a, b));
    weights[static_cast<std::size_t>(i)] = w;
    total += w;
  }
  if (!(total > 0)) return centroid;
  for (auto& w : weights) w /= total;
  return {{centre.x(), centre.y()}, corners_of(holder), weights};
}

/// Inserts the points that judging asks for, once; false if none.
class Refinement {
 public:
  Refinement(Triangulation& triangulation, std::size_t count)
      : triangulation_(triangulation), next_(count) {}

  std::vector<ChartTriangulation::Triangle> triangles() {
    faces_.clear();
    std::vector<ChartTriangulation::Triangle> triangles;
    for (auto face : triangulation_.finite_face_handles())
      if (inside(face)) faces_.push_back(face), triangles.push_back(corners_of(face));
    return triangles;
  }

  /// @param cuts of the triangles asked for last
  bool insert(const std::vector<ChartTriangulation::Cut>& cuts,
              const ChartTriangulation::Adding& add) {
    std::vector<ChartTriangulation::Place> places;
    std::vector<double> room;  // squared
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      if (cuts[k] == ChartTriangulation::Cut::none) continue;
      const auto place = place_of(triangulation_, faces_[k], cuts[k]);
      // Neighbours ask for nearly the same place.
      double squared = 1e300;
      for (int i = 0; i < 3; ++i)
        squared = std::min(squared, 0.5 * CGAL::squared_distance(
                                              Kernel::Point_2(place.at[0], place.at[1]),
                                              faces_[k]->vertex(i)->point()));
      bool is_free = true;
      for (std::size_t i = 0; i < places.size() && is_free; ++i) {
        const double x = place.at[0] - places[i].at[0], y = place.at[1] - places[i].at[1];
        is_free = x * x + y * y > std::min(squared, room[i]);
      }
      if (is_free) places.push_back(place), room.push_back(squared);
    }
    bool any = false;
    Triangulation::Face_handle hint;
    for (const auto& place : places) {
      const auto point = add(place);
      if (!point) continue;
      const auto vertex = triangulation_.insert({(*point)[0], (*point)[1]}, hint);
      hint = vertex->face();
      vertex->info() = next_++;
      any = true;
    }
    if (any) mark_regions(triangulation_);
    return any;
  }

  bool are_distinct() const { return triangulation_.number_of_vertices() == next_; }

 private:
  Triangulation& triangulation_;
  std::size_t next_;
  std::vector<Triangulation::Face_handle> faces_;  ///< of the triangles asked for last
};

}  // namespace

bool ChartTriangulation::build(const std::vector<Point>& points,
                               const std::vector<std::array<std::size_t, 2>>& segments,
                               const Sampling& samples, const Judging& judge, const Adding& add,
                               int rounds) try {
  Triangulation triangulation;
  if (!insert_outline(points, segments, triangulation)) return false;

  Triangulation::Face_handle hint;
  const auto clearance = [&](const Point& at) {
    const Kernel::Point_2 p(at[0], at[1]);
    const auto face = triangulation.locate(p, hint);
    hint = face;
    if (triangulation.is_infinite(face) || !inside(face)) return -1.0;
    double squared = CGAL::squared_distance(p, face->vertex(0)->point());
    for (int i = 0; i < 3; ++i) {
      squared = std::min(squared, CGAL::squared_distance(p, face->vertex(i)->point()));
      if (triangulation.is_constrained({face, i}))
        squared =
            std::min(squared, 2.5 * CGAL::squared_distance(p, triangulation.segment(face, i)));
    }
    return std::sqrt(squared);
  };
  std::size_t next = points.size();
  for (const auto& p : samples(clearance)) {
    const auto vertex = triangulation.insert({p[0], p[1]}, hint);
    hint = vertex->face();
    vertex->info() = next++;
  }
  if (triangulation.number_of_vertices() != next) return false;
  mark_regions(triangulation);
  Refinement refinement(triangulation, next);
  triangles = refinement.triangles();
  for (; rounds > 0 && refinement.insert(judge(triangles), add); --rounds) {
    if (!refinement.are_distinct()) return false;
    triangles = refinement.triangles();
  }
  return true;
} catch (const Triangulation::Intersection_of_constraints_exception&) {
  // A point that rounding put on a constraint splits it into segments that meet others.
  return false;
}

}  // namespace tensortopo
