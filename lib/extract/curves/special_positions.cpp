// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special_positions.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "extract/curves/points/exact_face_points.hpp"
#include "extract/run/parallel_stage.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

template <std::size_t Count>
SimplexVertices padded(const std::array<Index, Count>& vertices) {
  SimplexVertices result{-1, -1, -1, -1};
  std::copy(vertices.begin(), vertices.end(), result.begin());
  return result;
}

/// A place in the interior of a simplex, its vertices in order.
template <std::size_t Count>
CurvePlace place_at(const SpecialPoint& point, const std::array<Index, Count>& vertices) {
  std::array<std::size_t, Count> order;
  for (std::size_t i = 0; i < Count; ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return vertices[i] < vertices[k]; });
  CurvePlace place;
  for (std::size_t i = 0; i < Count; ++i) {
    place.vertices[i] = vertices[order[i]];
    place.weights[i] = point.weights[order[i]];
  }
  place.dominant = point.dominant;
  return place;
}

}  // namespace

SpecialPositions::SpecialPositions(const TetMesh& mesh, const ScaledField<double>& field,
                                   Degeneracy kind, const ExtractOptions& options,
                                   CurveCells& cells)
    : mesh_(mesh),
      field_(field),
      linear_(kind == Degeneracy::linear),
      options_(options),
      cells_(cells) {}

template <std::size_t Count>
std::array<ScaledTensor, Count> SpecialPositions::tensors_at(
    const std::array<Index, Count>& vertices) const {
  std::array<ScaledTensor, Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto v = as_size(vertices[i]);
    result[i] = {mesh_.tensors[v], field_.exponents[v]};
  }
  return result;
}

ExactDirection SpecialPositions::direction_of(std::size_t place) const {
  if (place >= first_special_) return *directions_[place - first_special_];
  const std::size_t face = general_face_[place];
  return normalized(refined(MultiprecisionFace(tensors_at<3>(cells_.complex.faces[face])),
                            cells_.faces[face].points[place - cells_.first_place[face]].box));
}

template <std::size_t Count>
void SpecialPositions::add_to(Loop& boundary, std::size_t place,
                              const std::array<Index, Count>& vertices) const {
  const CurvePlace& known = cells_.places[place];
  SpecialPoint point;
  for (std::size_t i = 0; i < Count; ++i)
    if (std::find(known.vertices.begin(), known.vertices.end(), vertices[i]) !=
        known.vertices.end())
      point.support |= 1u << i;
  point.dominant = known.dominant;
  if (place < first_special_ || directions_[place - first_special_])
    point.direction = direction_of(place);
  boundary.points.push_back(std::move(point));
  boundary.places.push_back(place);
}

template <std::size_t Count>
void SpecialPositions::add_vertices(Loop& boundary,
                                    const std::array<Index, Count>& vertices) const {
  for (const Index v : vertices)
    if (const auto found = vertices_.find(v); found != vertices_.end())
      add_to(boundary, found->second, vertices);
}

template <std::size_t Count>
void SpecialPositions::enter(Found& found, const std::array<Index, Count>& vertices) {
  for (const SpecialPoint& point : found.cell.points) {
    found.boundary.push_back(cells_.places.size());
    cells_.places.push_back(place_at(point, vertices));
    directions_.push_back(point.direction);
  }
}

void SpecialPositions::find() {
  first_special_ = cells_.places.size();
  general_face_.resize(first_special_);
  for (std::size_t f = 0; f < cells_.faces.size(); ++f) {
    for (std::size_t k = 0; k < cells_.faces[f].points.size(); ++k)
      general_face_[cells_.first_place[f] + k] = f;
    if (cells_.faces[f].obstacle) faces_.emplace(static_cast<Index>(f), Found{});
  }
  find_on_vertices();
  if (faces_.empty()) return;
  find_on_edges();
  find_on_faces();
}

