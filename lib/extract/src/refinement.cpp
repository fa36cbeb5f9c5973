// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/refinement.hpp"

#include <algorithm>

#include "extractor_scalars.hpp"
#include "tensortopo/extract/exact_side.hpp"
#include "tiers.hpp"

namespace tensortopo {

namespace {

/// How many edges of a refinement are cut off the middle. Each such cut along a chain takes five
/// bits of the weights, which have fifty.
constexpr std::size_t kUnevenCuts = 12;

}  // namespace

template <class Scalar, std::size_t Vertices>
bool is_above(const LevelSimplex<Scalar, Vertices>& simplex, const Deviator<Scalar>& tensor,
              const std::array<Scalar, Vertices>& weights, const Level<Scalar>& level) {
  const Verdict verdict = side_of_level(tensor, level);
  if (verdict != Verdict::unknown) return verdict == Verdict::positive;
  std::array<SymmetricTensor<double>, Vertices> exact;
  std::array<double, Vertices> exact_weights;
  for (std::size_t i = 0; i < Vertices; ++i) {
    exact[i] = *simplex.exact[i];
    exact_weights[i] = static_cast<double>(weights[i]);
  }
  // The level is mu + 0: a point exactly on mu counts as below.
  return exact_side_of_level(exact, simplex.exponents, exact_weights, level.value) ==
         Sign::positive;
}

template <class Scalar, std::size_t Vertices>
Refinement<Scalar, Vertices>::Refinement(const LevelSimplex<Scalar, Vertices>& simplex,
                                         const Level<Scalar>& level)
    : simplex_(&simplex), level_(&level) {
  Cell root;
  for (std::size_t i = 0; i < Vertices; ++i) {
    Vertex v;
    for (auto& w : v.weights) w = Scalar(0);
    v.weights[i] = Scalar(1);
    v.tensor = simplex.tensors[i];
    v.above = simplex.above[i];
    vertices_.push_back(v);
    last_bisection_.push_back(0);
    root.vertices[i] = static_cast<std::uint32_t>(i);
  }
  cells_.push_back(root);
}

template <class Scalar, std::size_t Vertices>
bool Refinement<Scalar, Vertices>::run(std::size_t budget) {
  // Cells are appended by bisection; each pass looks at all that are new or may hang.
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (!cells_[c].alive) continue;
      if (is_simple(cells_[c]) && !has_hanging_vertex(cells_[c])) continue;
      if (cells_.size() > budget || !bisect(c)) return false;
      changed = true;
    }
  }
  return true;
}

template <class Scalar, std::size_t Vertices>
bool Refinement<Scalar, Vertices>::is_simple(Cell& cell) {
  if (cell.checked) return true;  // only a simple cell stays
  cell.proof = prove(cell.vertices);
  using Kind = typename SimplexProof<Scalar, Vertices>::Kind;
  const bool simple = cell.proof.kind == Kind::empty ||
                      (cell.proof.kind == Kind::monotone && edges_are_simple(cell) &&
                       faces_are_simple(cell));
  cell.checked = simple;
  return simple;
}

template <class Scalar, std::size_t Vertices>
template <std::size_t Part>
SimplexProof<Scalar, Part> Refinement<Scalar, Vertices>::prove(
    const std::array<std::uint32_t, Part>& part) const {
  std::array<std::array<Scalar, Vertices>, Part> weights;
  std::array<Deviator<Scalar>, Part> tensors;
  for (std::size_t i = 0; i < Part; ++i) {
    weights[i] = vertices_[part[i]].weights;
    tensors[i] = vertices_[part[i]].tensor;
  }
  return prove_part(*simplex_, weights, tensors, *level_);
}

template <class Scalar, std::size_t Vertices>
bool Refinement<Scalar, Vertices>::edges_are_simple(const Cell& cell) {
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t j = i + 1; j < Vertices; ++j) {
      const auto u = cell.vertices[i], v = cell.vertices[j];
      auto& record = edges_[key(u, v)];
      if (record.simple < 0)
        record.simple = edge_is_simple<Scalar, Vertices>(
            *simplex_, {vertices_[u].weights, vertices_[v].weights},
            {vertices_[u].tensor, vertices_[v].tensor}, *level_);
      if (record.simple == 0) return false;
    }
  return true;
}

template <class Scalar, std::size_t Vertices>
bool Refinement<Scalar, Vertices>::faces_are_simple(const Cell& cell) const {
  if constexpr (Vertices == 4) {
    for (std::size_t omitted = 0; omitted < 4; ++omitted) {
      std::array<std::uint32_t, 3> face;
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != omitted) face[k++] = cell.vertices[i];
      if (prove(face).kind == SimplexProof<Scalar, 3>::Kind::none) return false;
    }
  }
  return true;
}

