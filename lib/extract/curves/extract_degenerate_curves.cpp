// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/extract_degenerate_curves.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "extract/curves/curve_assembly.hpp"
#include "extract/curves/points/degenerate_points_on_face.hpp"
#include "extract/curves/special/degenerate_throughout.hpp"
#include "extract/curves/special_positions.hpp"
#include "extract/level/proofs/screen.hpp"
#include "extract/run/parallel_stage.hpp"
#include "tensortopo/extract/curve_keys.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/renumber.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

std::size_t count_different(std::vector<Index> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

class CurveExtractor {
 public:
  CurveExtractor(const TetMesh& mesh, Degeneracy kind, const ExtractOptions& options)
      : mesh_(mesh), kind_(kind), options_(options), field_(mesh) {}

  KeyedCurves run() {
    Stopwatch watch;
    screen();
    find_face_points();
    SpecialPositions special(mesh_, field_, kind_, options_, cells_);
    special.find();
    result_.statistics.seconds_faces = watch.lap();
    join_in_tets(special);
    result_.statistics.seconds_tets = watch.lap();
    AssembledCurves assembled =
        assemble_curves(mesh_, field_, kind_, cells_.places, links_, options_);
    find_keys(assembled);
    result_.curves = std::move(assembled.curves);
    result_.statistics.tets_crossed = count_different(result_.curves.tet);
    result_.statistics.seconds_stitch = watch.lap();
    return {std::move(result_), std::move(keys_)};
  }

 private:
  /// The Lode angle of the degenerate tensors sought.
  double lode_angle() const { return kind_ == Degeneracy::linear ? 0 : pi<double>() / 3; }

  /// Whether a simplex holds no tensor of the kind sought. A zero deviator adds nothing to the
  /// cone over the others.
  template <class Vertices>
  bool is_screened_out(const Vertices& vertices) const {
    std::array<Deviator<double>, 4> tensors;
    std::size_t count = 0;
    for (const Index v : vertices)
      if (!field_.is_zero[as_size(v)]) tensors[count++] = field_.tensors[as_size(v)];
    if (count == 0) return false;
    const std::size_t given = count;
    while (count < 4) tensors[count] = tensors[count - given], ++count;
    return screen::excludes(tensors, lode_angle());
  }

  template <std::size_t Vertices, class Container>
  std::array<ScaledTensor, Vertices> tensors_at(const Container& vertices) const {
    std::array<ScaledTensor, Vertices> result;
    for (std::size_t i = 0; i < Vertices; ++i) {
      const auto v = as_size(vertices[i]);
      result[i] = {mesh_.tensors[v], field_.exponents[v]};
    }
    return result;
  }

  void screen() {
    std::vector<char> active(mesh_.tets.size(), 0);
    parallel_stage(options_, "screen", mesh_.tets.size(), 4096,
                   [&](std::size_t t) { active[t] = !is_screened_out(mesh_.tets[t]); });
    std::vector<Index> tets;
    for (std::size_t t = 0; t < active.size(); ++t)
      if (active[t]) tets.push_back(static_cast<Index>(t));
    result_.statistics.tets_screened_out = mesh_.tets.size() - tets.size();
    cells_.complex = tet_complex(mesh_, tets);
    find_degenerate_tets();
  }

  /// Tetrahedra without a curve, as all is degenerate, and the faces that none but these have: what
  /// is in such faces concerns nobody.
  void find_degenerate_tets() {
    const auto& complex = cells_.complex;
    is_degenerate_.assign(complex.tets.size(), 0);
    parallel_stage(options_, "screen", complex.tets.size(), 256, [&](std::size_t t) {
      const FloatingPointEnvironment environment;
      is_degenerate_[t] = is_degenerate_throughout(
          tensors_at<4>(mesh_.tets[as_size(complex.tets[t])]), kind_ == Degeneracy::linear);
    });
    is_within_.assign(complex.faces.size(), 0);
    for (std::size_t f = 0; f < complex.faces.size(); ++f)
      is_within_[f] =
          std::all_of(complex.face_tets[f].begin(), complex.face_tets[f].end(),
                      [&](Index t) { return t < 0 || is_degenerate_[as_size(t)] != 0; });
  }

  void find_face_points() {
    const auto& faces = cells_.complex.faces;
    cells_.faces.resize(faces.size());
    std::vector<char> counted(faces.size(), 0);
    parallel_stage(options_, "faces", faces.size(), 256, [&](std::size_t f) {
      if (is_within_[f] != 0 || is_screened_out(faces[f])) return;
      auto& found = cells_.faces[f];
      for (const Index v : faces[f])
        if (field_.is_zero[as_size(v)]) {
          found.obstacle = CurveObstacle::zero_deviator_vertex;
          return;
        }
      counted[f] = 1;
      found = degenerate_points_on_face(tensors_at<3>(faces[f]));
      const bool linear = kind_ == Degeneracy::linear;
      std::erase_if(found.points, [&](const FacePoint& point) { return point.linear != linear; });
      if (!(linear ? found.concerns_linear : found.concerns_planar)) found.obstacle.reset();
    });
    for (std::size_t f = 0; f < faces.size(); ++f) {
      auto& found = cells_.faces[f];
      result_.statistics.faces += counted[f] != 0;
      result_.statistics.faces_exact += found.exact;
      // Of such a face all is found anew.
      if (found.obstacle) found.points.clear();
      cells_.first_place.push_back(cells_.places.size());
      for (const FacePoint& point : found.points) {
        CurvePlace place;
        std::copy(faces[f].begin(), faces[f].end(), place.vertices.begin());
        std::copy(point.weights.begin(), point.weights.end(), place.weights.begin());
        place.dominant = point.dominant;
        cells_.places.push_back(place);
      }
    }
    result_.statistics.face_points = cells_.places.size();
  }

  /// What a tetrahedron in general position holds.
  CellCurves join_in_tet(std::size_t t) const {
    const auto& complex = cells_.complex;
    const auto& vertices = mesh_.tets[as_size(complex.tets[t])];
    std::vector<BoundaryPoint> boundary;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < 4; ++i) {
      const Index f = complex.tet_faces[t][i];
      BoundaryPoint point;
      point.face = i;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = complex.faces[as_size(f)][k];
        point.corners[k] = static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), v) -
                                                    vertices.begin());
      }
      const auto& points = cells_.faces[as_size(f)].points;
      for (std::size_t k = 0; k < points.size(); ++k) {
        point.point = points[k];
        boundary.push_back(point);
        places.push_back(cells_.first_place[as_size(f)] + k);
      }
    }
    auto joined = degenerate_curve_in_tet(tensors_at<4>(vertices), boundary,
                                          options_.sampling.largest_turn());
    CellCurves result;
    result.obstacle = joined.obstacle;
    for (CurvePiece& piece : joined.pieces)
      result.links.push_back({complex.tets[t],
                              vertices,
                              {places[piece.begin], places[piece.end]},
                              std::move(piece.inner)});
    return result;
  }

  void join_in_tets(const SpecialPositions& special) {
    const auto& complex = cells_.complex;
    std::vector<CellCurves> tets(complex.tets.size());
    std::vector<std::optional<CurveObstacle>> reasons(tets.size());
    parallel_stage(options_, "tetrahedra", tets.size(), 256, [&](std::size_t t) {
      if (is_degenerate_[t] != 0) {
        tets[t].obstacle = reasons[t] = CurveObstacle::degenerate_throughout;
        return;
      }
      const auto& faces = complex.tet_faces[t];
      const auto at =
          std::find_if(faces.begin(), faces.end(), [&](Index f) { return special.is_special(f); });
      if (at != faces.end()) {
        reasons[t] = cells_.faces[as_size(*at)].obstacle;
      } else {
        tets[t] = join_in_tet(t);
        reasons[t] = tets[t].obstacle;
      }
      if (reasons[t]) tets[t] = special.curve_in_tet(t);
    });
    const std::size_t shared = cells_.places.size();
    for (std::size_t t = 0; t < tets.size(); ++t) {
      auto& cell = tets[t];
      if (cell.obstacle) result_.unresolved.push_back({complex.tets[t], *cell.obstacle});
      if (reasons[t] && !cell.obstacle) result_.special.push_back({complex.tets[t], *reasons[t]});
      const std::size_t own = cells_.places.size() - shared;
      for (CurveLink& link : cell.links) {
        for (std::size_t& end : link.ends)
          if (end >= shared) end += own;
        links_.push_back(std::move(link));
      }
      cells_.places.insert(cells_.places.end(), cell.places.begin(), cell.places.end());
    }
    auto below = special.lines_below(tets);
    for (CurveLink& link : below.links) links_.push_back(std::move(link));
    keys_.messages = std::move(below.messages);
  }

  /// Places in one simplex follow each other, and so do links.
  void find_keys(const AssembledCurves& assembled) {
    const auto ordinals = [](const auto& all) {
      std::vector<std::int32_t> result(all.size(), 0);
      for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].vertices == all[i - 1].vertices) result[i] = result[i - 1] + 1;
      return result;
    };
    constexpr std::array kinds{CurveVertexKind::on_vertex, CurveVertexKind::on_edge,
                               CurveVertexKind::on_face, CurveVertexKind::in_tet};
    const auto place_ordinal = ordinals(cells_.places), link_ordinal = ordinals(links_);
    for (const std::size_t place : assembled.places) {
      const auto& vertices = cells_.places[place].vertices;
      const auto count = std::find(vertices.begin(), vertices.end(), -1) - vertices.begin();
      keys_.vertices.push_back({place < result_.statistics.face_points ? CurveVertexKind::general
                                                                       : kinds[as_size(count - 1)],
                                place_ordinal[place]});
    }
    for (std::size_t i = 0; i < assembled.inner.size(); ++i) {
      const bool is_first = i == 0 || assembled.inner[i] != assembled.inner[i - 1];
      keys_.vertices.push_back(
          {CurveVertexKind::between_ends, is_first ? 0 : keys_.vertices.back().ordinal + 1});
    }
    for (const CurveStep& step : assembled.steps)
      keys_.lines.push_back({links_[step.link].vertices, link_ordinal[step.link], step.from == 1});
  }

  const TetMesh& mesh_;
  const Degeneracy kind_;
  const ExtractOptions& options_;
  ScaledField<double> field_;
  CurveCells cells_;
  std::vector<char> is_degenerate_;  ///< throughout, of the complex' tetrahedra
  std::vector<char> is_within_;      ///< of the complex' faces: in no others than these
  std::vector<CurveLink> links_;
  CurveExtraction result_;
  CurveKeys keys_;
};

