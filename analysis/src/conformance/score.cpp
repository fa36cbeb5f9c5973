// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/score.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "conformance/score_parts.hpp"
#include "conformance/split_fans.hpp"
#include "conformance/triangle_search.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

std::array<Vector3<double>, 3> corners(const SurfaceMesh& surface, std::size_t triangle) {
  const auto& t = surface.triangles[triangle];
  return {surface.points[as_size(t[0])], surface.points[as_size(t[1])],
          surface.points[as_size(t[2])]};
}

Vector3<double> centroid(const std::array<Vector3<double>, 3>& t) {
  return (1.0 / 3) * (t[0] + t[1] + t[2]);
}

double area(const std::array<Vector3<double>, 3>& t) {
  const auto n = cross(t[1] - t[0], t[2] - t[0]);
  return length(n) / 2;
}

double longest_edge(const TetMesh& mesh, Index tet) {
  double longest = 0;
  for (const auto& [i, j] : kTetEdges) {
    const auto& t = mesh.tets[as_size(tet)];
    const auto d = mesh.points[as_size(t[static_cast<std::size_t>(i)])] -
                   mesh.points[as_size(t[static_cast<std::size_t>(j)])];
    longest = std::max(longest, dot(d, d));
  }
  return std::sqrt(longest);
}

std::vector<ScoredComponent> components_of(const SurfaceMesh& surface,
                                           const SurfaceInvariants& known) {
  std::vector<ScoredComponent> list;
  for (const auto& part : known.parts)
    list.push_back({part.euler_characteristic, part.boundary_loops, part.triangles, {}});
  for (std::size_t i = surface.triangles.size(); i-- > 0;)
    list[as_size(known.component[i])].place = centroid(corners(surface, i));
  return list;
}

// The components all of whose triangles have a side that is as good as nothing.
std::vector<char> without_extent(const TetMesh& mesh, const SurfaceMesh& surface,
                                 const SurfaceInvariants& known, const GivenSurface& given,
                                 double touch) {
  std::vector<char> result(known.parts.size(), 1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    char& so_far = result[as_size(known.component[i])];
    if (so_far == 0) continue;
    const auto t = corners(surface, i);
    const double shortest =
        std::min({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
    so_far = shortest <= touch_distance(mesh, given, longest_edge(mesh, surface.tet[i]), touch);
  }
  return result;
}

// Which part of each component's area is nearest to which component of the other surface, and near.
struct Votes {
  std::vector<double> total;
  std::vector<std::map<Index, double>> of;

  // The component with most of the area; -1 if no half of it is near any.
  Index favourite(Index component) const {
    Index best = -1;
    double most = 0;
    for (const auto& [other, part] : of[as_size(component)])
      if (part > most) best = other, most = part;
    return 2 * most >= total[as_size(component)] ? best : -1;
  }
};

// The vertices of the triangles and the middles of their edges, each once, without those that are
// not farther than `known` since the nearest triangle's distance is known at the centroid beside.
std::vector<Vector3<double>> farther_samples(const SurfaceMesh& surface,
                                             const std::vector<TriangleSearch::Nearest>& at_centre,
                                             double known) {
  std::vector<std::array<Index, 2>> edges;  // of a vertex and itself, too
  const auto sample = [&](const std::array<Index, 2>& edge) {
    return 0.5 * (surface.points[as_size(edge[0])] + surface.points[as_size(edge[1])]);
  };
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    const auto c = centroid(corners(surface, i));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      for (const std::array<Index, 2>& edge : {std::array{a, b}, std::array{t[k], t[k]}}) {
        const auto d = sample(edge) - c;
        if (at_centre[i].distance + length(d) > known) edges.push_back(edge);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Vector3<double>> samples;
  samples.reserve(edges.size());
  for (const auto& edge : edges) samples.push_back(sample(edge));
  return samples;
}

double largest_distance(const std::vector<Vector3<double>>& samples, const TriangleSearch& search) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, samples.size(), 256), 0.0,
      [&](const auto& range, double largest) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          largest = std::max(largest, search.nearest(samples[i]).distance);
        return largest;
      },
      [](double a, double b) { return std::max(a, b); });
}

