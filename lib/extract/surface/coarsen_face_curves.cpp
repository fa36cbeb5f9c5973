// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/coarsen_face_curves.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "extract/patch/quality/cell_patch.hpp"
#include "extract/patch/quality/least_sine.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/trace_faces.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// A sample is taken out only if a triangle at it is a needle (sine of its least angle), and if the
/// least angle then is so much larger.
constexpr double kNeedle = 0.26, kWider = 1.05;

/// How far the level may be from where a sample was taken out, in longest edges of the tetrahedron.
/// On the bundled fields the mean distance from the level grows by one hundredth, or less.
double flatness(const Sampling& sampling) {
  return 1 / (16 * sampling.resolution * sampling.resolution);
}

/// By how much triangles may turn away from the level there: a thin tube keeps its corners.
double least_cosine(const Sampling& sampling) {
  return std::cos(std::min(3 / sampling.resolution, 0.75));
}

/// The triangles on the two sides of a face.
class FacePatches {
 public:
  FacePatches(CellPatch* one, CellPatch* two, const Sampling& sampling)
      : sides_{one, two}, flatness_(flatness(sampling)), least_cosine_(least_cosine(sampling)) {}

  double least_sine_around(CellPatch::Id v) const {
    double sine = 1;
    for (const auto* side : sides_)
      if (side != nullptr) sine = std::min(sine, side->least_sine_around(v));
    return sine;
  }

  /// The sine of the least angle around v if it goes to a neighbour; 0 if it may not, or if that
  /// is below `least`.
  double least_sine_after(CellPatch::Id v, CellPatch::Id u, double least) const {
    double sine = 1;
    for (auto* side : sides_)
      if (side != nullptr && sine > 0)
        sine = std::min(sine, side->least_sine_after(v, u, least, least_cosine_));
    return sine;
  }

  bool stays_close(CellPatch::Id v, CellPatch::Id u) const {
    return std::all_of(sides_.begin(), sides_.end(), [&](const CellPatch* side) {
      if (side == nullptr) return true;
      const double offset = side->offset_after(v, u);
      return offset <= flatness_ || offset <= side->offset_around(v);
    });
  }

  void move(CellPatch::Id v, CellPatch::Id u) {
    for (auto* side : sides_)
      if (side != nullptr) side->move(v, u);
  }

  /// Takes samples out of a curve, in passes along it until none is left to take.
  /// @param chain its vertices, with its ends unless it is closed
  /// @param least how many samples stay
  void coarsen(std::vector<CellPatch::Id>& chain, bool closed, std::size_t least) {
    const std::size_t ends = closed ? 0 : 1;
    for (bool any = true; any;) {
      any = false;
      for (std::size_t i = ends; i + ends < chain.size() && chain.size() > least + 2 * ends;) {
        const auto v = chain[i];
        const double sine = least_sine_around(v);
        if (sine > kNeedle) {
          ++i;
          continue;
        }
        const std::size_t n = chain.size();
        struct Way {
          double sine;
          CellPatch::Id to;
        };
        std::array<Way, 2> ways;
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
          const auto u = chain[(i + (k == 0 ? n - 1 : 1)) % n];
          ways[k] = {least_sine_after(v, u, kWider * sine), u};
        }
        if (ways[0].sine < ways[1].sine) std::swap(ways[0], ways[1]);
        const auto way = std::find_if(ways.begin(), ways.end(), [&](const Way& w) {
          return w.sine > 0 && stays_close(v, w.to);
        });
        if (way == ways.end()) {
          ++i;
          continue;
        }
        move(v, way->to);
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i));
        any = true;
      }
    }
  }

 private:
  std::array<CellPatch*, 2> sides_;
  double flatness_, least_cosine_;
};

}  // namespace