/// To numbers of the mesh given.
void renumber_keys(CurveKeys& keys, const CanonicalMesh& canonical) {
  for (auto& line : keys.lines) {
    const auto end = std::find(line.cell.begin(), line.cell.end(), -1);
    for (auto v = line.cell.begin(); v != end; ++v) *v = canonical.vertices[as_size(*v)];
    std::sort(line.cell.begin(), end);
  }
  for (MeshingMessage& message : keys.messages) {
    message.from = canonical.tets[as_size(message.from)];
    message.to = canonical.tets[as_size(message.to)];
  }
}

}  // namespace

KeyedCurves extract_keyed_curves(const TetMesh& mesh, Degeneracy kind,
                                 const ExtractOptions& options) {
  require_fitting(options, mesh.tets.size());
  const CanonicalMesh canonical = canonical_mesh(mesh);
  KeyedCurves keyed = CurveExtractor(canonical.mesh, kind, options).run();
  CurveExtraction& result = keyed.extraction;
  renumber(result.curves, canonical.vertices, canonical.tets);
  for (auto* list : {&result.unresolved, &result.special}) {
    for (UnresolvedCurve& cell : *list) cell.tet = canonical.tets[as_size(cell.tet)];
    std::sort(list->begin(), list->end(),
              [](const auto& p, const auto& q) { return p.tet < q.tet; });
  }
  renumber_keys(keyed.keys, canonical);
  return keyed;
}

CurveExtraction extract_degenerate_curves(const TetMesh& mesh, Degeneracy kind,
                                          const ExtractOptions& options) {
  return extract_keyed_curves(mesh, kind, options).extraction;
}

}  // namespace tensortopo
