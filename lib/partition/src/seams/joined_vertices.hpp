// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What seams of surfaces and of curves have in common: vertices that are one, and the components
// that these join.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "differing_pieces.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

/// Something in the list of one of the seams.
struct InSeam {
  std::size_t seam, place;
};

/// The components of all seams, in classes of those that are one in the whole.
/// @tparam Seam  of surfaces (`SurfaceSeam`) or of curves (`CurveSeam`)
template <class Seam>
class SeamComponents {
 public:
  using Index = TetMesh::Index;

  explicit SeamComponents(std::span<const Seam> seams) {
    std::uint32_t count = 0;
    for (const Seam& seam : seams) {
      first_.push_back(count);
      count += static_cast<std::uint32_t>(seam.components.size());
    }
    first_.push_back(count);
    classes_ = UnionFind(count);
  }

  std::size_t size() const { return first_.back(); }
  /// The place of a component among those of all seams.
  std::uint32_t at(std::size_t seam, Index component) const {
    return first_[seam] + static_cast<std::uint32_t>(component);
  }
  void unite(std::uint32_t a, std::uint32_t b) { classes_.unite(a, b); }

  /// Numbers from 0 for the classes, in the order in which their first components are listed.
  /// @param order  all components
  void number(std::span<const std::uint32_t> order) {
    number_.assign(size(), -1);
    for (const std::uint32_t c : order) {
      Index& known = number_[classes_.find(c)];
      if (known < 0) known = count_++;
    }
    for (std::uint32_t c = 0; c < size(); ++c) number_[c] = number_[classes_.find(c)];
  }
  /// The number of a component's class.
  Index number_of(std::uint32_t component) const { return number_[component]; }
  /// How many classes have numbers.
  std::size_t count() const { return as_size(count_); }
  /// Of each seam, of each of its components.
  std::vector<std::vector<Index>> numbers() const {
    std::vector<std::vector<Index>> result;
    for (std::size_t s = 0; s + 1 < first_.size(); ++s)
      result.emplace_back(number_.begin() + first_[s], number_.begin() + first_[s + 1]);
    return result;
  }

 private:
  std::vector<std::uint32_t> first_;  ///< of each seam; at last, how many
  UnionFind classes_;
  std::vector<Index> number_;  ///< of each component
  Index count_ = 0;
};

/// The vertices of all seams.
struct JoinedVertices {
  std::vector<InSeam> vertices;                     ///< of the whole, once each
  std::vector<std::vector<std::uint32_t>> of_seam;  ///< of each seam, of its vertices: in these
};

/// Finds which vertices are one: these have one carrier and ordinal, and are in one component.
/// @param again  again(component) is called for each but the first of those that are one
/// @throws PiecesDiffer with the place, if digests differ
template <class Seam, class Again>
JoinedVertices join_vertices(std::span<const Seam> seams, SeamComponents<Seam>& components,
                             const Again& again) {
  JoinedVertices joined;
  std::vector<InSeam> all;
  for (std::size_t s = 0; s < seams.size(); ++s) {
    joined.of_seam.emplace_back(seams[s].vertices.size(), 0u);
    for (std::size_t v = 0; v < seams[s].vertices.size(); ++v) all.push_back({s, v});
  }
  const auto vertex = [&](const InSeam& at) -> const auto& {
    return seams[at.seam].vertices[at.place];
  };
  const auto key = [&](const InSeam& at) {
    return std::tie(vertex(at).carrier_ids, vertex(at).ordinal);
  };
  std::sort(all.begin(), all.end(), [&](const InSeam& a, const InSeam& b) {
    return std::tuple_cat(key(a), std::tie(a.seam)) < std::tuple_cat(key(b), std::tie(b.seam));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const InSeam& at = all[i];
    if (i == 0 || key(all[i - 1]) != key(at)) {
      joined.vertices.push_back(at);
    } else {
      const InSeam& first = joined.vertices.back();
      if (vertex(first).digest != vertex(at).digest)
        refuse_simplex("they differ", vertex(at).carrier_ids);
      const auto own = components.at(at.seam, vertex(at).component);
      components.unite(components.at(first.seam, vertex(first).component), own);
      again(own);
    }
    joined.of_seam[at.seam][at.place] = static_cast<std::uint32_t>(joined.vertices.size() - 1);
  }
  return joined;
}

}  // namespace tensortopo