void SpecialPositions::find_on_vertices() {
  std::set<Index> candidates;
  for (const auto& [f, found] : faces_)
    for (const Index v : cells_.complex.faces[as_size(f)]) candidates.insert(v);
  for (const Index t : cells_.complex.tets)
    for (const Index v : mesh_.tets[as_size(t)])
      if (field_.is_zero[as_size(v)]) candidates.insert(v);
  for (const Index v : candidates) {
    const auto kind = kind_of(
        exact_deviator<Rational>({mesh_.tensors[as_size(v)], field_.exponents[as_size(v)]}));
    if (!kind.zero && !(kind.degenerate && kind.linear == linear_)) continue;
    CurvePlace place;
    place.vertices[0] = v;
    place.weights[0] = 1;
    if (!kind.zero) place.dominant = rounded_direction(kind.direction);
    vertices_.emplace(v, cells_.places.size());
    cells_.places.push_back(place);
    directions_.push_back(kind.zero ? std::nullopt : std::optional(kind.direction));
  }
}

void SpecialPositions::find_on_edges() {
  std::set<Index> candidates;
  for (const auto& [f, found] : faces_)
    for (const Index e : cells_.complex.face_edges[as_size(f)]) candidates.insert(e);
  std::vector<Index> edges(candidates.begin(), candidates.end());
  std::vector<Found> found(edges.size());
  parallel_stage(options_, "faces", edges.size(), 16, [&](std::size_t i) {
    const FloatingPointEnvironment environment;
    const auto& vertices = cells_.complex.edges[as_size(edges[i])];
    Loop boundary;
    add_vertices(boundary, vertices);
    found[i].boundary = boundary.places;
    found[i].cell = special_cell<2>(tensors_at(vertices), linear_, boundary.points, 1);
  });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    enter(found[i], cells_.complex.edges[as_size(edges[i])]);
    edges_.emplace(edges[i], std::move(found[i]));
  }
}

SpecialPositions::Found SpecialPositions::found_on_face(
    Index face, std::span<const ExactDirection> crossings) const {
  Found found;
  const auto& vertices = cells_.complex.faces[as_size(face)];
  Loop boundary;
  add_vertices(boundary, vertices);
  for (const Index e : cells_.complex.face_edges[as_size(face)]) {
    const Found& edge = edges_.at(e);
    if (edge.cell.obstacle) {
      found.cell.obstacle = edge.cell.obstacle;
      return found;
    }
    for (std::size_t k = edge.boundary.size() - edge.cell.points.size(); k < edge.boundary.size();
         ++k)
      add_to(boundary, edge.boundary[k], vertices);
  }
  found.boundary = boundary.places;
  found.cell = special_cell<3>(tensors_at(vertices), linear_, boundary.points,
                               options_.sampling.largest_turn(), {}, crossings);
  return found;
}

void SpecialPositions::find_on_faces() {
  std::vector<Index> faces;
  for (const auto& [f, found] : faces_) faces.push_back(f);
  std::vector<Found> found(faces.size());
  parallel_stage(options_, "faces", faces.size(), 16, [&](std::size_t i) {
    const FloatingPointEnvironment environment;
    found[i] = found_on_face(faces[i], {});
  });
  // A curve in a face may be crossed by those of the tetrahedra beside it.
  std::vector<std::size_t> crossed;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (found[i].cell.axis && !found[i].cell.pieces.empty()) crossed.push_back(i);
  const TetCrossings crossings = crossings_beside(faces, crossed);
  parallel_stage(options_, "faces", crossed.size(), 16, [&](std::size_t k) {
    const FloatingPointEnvironment environment;
    const Index face = faces[crossed[k]];
    const auto beside = crossings_at(face, crossings);
    if (!beside.empty()) found[crossed[k]] = found_on_face(face, beside);
  });
  for (std::size_t i = 0; i < faces.size(); ++i) {
    enter(found[i], cells_.complex.faces[as_size(faces[i])]);
    faces_[faces[i]] = std::move(found[i]);
  }
}

