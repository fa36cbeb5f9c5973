// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "homology/outside_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tensortopo::persistence {
namespace {

class Joining {
 public:
  Joining(const MergeTree& tree, const MeshCriticalValues& values,
          const std::vector<CurveShape>& shapes, const MeshBoundary& boundary)
      : tree_(tree), values_(values), shapes_(shapes), boundary_(boundary) {}

  OutsideTree run() {
    result_.surfaces = boundary_.surfaces();
    for (std::size_t i = 0; i < result_.surfaces; ++i) {
      ModeMaximum surface;
      // None is born at the mode of another: which of two goes on is then no tie.
      surface.mode.low = surface.mode.high = 2.0 + static_cast<double>(result_.surfaces - i);
      result_.tree.maxima.push_back(surface);
    }
    for (std::size_t i = 0; i < tree_.maxima.size(); ++i) {
      result_.tree.maxima.push_back(tree_.maxima[i]);
      result_.member.push_back(member_of(i));
    }
    for (const ModeMerge& merge : tree_.merges) add(merge);
    for (const ModeMerge& merge : tree_.others)
      if (is_contact(merge)) add(merge);
    for (std::size_t c = 0; c < shapes_.size(); ++c) {
      if (shapes_[c].contacts.size() < 2) continue;
      ModeMerge merge;
      merge.mode = {1, 1};
      merge.point = values_.points.size() + c;  // no point
      merge.tet = tree_.maxima[c].tet;
      merge.reached = shapes_[c].contacts;
      merge.is_proved = true;
      merges_.emplace_back(std::move(merge), c);
    }
    std::stable_sort(merges_.begin(), merges_.end(), [](const auto& a, const auto& b) {
      return a.first.mode.middle() > b.first.mode.middle();
    });
    for (auto& [merge, curve] : merges_) {
      result_.tree.merges.push_back(std::move(merge));
      result_.curves.push_back(curve);
    }
    return std::move(result_);
  }

 private:
  /// What stands for a maximum: itself, or the boundary surface that it is on.
  std::size_t member_of(std::size_t i) const {
    const ModeMaximum& maximum = tree_.maxima[i];
    if (maximum.curve) {
      const auto& contacts = shapes_[*maximum.curve].contacts;
      return contacts.empty() ? result_.surfaces + i : contacts.front();
    }
    return boundary_.surface_of(maximum.vertices).value_or(result_.surfaces + i);
  }

  /// The one part of the link, or its path if that is not known, leads from the boundary inside.
  bool is_contact(const ModeMerge& merge) const {
    return boundary_.surface_of(values_.points[merge.point].vertices) &&
           (!merge.is_proved_inside ||
            (!merge.touches_boundary.empty() && merge.touches_boundary[0] == 0));
  }

  void add(ModeMerge merge) {
    const MeshCriticalPoint& point = values_.points[merge.point];
    const auto surface = boundary_.surface_of(point.vertices);
    std::vector<std::size_t> reached;
    if (surface) reached.push_back(*surface);
    for (std::size_t i = 0; i < merge.reached.size(); ++i)
      if (!surface || merge.touches_boundary.empty() || merge.touches_boundary[i] == 0)
        reached.push_back(result_.member[merge.reached[i]]);
    merge.is_proved = surface ? merge.is_proved_inside : merge.is_proved;
    if (merge.is_proved && reached.size() < 2) return;
    if (!merge.is_proved && merge.possible) {
      for (std::size_t& i : *merge.possible) i = result_.member[i];
      if (surface) merge.possible->push_back(*surface);
    }
    merge.reached = std::move(reached);
    merges_.emplace_back(std::move(merge), std::nullopt);
  }

  const MergeTree& tree_;
  const MeshCriticalValues& values_;
  const std::vector<CurveShape>& shapes_;
  const MeshBoundary& boundary_;
  std::vector<std::pair<ModeMerge, std::optional<std::size_t>>> merges_;
  OutsideTree result_;
};

}  // namespace

OutsideTree outside_tree(const MergeTree& tree, const MeshCriticalValues& values,
                         const std::vector<CurveShape>& shapes, const MeshBoundary& boundary) {
  return Joining(tree, values, shapes, boundary).run();
}

}  // namespace tensortopo::persistence
