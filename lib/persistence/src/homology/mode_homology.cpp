// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/mode_homology.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "homology/betti_intervals.hpp"
#include "homology/curve_shape.hpp"
#include "homology/doubtful_ranges.hpp"
#include "homology/mesh_boundary.hpp"
#include "homology/outside_tree.hpp"
#include "tensortopo/persistence/loop_pairs.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {
namespace {

using namespace persistence;

/// How many components end at each merge.
std::vector<std::size_t> deaths_at(const MergeTree& tree, const std::vector<MergePair>& pairs) {
  std::vector<std::size_t> deaths(tree.merges.size(), 0);
  for (const MergePair& pair : pairs)
    if (pair.merge) ++deaths[*pair.merge];
  return deaths;
}

/// Whether each merge by which components meet, or may, is apart from all others that join nothing,
/// and the other way round.
std::vector<char> ties_of(const MergeTree& tree, const std::vector<std::size_t>& deaths) {
  // Sorted by the middles, whatever the widths: enclosures that overlap are looked for on both
  // sides, as far as the widest reaches.
  double widest = 0;
  for (const ModeMerge& merge : tree.merges)
    widest = std::max(widest, merge.mode.high - merge.mode.low);
  const auto& merges = tree.merges;
  const auto has_loops = [&](std::size_t i) {
    return merges[i].is_proved && deaths[i] + 1 < merges[i].reached.size();
  };
  std::vector<char> is_tie(merges.size(), 0);
  for (std::size_t i = 0; i < merges.size(); ++i)
    for (std::size_t j = i + 1; j < merges.size(); ++j) {
      if (merges[i].mode.middle() - merges[j].mode.middle() > widest) break;
      if (!merges[i].mode.overlaps(merges[j].mode)) continue;
      if ((has_loops(i) && deaths[j] > 0) || (has_loops(j) && deaths[i] > 0))
        is_tie[i] = is_tie[j] = 1;
    }
  return is_tie;
}

/// The homology of {mode >= m}, or of {mode <= m}.
class Side {
 public:
  Side(std::size_t side, const PersistenceInput& input, const std::array<CurveShapes, 2>& shapes,
       const MeshBoundary& boundary)
      : side_(side),
        input_(input),
        shapes_(shapes),
        boundary_(boundary),
        tree_(input.trees[side]),
        outside_(
            outside_tree(input.trees[1 - side], input.values, shapes[1 - side].shapes, boundary)),
        above_(above_points(input.trees[side])),
        below_(above_points(input.trees[1 - side])) {}

  void add_to(ModeHomology& result) {
    add_components(result);
    add_voids(result);
    if (is_known(result)) pair_loops(result);
    const std::size_t first = result.loops.size() - loops_;
    std::stable_sort(result.loops.begin() + static_cast<std::ptrdiff_t>(first), result.loops.end(),
                     [&](const LoopEvent& a, const LoopEvent& b) {
                       const double x = a.mode.middle(), y = b.mode.middle();
                       return side_ == 0 ? x > y : x < y;
                     });
    changes_.falls = side_ == 0;
    changes_.mesh = boundary_.betti();
    for (const ModeRange& range : doubtful_ranges(tree_)) changes_.doubts[0].push_back(own(range));
    for (const ModeRange& range : doubtful_ranges(outside_.tree))
      changes_.doubts[1].push_back(other(range));
    for (const ModeMerge& merge : tree_.merges)
      if (!merge.is_proved) add_open(merge, own(merge.mode), false);
    for (const ModeMerge& merge : outside_.tree.merges)
      if (!merge.is_proved) {
        add_open(merge, other(merge.mode), true);
        ++result.not_proved[side_];
      }
    std::array<long, 3> sum{};
    for (const BettiChange& change : changes_.changes)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += change.by[k];
    result.adds_up[side_] = sum == changes_.mesh;
    // If nothing is in doubt and it does not add up, a change is missing.
    const bool is_in_doubt = !changes_.doubts[0].empty() || !changes_.doubts[1].empty();
    changes_.is_known = is_known(result) && (is_in_doubt || result.adds_up[side_]);
    result.betti[side_] = betti_intervals(changes_);
  }

