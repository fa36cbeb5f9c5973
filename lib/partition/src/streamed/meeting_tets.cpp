// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "streamed/meeting_tets.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/unmatched_faces.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Kind = MeshDefect::Kind;

[[noreturn]] void refuse(const MeshDefect& defect) {
  const bool is_of_two = defect.kind == Kind::duplicated_cell ||
                         defect.kind == Kind::crowded_face ||
                         defect.kind == Kind::overlapping_cells;
  if (!is_of_two) throw std::invalid_argument(defect.text);
  throw std::invalid_argument("pieces overlap: cell " + std::to_string(defect.where) +
                              " shares a face with two others, or lies on the same side of it as "
                              "another; write pieces without cells of their neighbours");
}

}  // namespace

void MeetingTets::add(const TetMesh& piece, const std::vector<char>& is_outer,
                      const std::vector<std::int64_t>& ids, std::int64_t first_tet) {
  std::vector<char> is_used(piece.points.size(), 0);
  for (std::size_t t = 0; t < piece.tets.size(); ++t) {
    const auto& tet = piece.tets[t];
    const auto outer = [&](Index v) { return is_outer[as_size(v)] != 0; };
    if (std::count_if(tet.begin(), tet.end(), outer) < 3) continue;
    auto& corners = corners_.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = ids[as_size(tet[k])];
      is_used[as_size(tet[k])] = 1;
    }
    tets_.push_back(first_tet + static_cast<std::int64_t>(t));
  }
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0) vertices_.push_back({ids[v], piece.points[v], is_outer[v] != 0});
}

TornFaces MeetingTets::torn_faces() const {
  std::vector<Vertex> vertices = vertices_;
  const auto by_id = [](const Vertex& u, const Vertex& v) { return u.id < v.id; };
  std::sort(vertices.begin(), vertices.end(), by_id);
  vertices.erase(std::unique(vertices.begin(), vertices.end(),
                             [](const Vertex& u, const Vertex& v) { return u.id == v.id; }),
                 vertices.end());
  TetMesh mesh;
  for (const Vertex& v : vertices) mesh.points.push_back(v.point);
  mesh.tensors.resize(mesh.points.size());
  for (const auto& corners : corners_) {
    auto& tet = mesh.tets.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      tet[k] = static_cast<Index>(
          std::lower_bound(vertices.begin(), vertices.end(), Vertex{corners[k], {}, false}, by_id) -
          vertices.begin());
  }
  mesh.cell_ids = tets_;
  std::vector<OuterFace> outer;
  if (const auto defects = validate(mesh, &outer); !defects.empty()) refuse(defects.front());
  const auto has_another = [&](const OuterFace& face) {  // one that is not among these
    return std::any_of(face.vertices.begin(), face.vertices.end(),
                       [&](Index v) { return !vertices[as_size(v)].is_outer; });
  };
  std::erase_if(outer, has_another);
  TornFaces torn = tensortopo::torn_faces(unmatched_faces(mesh, outer), mesh, outer);
  if (torn.count > 0)
    for (auto& face : torn.vertices)
      for (std::int64_t& v : face) v = vertices[as_size(v)].id;
  return torn;
}

}  // namespace tensortopo