template <class Scalar>
void coarsen_face_curves(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                         const TetComplex& cells, std::span<const CellProof<Scalar>> proofs,
                         CellMeshes<Scalar>& meshes) {
  const auto& boundary = meshes.boundary;
  const auto& numbers = meshes.vertices;
  const std::size_t count = meshes.cells.size();
  const auto level = make_level<double>(input.level.value);
  std::vector<char> has_needle(count, 0);
  parallel_stage(input.options, "tetrahedra", count, 256, [&](std::size_t t) {
    const auto& mesh = meshes.cells[t];
    if (mesh.patch.triangles.empty()) return;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i)
      points[i] = input.mesh.points[as_size(input.vertices_of(cells, t)[i])];
    const double unit = unit_of(points);
    has_needle[t] = std::any_of(
        mesh.patch.triangles.begin(), mesh.patch.triangles.end(), [&](const auto& triangle) {
          if (std::any_of(triangle.begin(), triangle.end(), [](Index v) { return v < 0; }))
            return true;  // not known yet
          const auto at = [&](std::size_t i) {
            return unit * numbers.position[as_size(triangle[i])];
          };
          const auto p = at(0), q = at(1), r = at(2);
          const auto n = cross(q - p, r - p);
          return !(least_sine(p, q, r, length(n)) > kNeedle);
        });
  });
  const auto may_change = [&](Index t) {
    const auto& mesh = meshes.cells[as_size(t)];
    return !mesh.unresolved && mesh.mesher != Mesher::cone && proofs[as_size(t)].level == nullptr;
  };
  // Colours: no two faces of one tetrahedron in one, so that each may change its tetrahedra.
  std::vector<std::vector<std::size_t>> colours;
  std::vector<std::uint32_t> taken(count, 0);
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    const auto arcs = boundary.arcs[f];
    if (boundary.moved[f]) continue;
    if (std::all_of(arcs.begin(), arcs.end(), [](const auto& arc) { return arc.samples.empty(); }))
      continue;
    std::uint32_t used = 0;
    bool any = false, all = true;
    for (const Index t : cells.face_tets[f]) {
      if (t < 0) continue;
      used |= taken[as_size(t)];
      any |= has_needle[as_size(t)] != 0;
      all &= may_change(t);
    }
    if (!any || !all) continue;
    const auto colour = static_cast<std::size_t>(std::countr_one(used));
    for (const Index t : cells.face_tets[f])
      if (t >= 0) taken[as_size(t)] |= 1u << colour;
    if (colour == colours.size()) colours.emplace_back();
    colours[colour].push_back(f);
  }
  std::vector<std::unique_ptr<CellPatch>> patches(count);
  parallel_stage(input.options, "tetrahedra", count, 64, [&](std::size_t t) {
    if (taken[t] == 0) return;
    const auto tet = tet_with_curves(input, sides, cells, boundary, t);
    const CellSurroundings<Scalar> around{cells, boundary, numbers, t};
    patches[t] =
        std::make_unique<CellPatch>(tet, level, around.arc_vertices(tet), meshes.cells[t].patch);
  });
  for (const auto& faces : colours)
    parallel_stage(input.options, "tetrahedra", faces.size(), 16, [&](std::size_t k) {
      const auto f = faces[k];
      const auto side = [&](std::size_t i) {
        const Index t = cells.face_tets[f][i];
        return t < 0 ? nullptr : patches[as_size(t)].get();
      };
      FacePatches around(side(0), side(1), input.sampling_on(cells, f));
      auto next = numbers.of_face[f];
      for (const auto& arc : boundary.arcs[f]) {
        const auto end = [&](const ArcEnd& e) {
          const auto edge = as_size(cells.face_edges[f][as_size(e.edge)]);
          return static_cast<Index>(boundary.crossings.rows.first(edge)) + e.crossing;
        };
        std::vector<CellPatch::Id> chain;
        if (!arc.closed) chain.push_back(end(arc.begin));
        for (std::size_t i = 0; i < arc.samples.size(); ++i) chain.push_back(next++);
        if (!arc.closed) chain.push_back(end(arc.end));
        // Two curves never share both ends, so that one without samples is an edge of its own.
        around.coarsen(chain, arc.closed, arc.closed ? 3 : arc.begin.edge == arc.end.edge ? 1 : 0);
      }
    });
  parallel_stage(input.options, "tetrahedra", count, 64, [&](std::size_t t) {
    if (patches[t]) meshes.cells[t].patch.triangles = patches[t]->triangles();
  });
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                     \
  template void coarsen_face_curves(const SurfaceInput<Scalar>&, const VertexSides&,       \
                                    const TetComplex&, std::span<const CellProof<Scalar>>, \
                                    CellMeshes<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