 private:
  /// Modes of this side's merge tree, and of the other's, as the field has them.
  ModeRange own(const ModeRange& m) const { return side_ == 0 ? m : ModeRange{-m.high, -m.low}; }
  ModeRange other(const ModeRange& m) const { return side_ == 0 ? ModeRange{-m.high, -m.low} : m; }

  using Member = std::optional<std::size_t>;

  /// A maximum above a critical point, in a merge tree.
  static std::unordered_map<std::size_t, std::size_t> above_points(const MergeTree& tree) {
    std::unordered_map<std::size_t, std::size_t> above;
    for (const auto* list : {&tree.merges, &tree.others})
      for (const ModeMerge& merge : *list)
        if (!merge.reached.empty()) above[merge.point] = merge.reached[0];
    return above;
  }
  Member member_at(std::size_t point) const {
    const auto found = above_.find(point);
    return found == above_.end() ? Member() : found->second;
  }
  Member outside_member_at(std::size_t point) const {
    if (const auto surface = boundary_.surface_of(input_.values.points[point].vertices))
      return surface;
    const auto found = below_.find(point);
    return found == below_.end() ? Member() : outside_.member[found->second];
  }

  LoopEvent at_point(std::size_t point, TetMesh::Index tet) const {
    LoopEvent event;
    event.point = point;
    event.place = input_.values.points[point].point;
    event.tet = tet;
    return event;
  }
  static LoopEvent at_curve(const ModeMaximum& curve) {
    LoopEvent event;
    event.curve = curve.curve;
    event.place = curve.point;
    event.tet = curve.tet;
    return event;
  }

  void add_loops(ModeHomology& result, LoopEvent event, const ModeRange& mode, std::size_t count,
                 bool is_birth, const std::array<Member, 2>& members) {
    if (count == 0) return;
    LoopChange change;
    change.count = count;
    change.event = result.loops.size();
    // Curves have numbers after the points.
    change.point = event.point.value_or(input_.values.points.size() + event.curve.value_or(0));
    for (std::size_t i = 0; i < 2; ++i) {
      change.mode = i == 0 ? own(mode) : other(mode);
      change.is_birth = is_birth == (i == 0);
      change.member = members[i];
      loop_changes_[i].push_back(change);
    }
    event.kind = side_ == 0 ? PairKind::superlevel : PairKind::sublevel;
    event.is_birth = is_birth;
    event.mode = mode;
    event.count = count;
    result.loops.push_back(event);
    ++loops_;
    changes_.changes.push_back(
        {mode, {0, is_birth ? static_cast<long>(count) : -static_cast<long>(count), 0}});
  }

  void add_components(ModeHomology& result) {
    for (std::size_t i = 0; i < tree_.maxima.size(); ++i) {
      const ModeMaximum& maximum = tree_.maxima[i];
      changes_.changes.push_back({own(maximum.mode), {1, 0, 0}});
      if (maximum.curve)
        add_loops(result, at_curve(maximum), own(maximum.mode),
                  static_cast<std::size_t>(shapes_[side_].shapes[*maximum.curve].loops), true,
                  {i, std::nullopt});
    }
    const auto deaths = deaths_at(tree_, persistence_pairs(tree_));
    const auto is_tie = ties_of(tree_, deaths);
    for (std::size_t i = 0; i < tree_.merges.size(); ++i) {
      const ModeMerge& merge = tree_.merges[i];
      if (!merge.is_proved) continue;
      changes_.changes.push_back({own(merge.mode), {-static_cast<long>(deaths[i]), 0, 0}});
      LoopEvent event = at_point(merge.point, merge.tet);
      event.is_tie = is_tie[i] != 0;
      add_loops(result, event, own(merge.mode), merge.reached.size() - 1 - deaths[i], true,
                {merge.reached[0], outside_member_at(merge.point)});
    }
  }

