// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/merge_points.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/mesh/point_hash.hpp"

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;

/// The vertex at a position, and the last piece that brought a point there.
struct Entry {
  Index vertex;
  std::size_t piece;
  bool shared;   // by two pieces
  bool doubled;  // two points of one piece
};

Vector3<double> point_of(const RawGrid& grid, std::size_t i) {
  const double* c = grid.coordinates.data() + 3 * i;
  if (!std::isfinite(c[0]) || !std::isfinite(c[1]) || !std::isfinite(c[2]))
    throw IoError(IoError::Kind::invalid, grid.file,
                  "a coordinate is not finite (point " + std::to_string(i) +
                      "); take the point out of the mesh, with its cells");
  return {c[0], c[1], c[2]};
}

}  // namespace

VertexMap merge_points(const std::vector<RawGrid>& pieces,
                       const std::vector<std::vector<SymmetricTensor<double>>>& tensors,
                       TetMesh& mesh) {
  const auto refuse = [](const RawGrid& grid, std::size_t i, const std::string& problem) {
    throw IoError(IoError::Kind::invalid, grid.file,
                  problem + " (point " + std::to_string(i) + ")");
  };
  std::size_t total = 0;
  for (const RawGrid& grid : pieces) total += grid.points();
  if (total > INT32_MAX)
    throw IoError(IoError::Kind::invalid, pieces.front().file,
                  "the pieces have " + std::to_string(total) + " points, too many");
  mesh.points.reserve(total);
  if (!tensors.empty()) mesh.tensors.reserve(total);

  VertexMap map(pieces.size());
  std::unordered_map<Vector3<double>, Entry, PointHash> at;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const RawGrid& grid = pieces[k];
    map[k].reserve(grid.points());
    for (std::size_t i = 0; i < grid.points(); ++i) {
      const Vector3<double> p = point_of(grid, i);
      auto vertex = static_cast<Index>(mesh.points.size());
      if (pieces.size() > 1) {
        const auto [found, is_new] = at.try_emplace(p, Entry{vertex, k, false, false});
        Entry& entry = found->second;
        if (!is_new) {
          if (entry.piece == k) entry.doubled = true;
          if (entry.piece != k) entry.shared = true;
          if (entry.doubled && entry.shared)
            refuse(grid, i, "two points of a piece coincide where pieces meet");
          if (entry.piece != k) {
            entry.piece = k, vertex = entry.vertex;
            if (!tensors.empty() && mesh.tensors[static_cast<std::size_t>(vertex)] != tensors[k][i])
              refuse(grid, i, "has another tensor than a piece before it at the same point");
          }
        }
      }
      if (static_cast<std::size_t>(vertex) == mesh.points.size()) {
        mesh.points.push_back(p);
        if (!tensors.empty()) mesh.tensors.push_back(tensors[k][i]);
      }
      map[k].push_back(vertex);
    }
  }
  return map;
}

}  // namespace tensortopo::detail
