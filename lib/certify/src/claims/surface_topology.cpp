// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/surface_topology.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Vertex = SurfaceMesh::Index;
using Face = std::array<Index, 3>;
using Loop = std::vector<LevelTopology::BoundaryArc>;

/// The curves on the faces of a tetrahedron, as its boundary loops have them.
struct FaceCurves {
  std::vector<std::pair<Face, std::array<Vertex, 2>>> arcs;
  std::vector<std::pair<Face, Vertex>> loops;
};

class TetReader {
 public:
  TetReader(const TetMesh& mesh, const SurfaceMesh& surface) : mesh_(mesh), surface_(surface) {}

  /// Nothing if a boundary loop is not as it should be.
  std::optional<LevelTopology::Tet> read(Index tet, std::span<const std::size_t> triangles,
                                         FaceCurves& curves) const;

 private:
  bool is_crossing(Vertex v) const { return surface_.carrier[as_size(v)] == Carrier::edge; }
  std::optional<Face> face_of(Vertex v, Vertex w) const;
  std::optional<Loop> read(Index tet, std::vector<Vertex> loop_vertices, FaceCurves& curves) const;

  const TetMesh& mesh_;
  const SurfaceMesh& surface_;
};

/// The face that holds both vertices, if it is one.
std::optional<Face> TetReader::face_of(Vertex v, Vertex w) const {
  std::set<Index> corners;
  for (const Vertex x : {v, w})
    for (const Index c : surface_.carrier_vertices[as_size(x)])
      if (c >= 0) corners.insert(c);
  if (corners.size() != 3) return std::nullopt;
  Face face;
  std::copy(corners.begin(), corners.end(), face.begin());
  return face;
}

/// A boundary loop as arcs: each from one crossing to the next in one face, or all of it a closed
/// curve.
std::optional<Loop> TetReader::read(Index tet, std::vector<Vertex> loop_vertices,
                                    FaceCurves& curves) const {
  std::size_t first = 0;
  for (std::size_t i = 1; i < loop_vertices.size(); ++i)
    if (std::pair(!is_crossing(loop_vertices[i]), loop_vertices[i]) <
        std::pair(!is_crossing(loop_vertices[first]), loop_vertices[first]))
      first = i;
  std::rotate(loop_vertices.begin(), loop_vertices.begin() + static_cast<std::ptrdiff_t>(first),
              loop_vertices.end());
  const bool is_closed_curve = !is_crossing(loop_vertices[0]);
  const auto at = [&](std::size_t i) { return loop_vertices[i % loop_vertices.size()]; };
  Loop loop;
  for (std::size_t i = 0; i < loop_vertices.size();) {
    const auto face = face_of(at(i), at(i + 1));
    if (!face) return std::nullopt;
    std::size_t end = i + 1;
    for (; end < loop_vertices.size() && !is_crossing(loop_vertices[end]); ++end)
      if (face_of(at(end), at(end + 1)) != face) return std::nullopt;
    const auto& corners = mesh_.tets[as_size(tet)];
    const auto opposite = std::find_if(corners.begin(), corners.end(), [&](Index c) {
      return std::find(face->begin(), face->end(), c) == face->end();
    });
    if (opposite == corners.end()) return std::nullopt;
    loop.push_back({loop_vertices[i], *opposite});
    if (is_closed_curve)
      curves.loops.push_back({*face, loop_vertices[i]});
    else
      curves.arcs.push_back({*face, {std::min(at(i), at(end)), std::max(at(i), at(end))}});
    i = end;
  }
  return loop;
}