template <class Scalar, std::size_t Vertices>
bool Refinement<Scalar, Vertices>::has_hanging_vertex(Cell& cell) const {
  // An edge of the cell that was bisected since the last look has both ends marked since then.
  int marked = 0;
  for (const auto v : cell.vertices) marked += last_bisection_[v] > cell.seen ? 1 : 0;
  if (marked >= 2)
    for (std::size_t i = 0; i < Vertices; ++i)
      for (std::size_t j = i + 1; j < Vertices; ++j) {
        const auto found = edges_.find(key(cell.vertices[i], cell.vertices[j]));
        if (found != edges_.end() && found->second.middle != kNone) return true;
      }
  cell.seen = bisections_;
  return false;
}

template <class Scalar, std::size_t Vertices>
Scalar Refinement<Scalar, Vertices>::length(std::uint32_t u, std::uint32_t v) const {
  // Decreases with the cosine of the angle; any total order does, as long as all cells use it.
  const auto &s = vertices_[u].tensor, &t = vertices_[v].tensor;
  const Scalar product = norm_form(s, t), scale = norm_form(s) * norm_form(t);
  if (!(scale > Scalar(0))) return Scalar(2);
  const Scalar signed_square = (product < Scalar(0) ? -product : product) * product / scale;
  return -signed_square;
}

template <class Scalar, std::size_t Vertices>
bool Refinement<Scalar, Vertices>::bisect(std::size_t c) {
  const auto vertices = cells_[c].vertices;
  std::size_t best_i = 0, best_j = 1;
  Scalar best(-3);
  EdgeKey best_key = 0;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t j = i + 1; j < Vertices; ++j) {
      const Scalar l = length(vertices[i], vertices[j]);
      const EdgeKey k = key(vertices[i], vertices[j]);
      if (l > best || (l == best && k < best_key)) best = l, best_key = k, best_i = i, best_j = j;
    }
  const auto m = middle(vertices[best_i], vertices[best_j]);
  if (m == kNone) return false;
  cells_[c].alive = false;
  for (const std::size_t replaced : {best_j, best_i}) {
    Cell child;
    child.vertices = vertices;
    child.vertices[replaced] = m;
    cells_.push_back(child);
  }
  return true;
}

template <class Scalar, std::size_t Vertices>
std::uint32_t Refinement<Scalar, Vertices>::middle(std::uint32_t u, std::uint32_t v) {
  auto& record = edges_[key(u, v)];
  if (record.middle != kNone) return record.middle;
  // The first cuts are off the middle. Real fields have symmetries, and middles would put sides
  // of cells on their axes and planes, where a level can touch a side exactly.
  constexpr std::array<int, 5> thirty_seconds{13, 17, 15, 19, 14};
  const std::size_t cuts = vertices_.size() - Vertices;
  const Scalar share = cuts < kUnevenCuts
                           ? Scalar(thirty_seconds[cuts % thirty_seconds.size()]) / Scalar(32)
                           : Scalar(1) / Scalar(2);
  const auto [lower, upper] = std::minmax(u, v);
  Vertex m;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto &a = vertices_[lower].weights[i], &b = vertices_[upper].weights[i];
    m.weights[i] = a + share * (b - a);
    // Weights stay exact in double for all scalars: the exact tier is fed with them.
    if (Scalar(static_cast<double>(m.weights[i])) != m.weights[i]) return kNone;
  }
  for (std::size_t i = 0; i < Vertices; ++i) {
    // Dyadic fractions below one are exact down to 2^-52; finer cells are refused.
    const Scalar w = m.weights[i];
    if (w > Scalar(0) && w < Scalar(1.0 / (1ull << 50))) return kNone;
  }
  m.tensor = tensor_at(simplex_->tensors, m.weights);
  m.above = is_above(*simplex_, m.tensor, m.weights, *level_);
  record.middle = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back(m);
  last_bisection_.push_back(0);
  ++bisections_;
  last_bisection_[u] = last_bisection_[v] = bisections_;
  return record.middle;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                          \
  template class Refinement<Scalar, 3>;                                                         \
  template class Refinement<Scalar, 4>;                                                         \
  template bool is_above(const LevelSimplex<Scalar, 2>&, const Deviator<Scalar>&,               \
                         const std::array<Scalar, 2>&, const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