// Samples `from` at vertices and the middles of edges and triangles; the largest distance goes to
// `largest`.
template <class Reach>
Votes vote(const SurfaceMesh& from, const SurfaceInvariants& of_from, const TriangleSearch* search,
           const SurfaceInvariants& of_to, const Reach& reach, double& largest) {
  Votes votes{std::vector<double>(of_from.parts.size()),
              std::vector<std::map<Index, double>>(of_from.parts.size())};
  std::vector<TriangleSearch::Nearest> at_centre(from.triangles.size());
  if (search != nullptr) {
    tbb::parallel_for(std::size_t{0}, at_centre.size(), [&](std::size_t i) {
      at_centre[i] = search->nearest(centroid(corners(from, i)));
    });
    for (const auto& nearest : at_centre) largest = std::max(largest, nearest.distance);
    largest =
        std::max(largest, largest_distance(farther_samples(from, at_centre, largest), *search));
  } else if (!from.triangles.empty()) {
    largest = std::numeric_limits<double>::infinity();
  }
  for (std::size_t i = 0; i < from.triangles.size(); ++i) {
    const Index component = of_from.component[i];
    // Triangles without area have a say, too.
    const double weight = area(corners(from, i)) + std::numeric_limits<double>::min();
    votes.total[as_size(component)] += weight;
    if (search == nullptr) continue;
    if (at_centre[i].distance <= reach(i, at_centre[i].triangle))
      votes.of[as_size(component)][of_to.component[as_size(at_centre[i].triangle)]] += weight;
  }
  return votes;
}

}  // namespace

Standard certified_standard(const TetMesh& mesh, const ModeValue& mode, double resolution) {
  ExtractOptions options;
  options.keep_topology = true;
  options.sampling.resolution = resolution;
  Extraction extraction = extract_mode_surface<double>(mesh, mode, options);
  Standard standard;
  standard.level = certify(mesh, mode, extraction);
  standard.surface = std::move(extraction.surface);
  return standard;
}

std::size_t SurfaceScore::wrong_topology() const {
  return static_cast<std::size_t>(std::count_if(matched.begin(), matched.end(),
                                                [](const auto& m) { return !m.same_topology(); }));
}

bool SurfaceScore::conforms() const {
  return missed.empty() && extra.empty() && wrong_topology() == 0 && hole_edges == 0 &&
         seam_edges == 0 && non_manifold_edges == 0 && non_manifold_vertices == 0 && edges.empty();
}

SurfaceScore score_surface(const TetMesh& mesh, const Standard& standard, GivenSurface given,
                           const ScoreOptions& options) {
  split_fans(given, standard.surface);
  SurfaceScore score;
  score.triangles = given.surface.triangles.size();
  score.merged_points = given.merged_points;
  score.collapsed_triangles = given.collapsed_triangles;
  score.certified = standard.level.distance.bound;
  score.coarse_cells = standard.level.distance.coarse.size();
  score.coarse_bound = standard.level.distance.coarse_bound;
  score.undecided = standard.level.undecided.size();
  const SurfaceInvariants truth = surface_invariants(standard.surface);
  const SurfaceInvariants known = surface_invariants(given.surface);
  score.consistently_oriented = known.consistently_oriented;
  score_connectivity(mesh, standard, given, options.touch, score);
  const auto crossings = score_crossings(mesh, standard, given, truth.component, known.component,
                                         options.touch, score);

  std::optional<TriangleSearch> among_truth, among_given;
  if (!standard.surface.triangles.empty()) among_truth.emplace(standard.surface);
  if (!given.surface.triangles.empty()) among_given.emplace(given.surface);
  const auto reach = [&](Index triangle) {
    return longest_edge(mesh, standard.surface.tet[as_size(triangle)]);
  };
  const Votes of_given = vote(
      given.surface, known, among_truth ? &*among_truth : nullptr, truth,
      [&](std::size_t, Index other) { return reach(other); }, score.to_truth);
  const Votes of_truth = vote(
      standard.surface, truth, among_given ? &*among_given : nullptr, known,
      [&](std::size_t own, Index) { return reach(static_cast<Index>(own)); }, score.from_truth);

  std::map<std::pair<Index, Index>, std::size_t> shared;
  std::vector<std::size_t> has_crossings(truth.parts.size(), 0);
  for (const auto& c : crossings) {
    if (c.truth < 0) continue;
    ++shared[{c.truth, c.given}];
    ++has_crossings[as_size(c.truth)];
  }
  const auto true_list = components_of(standard.surface, truth);
  const auto given_list = components_of(given.surface, known);
  const auto nothing = without_extent(mesh, standard.surface, truth, given, options.touch);
  std::vector<char> taken(given_list.size(), 0);
  for (std::size_t c = 0; c < true_list.size(); ++c) {
    const Index other = of_truth.favourite(static_cast<Index>(c));
    const bool mutual = other >= 0 && of_given.favourite(other) == static_cast<Index>(c);
    const std::size_t common = mutual ? shared[{static_cast<Index>(c), other}] : 0;
    if (mutual && (common > 0 || has_crossings[c] == 0)) {
      taken[as_size(other)] = 1;
      score.matched.push_back({true_list[c], given_list[as_size(other)], common});
    } else if (nothing[c] != 0) {
      ++score.without_extent;
    } else {
      score.missed.push_back(true_list[c]);
    }
  }
  for (std::size_t c = 0; c < given_list.size(); ++c)
    if (!taken[c]) score.extra.push_back(given_list[c]);
  return score;
}

}  // namespace tensortopo