  void add_voids(ModeHomology& result) {
    const MergeTree& tree = outside_.tree;
    const MergeTree& opposite_tree = input_.trees[1 - side_];
    const auto pairs = persistence_pairs(tree);
    const auto deaths = deaths_at(tree, pairs);
    const auto is_tie = ties_of(tree, deaths);
    for (std::size_t i = 0; i < tree.merges.size(); ++i) {
      const ModeMerge& merge = tree.merges[i];
      if (!merge.is_proved) continue;
      changes_.changes.push_back({other(merge.mode), {0, 0, static_cast<long>(deaths[i])}});
      const auto& curve = outside_.curves[i];
      LoopEvent event =
          curve ? at_curve(opposite_tree.maxima[*curve]) : at_point(merge.point, merge.tet);
      event.is_tie = is_tie[i] != 0;
      add_loops(result, event, other(merge.mode), merge.reached.size() - 1 - deaths[i], false,
                {curve ? Member() : member_at(merge.point), merge.reached[0]});
    }
    for (std::size_t i = 0; i < opposite_tree.maxima.size(); ++i) {
      const ModeMaximum& maximum = opposite_tree.maxima[i];
      if (maximum.curve)
        add_loops(result, at_curve(maximum), other(maximum.mode),
                  static_cast<std::size_t>(shapes_[1 - side_].shapes[*maximum.curve].loops), false,
                  {std::nullopt, outside_.member[i]});
      if (!outside_.is_outside(i)) changes_.changes.push_back({other(maximum.mode), {0, 0, -1}});
    }
    for (const MergePair& pair : pairs) {
      if (!pair.merge) continue;
      const ModeMerge& merge = tree.merges[*pair.merge];
      const ModeMaximum& maximum = tree.maxima[pair.maximum];
      PersistencePair made;
      made.dimension = 2;
      made.kind = side_ == 0 ? PairKind::superlevel : PairKind::sublevel;
      made.birth = other(merge.mode);
      const auto& curve = outside_.curves[*pair.merge];
      made.birth_point =
          curve ? opposite_tree.maxima[*curve].point : input_.values.points[merge.point].point;
      made.birth_tet = merge.tet;
      made.is_tie = pair.is_tie;
      made.is_certain = pair.is_certain && result.isotropic_vertices == 0;
      made.is_lasting = pair.maximum < outside_.surfaces;
      made.has_death = !made.is_lasting;
      if (made.is_lasting) {
        made.death = end_of(made.kind);
      } else {
        made.death = other(maximum.mode);
        made.death_point = maximum.point;
        made.death_tet = maximum.tet;
        made.curve = maximum.curve;
      }
      result.pairs.push_back(made);
    }
  }

  static bool is_known(const ModeHomology& result) {
    return result.isotropic_vertices == 0 && result.has_known_curves;
  }

  /// Notes what is known of a point all the same: by how much the Euler characteristic grows there,
  /// as loops or as components, or as voids or less loops.
  void add_open(const ModeMerge& merge, const ModeRange& mode, bool is_outside) {
    const MeshCriticalPoint& point = input_.values.points[merge.point];
    if (point.effect.change == LocalChange::undecided) {
      changes_.undecided.push_back(mode);
      return;
    }
    const Verdict rise = side_ == 0 ? Verdict::positive : Verdict::negative;
    const Verdict fall = side_ == 0 ? Verdict::negative : Verdict::positive;
    const auto parts = parts_of_sign(point.link, is_outside ? fall : rise);
    long count = static_cast<long>(parts.size());
    if (is_outside && point.effect.on_boundary) {
      const auto touches = parts_on_boundary(point.link, parts);
      count = 1 + std::count(touches.begin(), touches.end(), 0);
    }
    changes_.changes.push_back({mode, {}, is_outside ? count - 1 : 1 - count});
  }

  /// Notes in which components there may be loops that are not known.
  void add_open_changes() {
    LoopChange change;
    change.is_open = true;
    const auto add = [&](std::size_t i, const ModeMerge& merge, const Member& member) {
      change.mode = i == 0 ? own(other(merge.mode)) : other(own(merge.mode));
      change.point = merge.point;
      change.member = member;
      loop_changes_[i].push_back(change);
    };
    for (const ModeMerge& merge : outside_.tree.merges)
      if (!merge.is_proved) add(0, merge, member_at(merge.point));
    for (const ModeMerge& merge : tree_.merges)
      if (!merge.is_proved) add(1, merge, outside_member_at(merge.point));
  }

