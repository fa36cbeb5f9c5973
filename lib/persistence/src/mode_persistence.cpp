// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/mode_persistence.hpp"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tensortopo/mesh/union_find.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

/// The mode turned around.
ModeRange opposite(const ModeRange& range) { return {-range.high, -range.low}; }

/// A number for each part of a mesh, of each vertex: parts have no vertex in common.
UnionFind parts_of(const TetMesh& mesh) {
  UnionFind parts(mesh.points.size());
  for (const auto& tet : mesh.tets)
    for (std::size_t i = 1; i < 4; ++i)
      parts.unite(static_cast<std::uint32_t>(tet[0]), static_cast<std::uint32_t>(tet[i]));
  return parts;
}

class Pairing {
 public:
  Pairing(const TetMesh& mesh, const PersistenceInput& input)
      : input_(input), parts_(parts_of(mesh)) {}

  ModePersistence run() {
    for (std::size_t side = 0; side < 2; ++side) add_side(side);
    add_extended();
    for (std::size_t side = 0; side < 2; ++side) {
      result_.unresolved_curve_cells[side] = input_.curves[side].unresolved.size();
      for (const ModeMerge& merge : input_.trees[side].merges)
        if (!merge.is_proved) result_.not_proved[side].push_back(merge.point);
      std::sort(result_.not_proved[side].begin(), result_.not_proved[side].end());
    }
    std::sort(result_.curves.begin(), result_.curves.end(), [](const auto& a, const auto& b) {
      return a.mode != b.mode ? a.mode > b.mode : a.component < b.component;
    });
    return std::move(result_);
  }

 private:
  std::uint32_t part_of(const ModeMaximum& maximum) {
    return parts_.find(static_cast<std::uint32_t>(maximum.vertices[0]));
  }

  PersistencePair born(std::size_t side, const MergePair& pair) const {
    const ModeMaximum& maximum = input_.trees[side].maxima[pair.maximum];
    PersistencePair made;
    made.kind = side == 0 ? PairKind::superlevel : PairKind::sublevel;
    made.birth = side == 0 ? maximum.mode : opposite(maximum.mode);
    made.birth_point = maximum.point;
    made.birth_tet = maximum.tet;
    made.is_tie = pair.is_tie;
    made.is_certain = pair.is_certain && input_.curves[side].unresolved.empty();
    made.curve = maximum.curve;
    return made;
  }

  void keep(std::size_t side, const MergePair& pair, const PersistencePair& made) {
    const ModeMaximum& maximum = input_.trees[side].maxima[pair.maximum];
    if (maximum.curve)
      result_.curves.push_back({side == 0 ? 1 : -1, *maximum.curve, maximum.is_closed,
                                maximum.length, result_.pairs.size()});
    result_.pairs.push_back(made);
  }

  void add_side(std::size_t side) {
    const MergeTree& tree = input_.trees[side];
    for (const MergePair& pair : persistence_pairs(tree)) {
      if (!pair.merge) {
        unpaired_[side][part_of(tree.maxima[pair.maximum])].push_back(pair);
        continue;
      }
      const ModeMerge& merge = tree.merges[*pair.merge];
      PersistencePair made = born(side, pair);
      made.death = side == 0 ? merge.mode : opposite(merge.mode);
      made.death_point = input_.values.points[merge.point].point;
      made.death_tet = merge.tet;
      keep(side, pair, made);
    }
  }

  bool is_older(const ModeMaximum& a, const ModeMaximum& b) const {
    const double x = a.mode.middle(), y = b.mode.middle();
    return x != y ? x > y : a.length > b.length;
  }

  bool knows_all_maxima(std::size_t side) const {
    const MergeTree& tree = input_.trees[side];
    const auto may_be = [](const ModeMerge& merge) { return merge.may_be_maximum; };
    return input_.curves[side].unresolved.empty() &&
           std::none_of(tree.merges.begin(), tree.merges.end(), may_be) &&
           std::none_of(tree.others.begin(), tree.others.end(), may_be);
  }

