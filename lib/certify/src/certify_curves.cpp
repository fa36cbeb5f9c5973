// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "extract/curves/points/degenerate_points_on_face.hpp"
#include "extract/curves/points/weight_bounds.hpp"
#include "run/for_each.hpp"
#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using FaceVertices = std::array<Index, 3>;

/// Of boxes: narrower ones only where points are nearer to each other.
constexpr int kDepth = 40, kGreatestDepth = 52;

/// result[i] = values[place[i]].
template <class Value>
std::array<Value, 3> permuted(const std::array<Value, 3>& values,
                              const std::array<std::size_t, 3>& place) {
  return {values[place[0]], values[place[1]], values[place[2]]};
}

WeightBounds in_order(const WeightBounds& bounds, const std::array<std::size_t, 3>& place) {
  return {permuted(bounds.low, place), permuted(bounds.high, place)};
}

/// A box that holds the point, as bounded and as rounded.
std::optional<FacePointClaim> box_around(const WeightBounds& bounds,
                                         const std::array<double, 3>& rounded, int depth) {
  FacePointClaim result;
  for (; depth > 0; --depth) {
    bool fits = true;
    result.depth = depth;
    for (std::size_t n = 0; n < 2; ++n) {
      const double low = std::min(bounds.low[n + 1], rounded[n + 1]);
      const double high = std::max(bounds.high[n + 1], rounded[n + 1]);
      const double middle = std::round(std::ldexp((low + high) / 2, depth));
      // Multiplied by powers of two these are exact, and so are comparisons.
      fits = fits && middle >= 0 && std::ldexp(low, depth) >= middle - 1 &&
             std::ldexp(high, depth) <= middle + 1;
      if (fits) result.place[n] = static_cast<std::uint64_t>(middle);
    }
    if (fits) return result;
  }
  return std::nullopt;
}

/// Have boxes of one depth a point in common?
bool meet(const FacePointClaim& p, const FacePointClaim& q) {
  const int depth = std::min(p.depth, q.depth);
  for (std::size_t n = 0; n < 2; ++n) {
    const double distance = std::abs(std::ldexp(static_cast<double>(p.place[n]), -p.depth) -
                                     std::ldexp(static_cast<double>(q.place[n]), -q.depth));
    if (distance > std::ldexp(2.0, -depth)) return false;
  }
  return true;
}

/// The points of a face with boxes around them, in the order in which they were extracted; nothing
/// if they cannot be separated.
class FaceClaims {
 public:
  FaceClaims(const TetMesh& mesh, Degeneracy kind)
      : mesh_(mesh),
        kind_(kind),
        field_(mesh),
        rank_(inverse_permutation(canonical_mesh(mesh).vertices)) {}

  /// @param given  the face's vertices; boxes are of the weights of the second and third of these
  std::optional<std::vector<FacePointClaim>> operator()(const FaceVertices& given) const {
    // Points are extracted with the vertices in canonical order.
    FaceVertices face = given;
    std::sort(face.begin(), face.end(),
              [&](Index u, Index v) { return rank_[as_size(u)] < rank_[as_size(v)]; });
    std::array<std::size_t, 3> place;  // of the given vertices in that order
    for (std::size_t i = 0; i < 3; ++i)
      place[i] =
          static_cast<std::size_t>(std::find(face.begin(), face.end(), given[i]) - face.begin());
    std::array<ScaledTensor, 3> tensors;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = as_size(face[i]);
      tensors[i] = {mesh_.tensors[v], field_.exponents[v]};
    }
    FacePoints found = degenerate_points_on_face(tensors);
    const bool linear = kind_ == Degeneracy::linear;
    std::erase_if(found.points, [&](const FacePoint& point) { return point.linear != linear; });
    std::vector<FacePointClaim> claims;
    for (const int depth : {kDepth, kGreatestDepth}) {
      claims.clear();
      for (const FacePoint& point : found.points) {
        const auto bounds = weight_bounds(tensors, point);
        const auto box = bounds ? box_around(in_order(*bounds, place),
                                             permuted(coordinates(tensors, point), place), depth)
                                : std::nullopt;
        if (!box) return std::nullopt;
        claims.push_back(*box);
      }
      if (are_apart(claims)) return claims;
    }
    return std::nullopt;
  }

 private:
  static bool are_apart(const std::vector<FacePointClaim>& claims) {
    for (std::size_t i = 0; i < claims.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (meet(claims[i], claims[k])) return false;
    return true;
  }
  /// Where the point is in space.
  static std::array<double, 3> coordinates(const std::array<ScaledTensor, 3>& tensors,
                                           const FacePoint& point) {
    int largest = tensors[0].exponent;
    for (const auto& t : tensors) largest = std::max(largest, t.exponent);
    using std::ldexp;
    std::array<Extended, 3> w;
    for (std::size_t i = 0; i < 3; ++i)
      w[i] = ldexp(point.weights[i], tensors[i].exponent - largest);
    const Extended sum = w[0] + w[1] + w[2];
    return {static_cast<double>(w[0] / sum), static_cast<double>(w[1] / sum),
            static_cast<double>(w[2] / sum)};
  }

  const TetMesh& mesh_;
  const Degeneracy kind_;
  const ScaledField<double> field_;
  const std::vector<Index> rank_;  ///< of each vertex, in canonical order
};

