// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/regions/arc_loops.hpp"

#include <map>
#include <optional>
#include <utility>

#include "extract/level/exact_tensors.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/regions/closed_curves.hpp"

namespace tensortopo::detail {

namespace {

constexpr int kSeveral = -1;

/// Which loop alone bounds each part of a face that is in the superlevel set.
template <class Scalar>
class LoopsOfFace {
 public:
  LoopsOfFace(const TetWithCurves<Scalar>& tet, std::size_t face, const Level<Scalar>& level,
              const std::vector<int>& loop_of_arc)
      : vertices_(tet.face_vertices[face]), face_(part_of_simplex<3>(tet.simplex, vertices_)) {
    if (!parts_.build(face_, level)) return;
    for (std::size_t a = 0; a < tet.arcs[face].size(); ++a) {
      const auto place = superlevel_place(face_, tet.arcs[face][a], level);
      const auto part = place ? parts_.part_of(*place) : std::nullopt;
      if (!part) return;
      const auto [known, added] = loop_.try_emplace(*part, loop_of_arc[a]);
      if (!added && known->second != loop_of_arc[a]) known->second = kSeveral;
    }
    built_ = true;
  }
  LoopsOfFace(const LoopsOfFace&) = delete;
  LoopsOfFace& operator=(const LoopsOfFace&) = delete;

  std::optional<int> loop_next_to(const DegenerateEnd& end) {
    if (!built_) return std::nullopt;
    const auto part = parts_.part_of(
        {end.weights[vertices_[0]], end.weights[vertices_[1]], end.weights[vertices_[2]]});
    if (!part) return std::nullopt;
    const auto found = loop_.find(*part);
    if (found == loop_.end() || found->second == kSeveral) return std::nullopt;
    return found->second;
  }

 private:
  std::array<std::uint8_t, 3> vertices_;
  LevelSimplex<Scalar, 3> face_;  // `parts_` refers to it
  FaceParts<Scalar> parts_;
  std::map<std::uint32_t, int> loop_;
  bool built_ = false;
};

}  // namespace

template <class Scalar>
std::vector<ArcBetweenLoops> arcs_between_loops(const TetWithCurves<Scalar>& tet,
                                                const Level<Scalar>& level,
                                                const BoundaryLoops& loops) {
  const auto tensors = detail::exact_tensors(tet.simplex);
  auto arcs = degenerate_arcs(tensors, tet.simplex.exponents, level.value);
  if (!arcs) return {};
  std::array<std::vector<int>, 4> loop_of_arc;
  for (std::size_t f = 0; f < 4; ++f) loop_of_arc[f].assign(tet.arcs[f].size(), kSeveral);
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const auto& piece : loops[l])
      loop_of_arc[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)] =
          static_cast<int>(l);
  std::array<std::optional<LoopsOfFace<Scalar>>, 4> faces;
  const auto loop_next_to = [&](const DegenerateEnd& end) {
    const auto f = static_cast<std::size_t>(end.face);
    if (!faces[f]) faces[f].emplace(tet, f, level, loop_of_arc[f]);
    return faces[f]->loop_next_to(end);
  };
  std::vector<ArcBetweenLoops> result;
  for (auto& arc : *arcs) {
    const auto first = loop_next_to(arc.ends[0]), last = loop_next_to(arc.ends[1]);
    if (first && last) result.push_back({std::move(arc), {*first, *last}});
  }
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                      \
  template std::vector<ArcBetweenLoops> arcs_between_loops( \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const BoundaryLoops&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