SpecialPositions::TetCrossings SpecialPositions::crossings_beside(
    std::span<const Index> faces, std::span<const std::size_t> crossed) const {
  TetCrossings result;
  for (const std::size_t i : crossed)
    for (const Index t : cells_.complex.face_tets[as_size(faces[i])])
      if (t >= 0) result.emplace_back(t, Vector3<Rational>{});
  const auto by_tet = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(result.begin(), result.end(), by_tet);
  result.erase(std::unique(result.begin(), result.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; }),
               result.end());
  parallel_stage(options_, "faces", result.size(), 16, [&](std::size_t k) {
    const FloatingPointEnvironment environment;
    const Index tet = cells_.complex.tets[as_size(result[k].first)];
    result[k].second = crossing_of(tensors_at(mesh_.tets[as_size(tet)]));
  });
  return result;
}

std::vector<ExactDirection> SpecialPositions::crossings_at(Index face,
                                                           const TetCrossings& crossings) const {
  std::vector<Vector3<Rational>> found;
  for (const Index t : cells_.complex.face_tets[as_size(face)]) {
    if (t < 0) continue;
    const auto at =
        std::lower_bound(crossings.begin(), crossings.end(), t,
                         [](const auto& entry, Index tet) { return entry.first < tet; });
    const auto& crossing = at->second;
    if (!is_zero(crossing) && (found.empty() || !is_zero(cross(found[0], crossing))))
      found.push_back(crossing);
  }
  std::vector<ExactDirection> result;
  for (const auto& crossing : found) result.push_back(normalized(interval_of(crossing)));
  return result;
}

CellCurves SpecialPositions::curve_in_tet(std::size_t t) const {
  const FloatingPointEnvironment environment;
  const auto& complex = cells_.complex;
  const auto& vertices = mesh_.tets[as_size(complex.tets[t])];
  CellCurves result;
  Loop boundary;
  add_vertices(boundary, vertices);
  for (const Index e : complex.tet_edges[t])
    if (const auto found = edges_.find(e); found != edges_.end()) {
      const Found& edge = found->second;
      for (std::size_t k = edge.boundary.size() - edge.cell.points.size(); k < edge.boundary.size();
           ++k)
        add_to(boundary, edge.boundary[k], vertices);
    }
  std::array<const SpecialCell*, 4> faces{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Index f = complex.tet_faces[t][i];
    if (const auto found = faces_.find(f); found != faces_.end()) {
      const Found& face = found->second;
      if (face.cell.obstacle && face.cell.obstacle != CurveObstacle::degenerate_throughout) {
        result.obstacle = face.cell.obstacle;
        return result;
      }
      faces[i] = &face.cell;
      for (std::size_t k = face.boundary.size() - face.cell.points.size(); k < face.boundary.size();
           ++k)
        add_to(boundary, face.boundary[k], vertices);
    } else {
      for (std::size_t k = 0; k < cells_.faces[as_size(f)].points.size(); ++k)
        add_to(boundary, cells_.first_place[as_size(f)] + k, vertices);
    }
  }
  auto cell = special_cell<4>(tensors_at(vertices), linear_, boundary.points,
                              options_.sampling.largest_turn(), faces);
  result.obstacle = cell.obstacle;
  if (cell.obstacle && cell.axis) {
    const auto e = rounded_direction(interval_of(*cell.axis));
    result.axis = {static_cast<double>(e.x), static_cast<double>(e.y), static_cast<double>(e.z)};
  }
  for (const SpecialPoint& point : cell.points) result.places.push_back(place_at(point, vertices));
  for (SpecialPiece& piece : cell.pieces) {
    CurveLink link;
    link.tet = complex.tets[t];
    link.vertices = padded(vertices);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t end = piece.ends[k];
      link.ends[k] = end < boundary.places.size()
                         ? boundary.places[end]
                         : cells_.places.size() + end - boundary.places.size();
    }
    link.inner = std::move(piece.inner);
    result.links.push_back(std::move(link));
  }
  return result;
}