/// The vertices of polylines that are inside faces of the mesh, by face, ascending.
std::map<FaceVertices, std::vector<CurveMesh::Index>> vertices_in_faces(const CurveMesh& curves) {
  std::map<FaceVertices, std::vector<CurveMesh::Index>> result;
  for (std::size_t v = 0; v < curves.points.size(); ++v) {
    if (curves.carrier[v] != Carrier::face) continue;
    const auto& c = curves.carrier_vertices[v];
    result[{c[0], c[1], c[2]}].push_back(static_cast<CurveMesh::Index>(v));
  }
  return result;
}

std::vector<CertifiedCurves::Curve> components_of(const CurveMesh& curves) {
  std::vector<CertifiedCurves::Curve> result;
  std::map<CurveMesh::Index, std::pair<std::size_t, std::size_t>> ends;  // component, how many
  for (std::size_t l = 0; l < curves.lines.size(); ++l) {
    const auto& line = curves.lines[l];
    const std::size_t c = as_size(curves.component[l]);
    if (c >= result.size()) result.resize(c + 1, {true, 0, line[0]});
    ++result[c].lines;
    result[c].first_vertex =
        std::min(result[c].first_vertex, *std::min_element(line.begin(), line.end()));
    for (const auto v : {line.front(), line.back()}) ends[v].first = c, ++ends[v].second;
  }
  for (const auto& [v, end] : ends)
    if (end.second == 1) result[end.first].closed = false;
  std::sort(result.begin(), result.end(),
            [](const auto& p, const auto& q) { return p.first_vertex < q.first_vertex; });
  return result;
}

FaceVertices face_of(std::array<Index, 4> tet, std::size_t opposite) {
  std::sort(tet.begin(), tet.end());
  FaceVertices face{};
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != opposite) face[n++] = tet[i];
  return face;
}

}  // namespace

CertifiedCurves certify(const TetMesh& mesh, Degeneracy kind, const CurveExtraction& extraction) {
  const CurveMesh& curves = extraction.curves;
  CertifiedCurves result;
  result.kind = kind;
  result.vertices = curves.points.size();
  result.lines = curves.lines.size();
  result.curves = components_of(curves);

  std::map<Index, std::string> undecided;
  for (const auto* list : {&extraction.special, &extraction.unresolved})
    for (const UnresolvedCurve& cell : *list) undecided[cell.tet] = name_of(cell.obstacle);

  // Faces of tetrahedra that hold lines and are decided.
  const auto in_faces = vertices_in_faces(curves);
  std::map<Index, std::vector<std::size_t>> lines_in;
  for (std::size_t l = 0; l < curves.lines.size(); ++l)
    if (!undecided.contains(curves.tet[l])) lines_in[curves.tet[l]].push_back(l);
  std::set<FaceVertices> met;
  for (const auto& [tet, lines] : lines_in)
    for (std::size_t i = 0; i < 4; ++i)
      if (const auto face = face_of(mesh.tets[as_size(tet)], i); in_faces.contains(face))
        met.insert(face);
  const std::vector<FaceVertices> faces(met.begin(), met.end());
  std::vector<std::optional<std::vector<FacePointClaim>>> claims(faces.size());
  const FaceClaims claims_of(mesh, kind);
  detail::for_each(faces.size(), [&](std::size_t f) { claims[f] = claims_of(faces[f]); });

  std::set<FaceVertices> unclaimed;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& vertices = in_faces.at(faces[f]);
    if (!claims[f] || claims[f]->size() != vertices.size()) {
      unclaimed.insert(faces[f]);
      continue;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) (*claims[f])[i].vertex = vertices[i];
  }
  met.clear();
  for (const auto& [tet, lines] : lines_in) {
    std::array<FaceVertices, 4> around;
    for (std::size_t i = 0; i < 4; ++i) around[i] = face_of(mesh.tets[as_size(tet)], i);
    if (std::any_of(around.begin(), around.end(),
                    [&](const auto& face) { return unclaimed.contains(face); })) {
      undecided[tet] = name_of(CurveObstacle::points_not_told_apart);
      continue;
    }
    met.insert(around.begin(), around.end());
    CertifiedCurves::Tet& claim = result.tets.emplace_back();
    claim.tet = tet;
    for (const std::size_t l : lines) {
      const auto [low, high] = std::minmax(curves.lines[l].front(), curves.lines[l].back());
      claim.pieces.push_back({low, high});
    }
    std::sort(claim.pieces.begin(), claim.pieces.end());
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (met.contains(faces[f])) result.faces.push_back({faces[f], std::move(*claims[f])});
  for (const auto& [tet, reason] : undecided) result.undecided.push_back({tet, reason});
  return result;
}

}  // namespace tensortopo
