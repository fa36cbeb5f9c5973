// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/persistence_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {
namespace {

/// A component of {mode >= m}, by its class.
struct Component {
  std::size_t oldest = 0;      ///< maximum
  double doubtful_until = -2;  ///< points that are not proved touch it up to this mode
  std::size_t last_merge = 0;
  double last_low = 2;                      ///< of it
  std::optional<std::size_t> last_maximum;  ///< that died there
};

bool have_one_length(const ModeMaximum& a, const ModeMaximum& b) {
  return std::abs(a.length - b.length) <= 1e-9 * std::max(a.length, b.length);
}

/// Whether a is the older one.
bool is_older(const ModeMaximum& a, const ModeMaximum& b) {
  const double mode_a = a.mode.middle(), mode_b = b.mode.middle();
  return mode_a != mode_b ? mode_a > mode_b : a.length > b.length;
}

bool may_be_other_way(const ModeMaximum& a, const ModeMaximum& b) {
  if (a.curve && b.curve) return have_one_length(a, b);
  return a.mode.overlaps(b.mode);
}

/// Whether the last merge of a component, at another point, may be the later one.
bool may_be_exchanged(const Component& component, std::size_t merge, const ModeRange& mode) {
  return component.last_maximum && component.last_merge != merge && component.last_low <= mode.high;
}

}  // namespace

std::vector<MergePair> persistence_pairs(const MergeTree& tree) {
  std::vector<MergePair> pairs(tree.maxima.size());
  std::vector<Component> components(tree.maxima.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].maximum = components[i].oldest = i;
  UnionFind classes(tree.maxima.size());
  const auto class_of = [&](std::size_t maximum) {
    return classes.find(static_cast<std::uint32_t>(maximum));
  };
  for (std::size_t m = 0; m < tree.merges.size(); ++m) {
    const ModeMerge& merge = tree.merges[m];
    if (!merge.is_proved)
      for (const std::size_t i : merge.reached) {
        double& until = components[class_of(i)].doubtful_until;
        until = std::max(until, merge.mode.high);
      }
    // An undecided point may join what it touches, or not.
    if (!merge.is_proved) continue;
    for (std::size_t i = 1; i < merge.reached.size(); ++i) {
      const auto first = class_of(merge.reached[0]), second = class_of(merge.reached[i]);
      if (first == second) {
        // With other values in the enclosures this point may be the one that joins.
        const Component& whole = components[first];
        if (may_be_exchanged(whole, m, merge.mode)) pairs[*whole.last_maximum].is_tie = true;
        continue;
      }
      Component older = components[first], younger = components[second];
      const ModeMaximum &a = tree.maxima[older.oldest], &b = tree.maxima[younger.oldest];
      if (is_older(b, a) || (!is_older(a, b) && younger.oldest < older.oldest))
        std::swap(older, younger);
      MergePair& pair = pairs[younger.oldest];
      pair.merge = m;
      pair.is_tie |= may_be_other_way(tree.maxima[older.oldest], tree.maxima[younger.oldest]);
      for (const Component& part : {older, younger})
        if (may_be_exchanged(part, m, merge.mode))
          pair.is_tie = pairs[*part.last_maximum].is_tie = true;
      pair.is_certain = younger.doubtful_until < merge.mode.low;
      older.doubtful_until = std::max(older.doubtful_until, younger.doubtful_until);
      older.last_merge = m;
      older.last_low = merge.mode.low;
      older.last_maximum = younger.oldest;
      classes.unite(first, second);
      components[class_of(merge.reached[0])] = older;
    }
  }
  for (MergePair& pair : pairs)
    if (!pair.merge) pair.is_certain = components[class_of(pair.maximum)].doubtful_until < -1;
  return pairs;
}

}  // namespace tensortopo
