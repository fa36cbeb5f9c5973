// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
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
#include "extract/surface/pipeline.hpp"

namespace tensortopo {

namespace {

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
class BothSides {
 public:
  BothSides(CellPatch* one, CellPatch* two, const Sampling& sampling)
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
  void given(std::vector<CellPatch::Id>& chain, bool closed, std::size_t least) {
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

/// Samples of face curves turn out to be too dense for the triangles beside them: they were needed
/// to spread the sheet out on the manifold, or follow eigenvectors that turn where the level does
/// not. Those that make needles, and that the level can do without, are taken out again.
template <class Scalar>
void Pipeline<Scalar>::coarsen_face_curves() {
  const auto level = make_level<double>(level_.value);
  std::vector<char> has_needle(tets_.size(), 0);
  parallel_stage(options_, "tetrahedra", tets_.size(), 256, [&](std::size_t t) {
    const auto& state = tets_[t];
    if (state.patch.triangles.empty()) return;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = mesh_.points[as_size(vertices_of(t)[i])];
    const double unit = unit_of(points);
    has_needle[t] = std::any_of(
        state.patch.triangles.begin(), state.patch.triangles.end(), [&](const auto& triangle) {
          if (std::any_of(triangle.begin(), triangle.end(), [](Index v) { return v < 0; }))
            return true;  // not known yet
          const auto at = [&](std::size_t i) {
            return unit * boundary_position_[as_size(triangle[i])];
          };
          const auto p = at(0), q = at(1), r = at(2);
          const auto n = cross(q - p, r - p);
          return !(least_sine(p, q, r, length(n)) > kNeedle);
        });
  });
  const auto may_change = [&](Index t) {
    const auto& state = tets_[as_size(t)];
    return !state.unresolved && state.method != Method::cone && state.level == nullptr;
  };
  // Colours: no two faces of one tetrahedron in one, so that each may change its tetrahedra.
  std::vector<std::vector<std::size_t>> colours;
  std::vector<std::uint32_t> taken(tets_.size(), 0);
  for (std::size_t f = 0; f < complex_.faces.size(); ++f) {
    if (!arcs_[f] || face_moved_[f]) continue;
    if (std::all_of(arcs_[f]->begin(), arcs_[f]->end(),
                    [](const auto& arc) { return arc.samples.empty(); }))
      continue;
    std::uint32_t used = 0;
    bool any = false, all = true;
    for (const Index t : complex_.face_tets[f]) {
      if (t < 0) continue;
      used |= taken[as_size(t)];
      any |= has_needle[as_size(t)] != 0;
      all &= may_change(t);
    }
    if (!any || !all) continue;
    const auto colour = static_cast<std::size_t>(std::countr_one(used));
    for (const Index t : complex_.face_tets[f])
      if (t >= 0) taken[as_size(t)] |= 1u << colour;
    if (colour == colours.size()) colours.emplace_back();
    colours[colour].push_back(f);
  }
  std::vector<std::unique_ptr<CellPatch>> patch(tets_.size());
  parallel_stage(options_, "tetrahedra", tets_.size(), 64, [&](std::size_t t) {
    if (taken[t] == 0) return;
    const auto tet = tet_with_curves(t);
    patch[t] = std::make_unique<CellPatch>(tet, level, arc_vertices(t, tet), tets_[t].patch);
  });
  for (const auto& faces : colours)
    parallel_stage(options_, "tetrahedra", faces.size(), 16, [&](std::size_t k) {
      const auto f = faces[k];
      const auto side = [&](std::size_t i) {
        const Index t = complex_.face_tets[f][i];
        return t < 0 ? nullptr : patch[as_size(t)].get();
      };
      BothSides sides(side(0), side(1), sampling_on(f));
      auto next = face_vertex_[f];
      for (const auto& arc : *arcs_[f]) {
        const auto end = [&](const ArcEnd& e) {
          return edge_vertex_[as_size(complex_.face_edges[f][static_cast<std::size_t>(e.edge)])] +
                 static_cast<Index>(e.crossing);
        };
        std::vector<CellPatch::Id> chain;
        if (!arc.closed) chain.push_back(end(arc.begin));
        for (std::size_t i = 0; i < arc.samples.size(); ++i) chain.push_back(next++);
        if (!arc.closed) chain.push_back(end(arc.end));
        // Two curves never share both ends, so that one without samples is an edge of its own.
        sides.given(chain, arc.closed, arc.closed ? 3 : arc.begin.edge == arc.end.edge ? 1 : 0);
      }
    });
  parallel_stage(options_, "tetrahedra", tets_.size(), 64, [&](std::size_t t) {
    if (patch[t]) tets_[t].patch.triangles = patch[t]->triangles();
  });
}

#define TENSORTOPO_INSTANTIATE(Scalar) template void Pipeline<Scalar>::coarsen_face_curves();
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