  void pair_loops(ModeHomology& result) {
    add_open_changes();
    // Loops outside of the mesh are there from the start.
    std::vector<std::size_t> surfaces;
    for (std::size_t i = 0; boundary_.betti()[1] > 0 && i < outside_.surfaces; ++i)
      surfaces.push_back(i);
    std::map<std::pair<std::size_t, Member>, std::vector<std::size_t>> known;
    for (const LoopPair& pair : loop_pairs(tree_, loop_changes_[0], {}))
      known[{pair.birth, pair.death}].push_back(add_pair(result, pair));
    for (const LoopPair& rising : loop_pairs(outside_.tree, loop_changes_[1], surfaces)) {
      if (!rising.death) continue;
      const LoopPair pair{*rising.death, rising.birth, rising.is_tie};
      auto& same = known[{pair.birth, pair.death}];
      if (!same.empty()) {
        // Proved in two ways, of which one may be apart.
        result.pairs[same.back()].is_tie &= pair.is_tie;
        same.pop_back();
      } else if (is_free(result.loops[pair.birth]) && is_free(result.loops[*pair.death])) {
        add_pair(result, pair);
      }
    }
  }

  /// The end of the modes, to which what lasts does.
  static ModeRange end_of(PairKind kind) {
    return kind == PairKind::superlevel ? ModeRange{-1, -1} : ModeRange{1, 1};
  }

  static bool is_free(const LoopEvent& event) { return event.paired < event.count; }

  static std::size_t add_pair(ModeHomology& result, const LoopPair& pair) {
    LoopEvent& birth = result.loops[pair.birth];
    ++birth.paired;
    PersistencePair made;
    made.dimension = 1;
    made.kind = birth.kind;
    made.birth = birth.mode;
    made.birth_point = birth.place;
    made.birth_tet = birth.tet;
    made.is_tie = pair.is_tie || birth.is_tie;
    made.curve = birth.curve;
    if (pair.death) {
      LoopEvent& death = result.loops[*pair.death];
      ++death.paired;
      made.death = death.mode;
      made.death_point = death.place;
      made.death_tet = death.tet;
      made.is_tie |= death.is_tie;
    } else {
      made.is_lasting = true;
      made.has_death = false;
      made.death = end_of(birth.kind);
    }
    result.pairs.push_back(made);
    return result.pairs.size() - 1;
  }

  std::size_t side_;
  const PersistenceInput& input_;
  const std::array<CurveShapes, 2>& shapes_;
  const MeshBoundary& boundary_;
  const MergeTree& tree_;
  OutsideTree outside_;
  std::unordered_map<std::size_t, std::size_t> above_, below_;
  std::array<std::vector<LoopChange>, 2> loop_changes_;  ///< in the tree, and outside
  std::size_t loops_ = 0;
  BettiChanges changes_;
};

}  // namespace

ModeHomology mode_homology(const TetMesh& mesh, const PersistenceInput& input) {
  ModeHomology result;
  const MeshBoundary boundary(mesh);
  result.mesh_betti = boundary.betti();
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const auto v : tet) is_used[as_size(v)] = 1;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    result.isotropic_vertices += is_used[v] != 0 && deviator(mesh.tensors[v]) == Deviator<double>{};
  const std::array<CurveShapes, 2> shapes{curve_shapes(input.curves[0], boundary),
                                          curve_shapes(input.curves[1], boundary)};
  result.has_known_curves = shapes[0].are_known && shapes[1].are_known;
  for (const CurveExtraction& curves : input.curves)
    result.has_known_curves &= curves.unresolved.empty();
  for (const std::size_t side : {0u, 1u}) Side(side, input, shapes, boundary).add_to(result);
  std::stable_sort(result.pairs.begin(), result.pairs.end(), [](const auto& a, const auto& b) {
    return std::pair(a.dimension, a.kind) < std::pair(b.dimension, b.kind);
  });
  return result;
}

}  // namespace tensortopo