  /// In each part of the mesh the oldest maximum and the oldest minimum are a pair. Others that met
  /// no older one have met one at a point that is not proved.
  void add_extended() {
    for (auto& [part, highest] : unpaired_[0]) {
      auto& lowest = unpaired_[1][part];
      for (const std::size_t side : {0u, 1u}) {
        auto& list = side == 0 ? highest : lowest;
        const auto& maxima = input_.trees[side].maxima;
        std::stable_sort(list.begin(), list.end(), [&](const MergePair& a, const MergePair& b) {
          return is_older(maxima[a.maximum], maxima[b.maximum]);
        });
        for (std::size_t i = 1; i < list.size(); ++i) {
          PersistencePair made = born(side, list[i]);
          made.has_death = made.is_certain = false;
          made.death = side == 0 ? ModeRange{-1, made.birth.high} : ModeRange{made.birth.low, 1};
          keep(side, list[i], made);
        }
      }
      if (highest.empty() || lowest.empty()) continue;
      PersistencePair made = born(0, highest[0]);
      const PersistencePair low = born(1, lowest[0]);
      made.kind = PairKind::extended;
      made.death = low.birth;
      made.death_point = low.birth_point;
      made.death_tet = low.birth_tet;
      made.is_tie |= low.is_tie;
      // That there is one such component is certain; where its extrema are is a matter of values.
      made.is_certain = knows_all_maxima(0) && knows_all_maxima(1);
      keep(0, highest[0], made);
      if (low.curve) {
        const ModeMaximum& curve = input_.trees[1].maxima[lowest[0].maximum];
        result_.curves.push_back(
            {-1, *curve.curve, curve.is_closed, curve.length, result_.pairs.size() - 1});
      }
    }
  }

  const PersistenceInput& input_;
  UnionFind parts_;
  std::array<std::map<std::uint32_t, std::vector<MergePair>>, 2> unpaired_;
  ModePersistence result_;
};

}  // namespace

std::string_view name_of(PairKind kind) {
  switch (kind) {
    case PairKind::superlevel:
      return "superlevel";
    case PairKind::sublevel:
      return "sublevel";
    case PairKind::extended:
      break;
  }
  return "extended";
}

double signed_lode_angle(double mode) { return elementary::asin(std::clamp(mode, -1.0, 1.0)) / 3; }

double angle_persistence(const PersistencePair& pair) {
  const bool falls = pair.kind != PairKind::sublevel;
  const double from = falls ? pair.birth.low : -pair.birth.high;
  const double to = falls ? pair.death.high : -pair.death.low;
  return std::max(0.0, signed_lode_angle(from) - signed_lode_angle(to));
}

double survived_noise(const PersistencePair& pair) {
  return elementary::sin(angle_persistence(pair) / 2);
}

PersistenceInput persistence_input(const TetMesh& mesh,
                                   const std::function<void(std::string_view, double)>& progress) {
  const auto tell = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  PersistenceInput input;
  tell("critical values", 0);
  // Both ends belong to it: the mode may be 1 or -1 at a point that is on no curve.
  input.values = mesh_critical_values(mesh, std::nextafter(-1.0, -2.0), 1);
  tell("degenerate curves", 0.4);
  input.curves[0] = extract_degenerate_curves(mesh, Degeneracy::linear);
  input.curves[1] = extract_degenerate_curves(mesh, Degeneracy::planar);
  tell("merge trees", 0.7);
  oneapi::tbb::parallel_invoke(
      [&] { input.trees[0] = merge_tree(mesh, input.values, input.curves[0]); },
      [&] {
        const TetMesh other = opposite(mesh);
        input.trees[1] = merge_tree(other, opposite(input.values), input.curves[1]);
      });
  tell("pairs", 0.95);
  return input;
}

ModePersistence mode_persistence(const TetMesh& mesh, const PersistenceInput& input) {
  return Pairing(mesh, input).run();
}

}  // namespace tensortopo
