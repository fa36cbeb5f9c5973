// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/persistence_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {
namespace {

constexpr double kBelowAll = -2;  // below all modes

/// A component of {mode >= m}, by its class.
struct Component {
  std::size_t oldest = 0;      ///< maximum
  ModeRange birth;             ///< of the oldest one, whichever that is
  double doubtful_until = kBelowAll;  ///< points that are not proved touch it up to this mode
  /// Maxima that died in it, by the lower bound of the mode at which they did.
  std::multimap<double, std::size_t> died = {};
};

bool have_one_length(const ModeMaximum& a, const ModeMaximum& b) {
  return std::abs(a.length - b.length) <= 1e-9 * std::max(a.length, b.length);
}

/// Whether a is the older one.
bool is_older(const ModeMaximum& a, const ModeMaximum& b) {
  const double mode_a = a.mode.middle(), mode_b = b.mode.middle();
  return mode_a != mode_b ? mode_a > mode_b : a.length > b.length;
}

/// Whether the older one of two components may be the younger.
bool may_be_other_way(const MergeTree& tree, const Component& x, const Component& y) {
  const ModeMaximum &a = tree.maxima[x.oldest], &b = tree.maxima[y.oldest];
  return a.curve && b.curve ? have_one_length(a, b) : x.birth.overlaps(y.birth);
}

/// Notes as ties all that died in a component at points which may come after this merge.
/// @return whether there are any
bool note_exchanges(const MergeTree& tree, const Component& component, std::size_t merge,
                    std::vector<MergePair>& pairs) {
  bool any = false;
  const auto end = component.died.upper_bound(tree.merges[merge].mode.high);
  for (auto died = component.died.begin(); died != end; ++died) {
    MergePair& pair = pairs[died->second];
    if (pair.merge == merge) continue;
    any = pair.is_tie = true;
  }
  return any;
}

/// Adds what died in b to what died in a.
void add(std::multimap<double, std::size_t>& a, std::multimap<double, std::size_t>&& b) {
  if (a.size() < b.size()) a.swap(b);
  a.merge(b);
}

}  // namespace

std::vector<MergePair> persistence_pairs(const MergeTree& tree) {
  std::vector<MergePair> pairs(tree.maxima.size());
  std::vector<Component> components(tree.maxima.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].maximum = components[i].oldest = i;
    components[i].birth = tree.maxima[i].mode;
  }
  UnionFind classes(tree.maxima.size());
  const auto class_of = [&](std::size_t maximum) {
    return classes.find(static_cast<std::uint32_t>(maximum));
  };
  // Points that may join what they touch, or not, each before the first that may come after it.
  std::vector<const ModeMerge*> open;
  for (const ModeMerge& merge : tree.merges)
    if (!merge.is_proved) open.push_back(&merge);
  std::stable_sort(open.begin(), open.end(), [](const ModeMerge* a, const ModeMerge* b) {
    return a->mode.high > b->mode.high;
  });
  auto next = open.begin();
  double all_doubtful_until = kBelowAll;
  const auto pass = [&](double low) {
    for (; next != open.end() && (*next)->mode.high >= low; ++next) {
      const double until = (*next)->mode.high;
      if (!(*next)->possible) {
        all_doubtful_until = std::max(all_doubtful_until, until);
        continue;
      }
      for (const std::size_t i : *(*next)->possible) {
        double& component = components[class_of(i)].doubtful_until;
        component = std::max(component, until);
      }
    }
  };
  for (std::size_t m = 0; m < tree.merges.size(); ++m) {
    const ModeMerge& merge = tree.merges[m];
    if (!merge.is_proved) continue;
    pass(merge.mode.low);
    for (std::size_t i = 1; i < merge.reached.size(); ++i) {
      const auto first = class_of(merge.reached[0]), second = class_of(merge.reached[i]);
      if (first == second) {
        // With other values in the enclosures this point may be the one that joins.
        note_exchanges(tree, components[first], m, pairs);
        continue;
      }
      Component older = std::move(components[first]), younger = std::move(components[second]);
      const ModeMaximum &a = tree.maxima[older.oldest], &b = tree.maxima[younger.oldest];
      if (is_older(b, a) || (!is_older(a, b) && younger.oldest < older.oldest))
        std::swap(older, younger);
      MergePair& pair = pairs[younger.oldest];
      pair.merge = m;
      if (may_be_other_way(tree, older, younger))
        pair.is_tie = pairs[older.oldest].is_tie = true;
      for (const Component* part : {&older, &younger})
        if (note_exchanges(tree, *part, m, pairs)) pair.is_tie = true;
      pair.is_certain = std::max(younger.doubtful_until, all_doubtful_until) < merge.mode.low;
      older.doubtful_until = std::max(older.doubtful_until, younger.doubtful_until);
      older.birth = {std::max(older.birth.low, younger.birth.low),
                     std::max(older.birth.high, younger.birth.high)};
      add(older.died, std::move(younger.died));
      older.died.emplace(merge.mode.low, younger.oldest);
      classes.unite(first, second);
      components[class_of(merge.reached[0])] = std::move(older);
    }
  }
  pass(kBelowAll);
  for (MergePair& pair : pairs)
    if (!pair.merge)
      pair.is_certain =
          std::max(components[class_of(pair.maximum)].doubtful_until, all_doubtful_until) < -1;
  return pairs;
}

}  // namespace tensortopo
