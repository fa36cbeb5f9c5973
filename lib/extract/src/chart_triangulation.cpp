// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "chart_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <list>

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

}  // namespace

bool ChartTriangulation::build(
    const std::vector<Point>& points, const std::vector<std::array<std::size_t, 2>>& segments,
    const std::function<std::vector<Point>(const Clearance&)>& samples) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> handles(points.size());
  Triangulation::Face_handle near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1])) return false;
    handles[i] = triangulation.insert({points[i][0], points[i][1]}, near);
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
  triangles.clear();
  for (auto face : triangulation.finite_face_handles())
    if (inside(face))
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return true;
}

}  // namespace tensortopo
