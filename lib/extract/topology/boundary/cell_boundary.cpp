// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/cell_boundary.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>

#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
CrossingKey crossing_of(const TetWithCurves<Scalar>& tet, int face, const ArcEnd& end) {
  constexpr int ends[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  const auto& v = tet.face_vertices[static_cast<std::size_t>(face)];
  return {tet_edge(v[static_cast<std::size_t>(ends[end.edge][0])],
                   v[static_cast<std::size_t>(ends[end.edge][1])]),
          end.crossing};
}

template <class Scalar>
bool join_arcs(const TetWithCurves<Scalar>& tet, BoundaryLoops& loops) {
  struct Leaving {
    CrossingKey begin, end;
    BoundaryArc piece;
    bool used;
  };
  boost::container::small_vector<Leaving, 8> leaving;  // by crossing; few
  std::size_t count = 0;
  for (const auto& arcs : tet.arcs) count += arcs.size();
  leaving.reserve(count);
  for (int f = 0; f < 4; ++f) {
    const auto& arcs = tet.arcs[static_cast<std::size_t>(f)];
    for (std::size_t a = 0; a < arcs.size(); ++a) {
      // On a face seen from outside the larger mode is to the left of an arc; the sheet, whose
      // normal points there, then lies to the left of the arc seen from that normal.
      const BoundaryArc piece{f, static_cast<int>(a), tet.outward[static_cast<std::size_t>(f)]};
      if (arcs[a].closed) {
        loops.push_back({piece});
        continue;
      }
      leaving.push_back({crossing_of(tet, f, piece.forward ? arcs[a].begin : arcs[a].end),
                         crossing_of(tet, f, piece.forward ? arcs[a].end : arcs[a].begin), piece,
                         false});
    }
  }
  const auto before = [](const Leaving& a, const CrossingKey& key) { return a.begin < key; };
  std::sort(leaving.begin(), leaving.end(),
            [&](const Leaving& a, const Leaving& b) { return before(a, b.begin); });
  const auto next = [&](const CrossingKey& key) {
    const auto found = std::lower_bound(leaving.begin(), leaving.end(), key, before);
    return found != leaving.end() && found->begin == key ? found : leaving.end();
  };
  // As many arrive as leave: one at each crossing, if every end is found and none twice.
  for (std::size_t i = 0; i + 1 < leaving.size(); ++i)
    if (leaving[i].begin == leaving[i + 1].begin) return false;
  for (const auto& arc : leaving) {
    const auto found = next(arc.end);
    if (found == leaving.end() || found->used) return false;
    found->used = true;
  }
  for (auto& arc : leaving) arc.used = false;
  for (auto start = leaving.begin(); start != leaving.end(); ++start) {
    if (start->used) continue;
    BoundaryLoop loop;
    loop.reserve(leaving.size());
    for (auto at = start; !at->used; at = next(at->end)) {
      at->used = true;
      loop.push_back(at->piece);
    }
    loops.push_back(std::move(loop));
  }
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                \
  template CrossingKey crossing_of(const TetWithCurves<Scalar>&, int, const ArcEnd&); \
  template bool join_arcs(const TetWithCurves<Scalar>&, BoundaryLoops&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
