// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/quality/cell_thinning.hpp"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace tensortopo {

namespace {

using Id = CellPatch::Id;

/// A sample is taken out only if the sine of the least angle is so much larger then.
constexpr double kLargerSine = 1.05;

/// Goes along the curves again and again until no sample is taken out any more.
/// @param remove  takes out a vertex, given the chain and its two neighbours there, if it may
template <class Remove>
void until_none_is_removed(const CellPatch& patch, std::vector<CurveChain>& chains,
                           const Remove& remove) {
  // What keeps a sample does so until triangles change that it looked at: only then is it asked for
  // again.
  constexpr std::uint32_t kNever = 0xffffffff;
  using Turns = boost::container::small_vector<std::uint32_t, 16>;
  std::vector<Turns> asked;  // of each sample, the turn in which it was kept
  asked.reserve(chains.size());
  for (CurveChain& chain : chains) {
    asked.emplace_back(chain.vertices.size(), kNever);
    if (chain.is_closed && !chain.vertices.empty()) chain.area = patch.area_of(chain.vertices);
  }
  for (bool any = true; any;) {
    any = false;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      CurveChain& chain = chains[c];
      auto& v = chain.vertices;
      const std::size_t ends = chain.is_closed ? 0 : 1;
      for (std::size_t i = ends; i + ends < v.size() && v.size() > chain.least + 2 * ends;) {
        const std::size_t n = v.size();
        const std::array neighbours{v[(i + n - 1) % n], v[(i + 1) % n]};
        const auto before = std::exchange(asked[c][i], patch.turn());
        // A closed polygon looks at all its vertices.
        const bool is_as_before =
            before == patch.turn() || (before != kNever && !chain.is_closed &&
                                       patch.is_unchanged_since(before, v[i], neighbours));
        if (is_as_before || !remove(chain, v[i], neighbours)) {
          ++i;
          continue;
        }
        if (chain.is_closed)
          chain.area = chain.area - patch.area_of(std::array{neighbours[0], v[i], neighbours[1]});
        v.erase(v.begin() + static_cast<std::ptrdiff_t>(i));
        asked[c].erase(asked[c].begin() + static_cast<std::ptrdiff_t>(i));
        any = true;
      }
    }
  }
}

struct Way {
  double sine;
  Id to;
};

/// The ways out for a vertex, the better one first; with sine 0 it is none.
std::array<Way, 2> ways_out(CellPatch& patch, const CurveChain& chain, Id v,
                            const std::array<Id, 2>& neighbours, double least) {
  std::array<Way, 2> ways;
  for (std::size_t k = 0; k < 2; ++k)
    ways[k] = {patch.least_sine_after(v, neighbours[k], least, chain.least_cosine), neighbours[k]};
  if (ways[0].sine < ways[1].sine) std::swap(ways[0], ways[1]);
  return ways;
}

bool stays_close(const CellPatch& patch, const CurveChain& chain, Id v, Id u) {
  const double offset = patch.offset_after(v, u);
  return offset <= chain.flatness || offset <= patch.offset_around(v);
}

/// Whether a closed curve turns the same way without one of its vertices.
bool turns_alike_without(const CellPatch& patch, const CurveChain& chain, Id v,
                         const std::array<Id, 2>& neighbours) {
  return dot(chain.area, chain.area - patch.area_of(std::array{neighbours[0], v, neighbours[1]})) >
         0;
}

bool may_go(CellPatch& patch, const CurveChain& chain, Id v, const std::array<Id, 2>& neighbours,
            const Way& way) {
  return way.sine > 0 && (!chain.is_closed || turns_alike_without(patch, chain, v, neighbours)) &&
         (!chain.stays_embedded || patch.is_embedded_after(v, way.to));
}

bool holds(const std::vector<Id>& ids, Id id) {
  return std::binary_search(ids.begin(), ids.end(), id);
}

}  // namespace

std::vector<Id> samples_at_needles(const CellPatch& patch, const std::vector<CurveChain>& chains) {
  std::vector<Id> samples;
  for (const CurveChain& chain : chains) {
    const std::size_t ends = chain.is_closed ? 0 : 1;
    for (std::size_t i = ends; i + ends < chain.vertices.size(); ++i)
      if (patch.least_sine_around(chain.vertices[i]) <= kSineOfNeedle)
        samples.push_back(chain.vertices[i]);
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

ThinningProposal propose_thinning(CellPatch& patch, std::vector<CurveChain> chains,
                                  const std::vector<Id>& candidates) {
  ThinningProposal proposal;
  until_none_is_removed(
      patch, chains, [&](const CurveChain& chain, Id v, const std::array<Id, 2>& neighbours) {
        if (!holds(candidates, v)) return false;
        const double sine = patch.least_sine_around(v);
        const bool is_wanted = sine <= kSineOfNeedle;
        const auto ways =
            ways_out(patch, chain, v, neighbours, is_wanted ? kLargerSine * sine : kSineOfNeedle);
        const auto way = std::find_if(ways.begin(), ways.end(), [&](const Way& w) {
          return w.sine > 0 && stays_close(patch, chain, v, w.to) &&
                 may_go(patch, chain, v, neighbours, w);
        });
        if (way == ways.end()) return false;
        patch.move(v, way->to);
        proposal.accepted.push_back(v);
        if (is_wanted) proposal.wanted.push_back(v);
        return true;
      });
  std::sort(proposal.accepted.begin(), proposal.accepted.end());
  std::sort(proposal.wanted.begin(), proposal.wanted.end());
  return proposal;
}

std::vector<Id> take_out(CellPatch& patch, std::vector<CurveChain> chains,
                         const std::vector<Id>& samples) {
  std::vector<Id> left = samples;
  until_none_is_removed(patch, chains,
                        [&](const CurveChain& chain, Id v, const std::array<Id, 2>& neighbours) {
                          if (!holds(samples, v)) return false;
                          auto ways = ways_out(patch, chain, v, neighbours, 0);
                          if (!may_go(patch, chain, v, neighbours, ways[0])) {
                            if (!may_go(patch, chain, v, neighbours, ways[1])) return false;
                            std::swap(ways[0], ways[1]);
                          }
                          const bool second = !stays_close(patch, chain, v, ways[0].to) &&
                                              may_go(patch, chain, v, neighbours, ways[1]) &&
                                              stays_close(patch, chain, v, ways[1].to);
                          patch.move(v, ways[second ? 1 : 0].to);
                          std::erase(left, v);
                          return true;
                        });
  return left;
}

}  // namespace tensortopo
