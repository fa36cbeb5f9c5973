// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/extract_degenerate_curves.hpp"

#include <algorithm>
#include <utility>

#include "curve_assembly.hpp"
#include "parallel_stage.hpp"
#include "tensortopo/extract/screen.hpp"
#include "tensortopo/scalar/constants.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

std::size_t as_size(Index i) { return static_cast<std::size_t>(i); }

class CurveExtractor {
 public:
  CurveExtractor(const TetMesh& mesh, Degeneracy kind, const ExtractOptions& options)
      : mesh_(mesh), kind_(kind), options_(options), field_(mesh) {}

  CurveExtraction run() {
    Stopwatch watch;
    screen();
    find_face_points();
    result_.statistics.seconds_faces = watch.lap();
    join_in_tets();
    result_.statistics.seconds_tets = watch.lap();
    result_.curves = assemble_curves(mesh_, field_, kind_, parts_, options_);
    result_.statistics.seconds_stitch = watch.lap();
    return std::move(result_);
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
    parts_.complex = tet_complex(mesh_, tets);
  }

  void find_face_points() {
    const auto& faces = parts_.complex.faces;
    parts_.faces.resize(faces.size());
    std::vector<char> counted(faces.size(), 0);
    parallel_stage(options_, "faces", faces.size(), 256, [&](std::size_t f) {
      if (is_screened_out(faces[f])) return;
      auto& found = parts_.faces[f];
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
      result_.statistics.faces += counted[f] != 0;
      result_.statistics.faces_exact += parts_.faces[f].exact;
      result_.statistics.face_points += parts_.faces[f].points.size();
    }
  }

  void join_in_tets() {
    const auto& complex = parts_.complex;
    parts_.tets.resize(complex.tets.size());
    parts_.rims.resize(complex.tets.size());
    parallel_stage(options_, "tetrahedra", complex.tets.size(), 256, [&](std::size_t t) {
      auto& joined = parts_.tets[t];
      for (const Index f : complex.tet_faces[t])
        if (const auto& obstacle = parts_.faces[as_size(f)].obstacle) {
          joined.obstacle = obstacle;
          return;
        }
      const auto& vertices = mesh_.tets[as_size(complex.tets[t])];
      std::vector<RimPoint> rim;
      for (std::size_t i = 0; i < 4; ++i) {
        const Index f = complex.tet_faces[t][i];
        RimPoint point;
        point.face = i;
        for (std::size_t k = 0; k < 3; ++k) {
          const Index v = complex.faces[as_size(f)][k];
          point.corners[k] = static_cast<std::size_t>(
              std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
        }
        const auto& points = parts_.faces[as_size(f)].points;
        for (std::size_t k = 0; k < points.size(); ++k) {
          point.point = points[k];
          rim.push_back(point);
          parts_.rims[t].push_back({f, k});
        }
      }
      joined =
          degenerate_curve_in_tet(tensors_at<4>(vertices), rim, options_.sampling.largest_turn());
    });
    for (std::size_t t = 0; t < complex.tets.size(); ++t) {
      const auto& joined = parts_.tets[t];
      if (joined.obstacle) result_.unresolved.push_back({complex.tets[t], *joined.obstacle});
      result_.statistics.tets_crossed += !joined.pieces.empty();
    }
  }

  const TetMesh& mesh_;
  const Degeneracy kind_;
  const ExtractOptions& options_;
  ScaledField<double> field_;
  CurveParts parts_;
  CurveExtraction result_;
};

}  // namespace

CurveExtraction extract_degenerate_curves(const TetMesh& mesh, Degeneracy kind,
                                          const ExtractOptions& options) {
  return CurveExtractor(mesh, kind, options).run();
}

}  // namespace tensortopo