std::vector<SpecialPositions::Below> SpecialPositions::simplices_below() const {
  const auto& complex = cells_.complex;
  std::vector<Below> result;
  for (const auto& [f, found] : faces_) {
    if (found.cell.pieces.empty()) continue;
    Below& below = result.emplace_back(Below{&found, padded(complex.faces[as_size(f)]), {}});
    for (const Index t : complex.face_tets[as_size(f)])
      if (t >= 0) below.around.push_back(as_size(t));
  }
  std::map<Index, std::vector<std::size_t>> tets_at_edge;
  for (const auto& [e, found] : edges_)
    if (!found.cell.pieces.empty()) tets_at_edge[e] = {};
  if (!tets_at_edge.empty())
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
      for (const Index e : complex.tet_edges[t])
        if (const auto at = tets_at_edge.find(e); at != tets_at_edge.end()) at->second.push_back(t);
  for (auto& [e, around] : tets_at_edge)
    result.push_back({&edges_.at(e), padded(complex.edges[as_size(e)]), std::move(around)});
  return result;
}

SpecialPositions::LinesBelow SpecialPositions::lines_below(
    const std::vector<CellCurves>& tets) const {
  const auto simplices = simplices_below();
  return {links_of(simplices, tets), messages_of(simplices, tets)};
}

std::vector<CurveLink> SpecialPositions::links_of(std::span<const Below> simplices,
                                                  const std::vector<CellCurves>& tets) const {
  std::vector<CurveLink> result;
  for (const auto& [found, vertices, around] : simplices)
    for (const SpecialPiece& piece : found->cell.pieces) {
      CurveLink link;
      link.vertices = vertices;
      link.ends = {found->boundary[piece.ends[0]], found->boundary[piece.ends[1]]};
      link.inner = piece.inner;
      // One end has a direction, which for straight pieces is that of all of them.
      auto e = cells_.places[link.ends[0]].dominant;
      if (dot(e, e) == 0) e = cells_.places[link.ends[1]].dominant;
      bool bounds_surface = false;
      for (const std::size_t t : around) {
        const auto& tet = tets[t];
        if (link.tet < 0 || tet.obstacle == std::nullopt) link.tet = cells_.complex.tets[t];
        if (tet.obstacle != CurveObstacle::degenerate_on_a_surface &&
            tet.obstacle != CurveObstacle::degenerate_throughout)
          continue;
        // Along the axis or across it, nothing in between.
        const bool along_axis = tet.axis && std::abs(static_cast<double>(e.x) * tet.axis->x +
                                                     static_cast<double>(e.y) * tet.axis->y +
                                                     static_cast<double>(e.z) * tet.axis->z) > 0.5;
        bounds_surface = bounds_surface || !along_axis;
      }
      if (!bounds_surface) result.push_back(std::move(link));
    }
  return result;
}

std::vector<MeshingMessage> SpecialPositions::messages_of(
    std::span<const Below> simplices, const std::vector<CellCurves>& tets) const {
  const auto digest = [](const CellCurves& cell) {
    const auto axis = cell.axis.value_or(Vector3<double>{});
    return digest_of(std::array{cell.obstacle ? static_cast<double>(*cell.obstacle) : -1.0,
                                cell.axis ? 1.0 : 0.0, axis.x, axis.y, axis.z});
  };
  const auto& numbers = cells_.complex.tets;
  std::vector<MeshingMessage> result;
  for (const Below& below : simplices)
    for (const std::size_t from : below.around)
      for (const std::size_t to : below.around)
        if (from != to) result.push_back({numbers[from], numbers[to], 0, 0, digest(tets[from])});
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace tensortopo