std::optional<LevelTopology::Tet> TetReader::read(Index tet, std::span<const std::size_t> triangles,
                                                  FaceCurves& curves) const {
  // Pieces, by the lowest of their triangles.
  std::vector<std::size_t> piece(triangles.size());
  std::iota(piece.begin(), piece.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (piece[i] != i) i = piece[i] = piece[piece[i]];
    return i;
  };
  std::map<std::array<Vertex, 2>, std::size_t> sides;  // directed edges
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = surface_.triangles[triangles[i]];
      if (!sides.emplace(std::array{v[k], v[(k + 1) % 3]}, i).second) return std::nullopt;
    }
  std::map<Vertex, std::pair<Vertex, std::size_t>>
      next;  // along the boundary loops, and the triangle
  for (const auto& [side, i] : sides) {
    const auto other = sides.find({side[1], side[0]});
    if (other == sides.end()) {
      if (!next.emplace(side[0], std::pair(side[1], i)).second) return std::nullopt;
    } else if (const auto a = find(i), b = find(other->second); a != b) {
      piece[std::max(a, b)] = std::min(a, b);
    }
  }
  std::map<std::size_t, LevelTopology::Sheet> sheets;
  std::map<std::size_t, std::set<Vertex>> vertices;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    auto& [chi, loops] = sheets[find(i)];
    const auto& v = surface_.triangles[triangles[i]];
    ++chi;
    for (std::size_t k = 0; k < 3; ++k) {
      chi += vertices[find(i)].insert(v[k]).second ? 1 : 0;
      // An inner edge counts at one of its sides.
      const bool is_inner = sides.contains({v[(k + 1) % 3], v[k]});
      chi -= !is_inner || v[k] < v[(k + 1) % 3] ? 1 : 0;
    }
  }
  while (!next.empty()) {
    const std::size_t sheet = find(next.begin()->second.second);
    std::vector<Vertex> loop_vertices;
    Vertex v = next.begin()->first;
    while (const auto step = next.extract(v)) loop_vertices.push_back(v), v = step.mapped().first;
    if (v != loop_vertices[0]) return std::nullopt;
    auto loop = read(tet, std::move(loop_vertices), curves);
    if (!loop) return std::nullopt;
    sheets[sheet].loops.push_back(std::move(*loop));
  }
  LevelTopology::Tet result{tet, {}};
  for (auto& [first, sheet] : sheets) {
    std::sort(sheet.loops.begin(), sheet.loops.end());
    result.sheets.push_back(std::move(sheet));
  }
  // One without boundary has its tetrahedron for itself.
  std::sort(result.sheets.begin(), result.sheets.end(),
            [](const auto& p, const auto& q) { return p.loops < q.loops; });
  return result;
}

std::vector<LevelTopology::Edge> edges_of(const TetMesh& mesh, const SurfaceMesh& surface,
                                          const std::vector<char>& is_read) {
  std::map<std::array<Index, 2>, std::vector<LevelTopology::Crossing>> found;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    if (surface.carrier[v] != Carrier::edge || !is_read[v]) continue;
    const auto& ends = surface.carrier_vertices[v];
    const auto& a = mesh.points[as_size(ends[0])];
    const auto d = mesh.points[as_size(ends[1])] - a;
    const double weight = dot(surface.points[v] - a, d) / dot(d, d);
    found[{ends[0], ends[1]}].push_back({{1 - weight, weight}, false, static_cast<Vertex>(v)});
  }
  std::vector<LevelTopology::Edge> result;
  for (auto& [vertices, crossings] : found) {
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const auto& p, const auto& q) { return p.weights[1] < q.weights[1]; });
    result.push_back({vertices, std::move(crossings)});
  }
  return result;
}

/// Both tetrahedra at a face have its curves: each once.
template <class T>
void make_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

std::vector<LevelTopology::Face> faces_of(FaceCurves curves) {
  make_unique(curves.arcs);
  make_unique(curves.loops);
  std::map<Face, LevelTopology::Face> found;
  for (const auto& [face, arc] : curves.arcs) found[face].arcs.push_back(arc);
  for (const auto& [face, loop] : curves.loops) found[face].loops.push_back(loop);
  std::vector<LevelTopology::Face> result;
  for (auto& [vertices, face] : found) {
    face.vertices = vertices;
    result.push_back(std::move(face));
  }
  return result;
}

}  // namespace

LevelTopology topology_of(const TetMesh& mesh, const SurfaceMesh& surface,
                          std::vector<UndecidedCell>& undecided) {
  std::vector<std::size_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return surface.tet[i] < surface.tet[j]; });
  const TetReader reader(mesh, surface);
  LevelTopology topology;
  FaceCurves curves;
  std::vector<char> is_read(surface.points.size(), 0), is_undecided(mesh.tets.size(), 0);
  for (const auto& cell : undecided) is_undecided[as_size(cell.tet)] = 1;
  for (std::size_t i = 0; i < order.size();) {
    const Index tet = surface.tet[order[i]];
    std::size_t end = i;
    while (end < order.size() && surface.tet[order[end]] == tet) ++end;
    const std::span triangles(order.data() + i, end - i);
    i = end;
    if (is_undecided[as_size(tet)]) continue;
    FaceCurves own;
    if (auto read = reader.read(tet, triangles, own)) {
      topology.tets.push_back(std::move(*read));
      curves.arcs.insert(curves.arcs.end(), own.arcs.begin(), own.arcs.end());
      curves.loops.insert(curves.loops.end(), own.loops.begin(), own.loops.end());
      for (const std::size_t t : triangles)
        for (const Vertex v : surface.triangles[t]) is_read[as_size(v)] = 1;
    } else {
      undecided.push_back({tet, "inconsistent_samples"});
    }
  }
  topology.edges = edges_of(mesh, surface, is_read);
  topology.faces = faces_of(std::move(curves));
  return topology;
}

}  // namespace tensortopo
