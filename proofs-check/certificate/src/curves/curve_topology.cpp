// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curves/curve_topology.hpp"

#include <algorithm>

#include "run/parallel.hpp"

namespace certificate {
namespace {

/// Is a simplex free of the kind, by its vertices' tensors alone? Those that are zero add nothing.
template <class Vertices>
bool is_free(const Field& field, const Vertices& vertices, Kind kind) {
  std::array<const Tensor<Ball>*, 4> corners{};
  std::size_t count = 0;
  for (const Vertex v : vertices)
    if (!field.is_zero(v)) corners.at(count++) = field.corner(v, false).ball;
  return count > 0 && is_free(std::span(corners).first(count), kind);
}

template <class Vertices>
auto corners_of(const Field& field, const Vertices& vertices) {
  std::array<Corner, std::tuple_size_v<Vertices>> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = field.corner(vertices[i], false);
  return corners;
}

CurveTet derive_tet(const CurveTopology& known, const Input& input, const Field& field, Kind kind,
                    std::uint32_t t) {
  CurveTet result;
  result.tet = t;
  std::vector<BoundaryPoint> boundary;
  std::vector<MeshPoint> names;
  for (std::size_t i = 0; i < 4; ++i) {
    const CurveFace* const face = known.face(without(input.tets[t], i));
    if (face == nullptr) continue;
    if (!face->is_decided()) return result;
    for (std::size_t n = 0; n < face->level.points.size(); ++n) {
      boundary.push_back({i, face->level.points[n]});
      names.push_back({face->vertices, n});
    }
  }
  const auto pieces = joined_in_tet(corners_of(field, input.tets[t]), std::move(boundary), kind);
  if (!pieces) return result;
  result.decided = true;
  for (const auto& [from, to] : *pieces) result.pieces.push_back({names[from], names[to]});
  return result;
}

}  // namespace

const CurveFace* CurveTopology::face(const std::array<Vertex, 3>& vertices) const {
  const auto place =
      std::lower_bound(faces.begin(), faces.end(), vertices,
                       [](const CurveFace& face, const auto& key) { return face.vertices < key; });
  return place == faces.end() || place->vertices != vertices ? nullptr : &*place;
}

CurveTopology derive_curves(const Input& input, const Field& field, Kind kind,
                            const std::vector<bool>& left_out, const Progress& progress) {
  CurveTopology result;
  const std::size_t count = input.tets.size();
  std::vector<char> is_open(count, 0);
  parallel_for(
      count,
      [&](std::size_t t) { is_open[t] = !left_out[t] && !is_free(field, input.tets[t], kind); },
      progress, "tetrahedra without degenerate tensors");
  std::vector<std::array<Vertex, 3>> keys;
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t i = 0; i < 4 && is_open[t] != 0; ++i)
      keys.push_back(without(input.tets[t], i));
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());

  std::vector<FacePoints> found(keys.size());
  parallel_for(
      keys.size(),
      [&](std::size_t f) {
        if (is_free(field, keys[f], kind)) return;
        const auto& [a, b, c] = keys[f];
        if (field.is_zero(a) || field.is_zero(b) || field.is_zero(c))
          found[f].decided = false;
        else
          found[f] = points_in_face(corners_of(field, keys[f]), kind);
      },
      progress, "degenerate points of faces");
  for (std::size_t f = 0; f < keys.size(); ++f) {
    ++(found[f].by_integers ? result.by_integers : result.by_balls);
    if (!found[f].decided || !found[f].points.empty())
      result.faces.push_back({keys[f], std::move(found[f])});
  }

  // Curves inside a tetrahedron meet its boundary.
  std::vector<std::uint32_t> tets;
  for (std::size_t t = 0; t < count; ++t) {
    bool is_met = false;
    for (std::size_t i = 0; i < 4 && is_open[t] != 0 && !is_met; ++i)
      is_met = result.face(without(input.tets[t], i)) != nullptr;
    if (is_met) tets.push_back(static_cast<std::uint32_t>(t));
  }
  result.tets.resize(tets.size());
  parallel_for(
      tets.size(),
      [&](std::size_t i) { result.tets[i] = derive_tet(result, input, field, kind, tets[i]); },
      progress, "curves in tetrahedra");
  result.by_integers += tets.size();
  return result;
}

}  // namespace certificate
