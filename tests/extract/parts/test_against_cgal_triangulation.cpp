// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "extract/parts/plane_cases.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Index = ConstrainedDelaunay::Index;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;  // depth
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Theirs = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                          CGAL::No_constraint_intersection_tag>;
using NumberedTriangle = std::pair<std::array<Index, 3>, bool>;  // is it in the regions?

/// False if it refuses the case.
bool insert(const PlaneCase& c, Theirs& theirs) {
  std::vector<Theirs::Vertex_handle> handles;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    handles.push_back(theirs.insert({c.points[i][0], c.points[i][1]}));
    handles.back()->info() = static_cast<Index>(i);
  }
  if (theirs.number_of_vertices() != c.points.size()) return false;
  try {
    for (const auto& [a, b] : c.segments)
      if (a != b) theirs.insert_constraint(handles[a], handles[b]);
  } catch (const Theirs::Intersection_of_constraints_exception&) {
    return false;
  }
  return true;
}

/// Breadth first, by constrained edges from the outside.
void number_regions(Theirs& theirs) {
  for (auto f : theirs.all_face_handles()) f->info() = -1;
  std::vector<Theirs::Face_handle> found{theirs.infinite_face()}, beyond;
  for (int depth = 0; !found.empty(); ++depth) {
    for (std::size_t n = 0; n < found.size(); ++n) {
      const auto f = found[n];
      if (f->info() != -1) continue;
      f->info() = depth;
      for (int i = 0; i < 3; ++i)
        (theirs.is_constrained({f, i}) ? beyond : found).push_back(f->neighbor(i));
    }
    found = std::exchange(beyond, {});
  }
}

bool has_ties(const Theirs& theirs) {
  for (auto e : theirs.finite_edges()) {
    const auto other = theirs.mirror_edge(e);
    if (theirs.is_constrained(e) || theirs.is_infinite(e.first) || theirs.is_infinite(other.first))
      continue;
    const auto f = e.first;
    if (CGAL::side_of_oriented_circle(f->vertex(0)->point(), f->vertex(1)->point(),
                                      f->vertex(2)->point(),
                                      other.first->vertex(other.second)->point()) == 0)
      return true;
  }
  return false;
}

std::vector<NumberedTriangle> sorted(std::vector<NumberedTriangle> triangles) {
  for (auto& [t, inside] : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<NumberedTriangle> triangles_of(const Theirs& theirs) {
  std::vector<NumberedTriangle> result;
  if (theirs.dimension() == 2)
    for (auto f : theirs.finite_face_handles())
      result.push_back(
          {{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}, f->info() % 2 == 1});
  return sorted(std::move(result));
}

std::vector<NumberedTriangle> triangles_of(const ConstrainedDelaunay& ours) {
  std::vector<NumberedTriangle> result;
  for (const auto& t : ours.triangles())
    if (!ConstrainedDelaunay::is_infinite(t)) result.push_back({t.corners, t.depth % 2 == 1});
  return sorted(std::move(result));
}

std::set<std::pair<Index, Index>> constrained_edges(const Theirs& theirs) {
  std::set<std::pair<Index, Index>> edges;
  for (auto e : theirs.finite_edges())
    if (theirs.is_constrained(e))
      edges.insert(std::minmax({e.first->vertex(theirs.cw(e.second))->info(),
                                e.first->vertex(theirs.ccw(e.second))->info()}));
  return edges;
}

std::set<std::pair<Index, Index>> constrained_edges(const ConstrainedDelaunay& ours) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& t : ours.triangles())
    for (std::size_t i = 0; i < 3; ++i)
      if (t.constrained[i])
        edges.insert(std::minmax({t.corners[(i + 1) % 3], t.corners[(i + 2) % 3]}));
  return edges;
}

/// Sums of the triangles' areas in and out of the regions; ties do not change them.
std::array<double, 2> areas(const PlaneCase& c, const std::vector<NumberedTriangle>& triangles) {
  std::array<double, 2> sums{};
  for (const auto& [t, inside] : triangles) {
    const auto &p = c.points[t[0]], &q = c.points[t[1]], &r = c.points[t[2]];
    sums[inside] += (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }
  return sums;
}

/// Turned, so that coordinates are not whole and points are nearly on lines and circles only.
PlaneCase turned(PlaneCase c, std::mt19937& random) {
  const double angle = std::uniform_real_distribution<>(0, 3)(random);
  for (auto& [x, y] : c.points) {
    const double u = x * std::cos(angle) - y * std::sin(angle);
    y = x * std::sin(angle) + y * std::cos(angle);
    x = u;
  }
  return c;
}

TEST(ConstrainedDelaunay, IsThatOfCgal) {
  Compared same("triangulations without ties", 500), tied("triangulations with ties", 100),
      refused("cases that both refuse", 20), alike("triangles", 20000);
  std::mt19937 random(20261129);
  for (int trial = trials(4000); trial > 0; --trial) {
    auto c = random_plane_case(random);
    const auto any = [&] { return static_cast<std::size_t>(random() % c.points.size()); };
    if (trial % 5 == 0) c.segments.push_back({any(), any()});  // may cross others
    const bool is_turned = trial % 2 == 0;
    if (is_turned) c = turned(std::move(c), random);
    Theirs theirs;
    ConstrainedDelaunay ours;
    const bool is_taken = insert(c, theirs);
    ASSERT_EQ(insert(c, ours), is_taken);
    if (!is_taken) {
      ++refused;
      continue;
    }
    if (c.points.size() > 1) {
      ASSERT_EQ(constrained_edges(ours), constrained_edges(theirs));
    }
    ours.number_regions();
    if (theirs.dimension() == 2) number_regions(theirs);
    const auto expected = triangles_of(theirs), found = triangles_of(ours);
    if (theirs.dimension() == 2 && has_ties(theirs)) {
      ASSERT_EQ(found.size(), expected.size());
      if (!is_turned) {
        ASSERT_EQ(areas(c, found), areas(c, expected));
      }
      ++tied;
    } else {
      ASSERT_EQ(found, expected);
      ++same;
    }
    for (std::size_t i = 0; i < found.size(); ++i) ++alike;
  }
}

}  // namespace
}  // namespace tensortopo::test
