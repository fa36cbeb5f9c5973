// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "streamed/piece_index.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "streamed/meeting_tets.hpp"
#include "tensortopo/mesh/point_hash.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// A point on the boundary of a piece.
struct OuterPoint {
  std::int64_t id = 0;
  SymmetricTensor<double> tensor;
  std::vector<std::int32_t> pieces;  ///< that have it, ascending
  bool is_double = false;            ///< its first piece has another in the same place
};

[[noreturn]] void refuse(std::int32_t piece, Index point, const std::string& problem) {
  throw std::invalid_argument("piece " + std::to_string(piece) + ": " + problem + " (point " +
                              std::to_string(point) + ")");
}

void insert(std::vector<std::int32_t>& list, std::int32_t piece) {
  const auto at = std::lower_bound(list.begin(), list.end(), piece);
  if (at == list.end() || *at != piece) list.insert(at, piece);
}

}  // namespace

std::vector<char> outer_vertices(const TetMesh& mesh) {
  std::vector<std::array<Index, 3>> faces;
  faces.reserve(4 * mesh.tets.size());
  std::vector<char> result(mesh.points.size(), 1);
  for (auto v : mesh.tets) {
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0; i < 4; ++i) {
      faces.push_back({v[i == 0 ? 1 : 0], v[i < 2 ? 2 : 1], v[i < 3 ? 3 : 2]});
      result[as_size(v[i])] = 0;
    }
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool is_inner =
        (i > 0 && faces[i - 1] == faces[i]) || (i + 1 < faces.size() && faces[i + 1] == faces[i]);
    if (is_inner) continue;
    for (const Index v : faces[i]) result[as_size(v)] = 1;
  }
  return result;
}

std::vector<std::int64_t> IndexedPiece::point_ids() const {
  std::vector<std::int64_t> ids(points);
  std::int64_t next = first_point;
  for_each_new_point([&](std::size_t v) { ids[v] = next++; });
  for (const auto& [v, id] : known) ids[as_size(v)] = id;
  return ids;
}

detail::PieceIndex::PieceIndex(const PieceSource& source) {
  if (source.pieces < 1) throw std::invalid_argument("a mesh has at least one piece");
  std::unordered_map<Vector3<double>, OuterPoint, PointHash> boundary;
  MeetingTets meeting;
  std::vector<std::vector<bool>> is_outer;  // of the points of each piece
  for (std::int32_t p = 0; p < source.pieces; ++p) {
    const TetMesh mesh = source.read(p);
    const auto is_open = outer_vertices(mesh);
    IndexedPiece piece;
    piece.first_point = points, piece.first_tet = tets;
    piece.points = mesh.points.size(), piece.tets = mesh.tets.size();
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const auto v = static_cast<Index>(i);
      if (is_open[i] == 0) {
        ++points;
        continue;
      }
      const auto [found, is_new] =
          boundary.try_emplace(mesh.points[i], OuterPoint{points, mesh.tensors[i], {p}, false});
      OuterPoint& point = found->second;
      if (is_new) {
        ++points;
        continue;
      }
      if (point.pieces.back() == p) {
        if (point.pieces.size() > 1)
          refuse(p, v, "two points of a piece coincide where pieces meet");
        point.is_double = true;
        ++points;
        continue;
      }
      if (point.is_double) refuse(p, v, "two points of a piece coincide where pieces meet");
      if (point.tensor != mesh.tensors[i])
        refuse(p, v, "pieces give different tensors at the same point");
      for (const std::int32_t other : point.pieces) {
        insert(piece.neighbours, other);
        insert(pieces[as_size(other)].neighbours, p);
      }
      point.pieces.push_back(p);
      piece.known.emplace_back(v, point.id);
    }
    is_outer.emplace_back(is_open.begin(), is_open.end());
    meeting.add(mesh, is_open, piece.point_ids(), piece.first_tet);
    tets += static_cast<std::int64_t>(mesh.tets.size());
    pieces.push_back(std::move(piece));
  }
  for (std::int32_t p = 0; p < source.pieces && source.pieces > 1; ++p) {
    const TetMesh mesh = source.read(p);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      if (!is_outer[as_size(p)][i] && boundary.contains(mesh.points[i]))
        refuse(p, static_cast<Index>(i),
               "a point inside it is a point of another piece, too: pieces overlap, or have points "
               "that their cells do not use; write pieces without those of their neighbours");
  }
  torn_faces = meeting.torn_faces();
}

}  // namespace tensortopo
