// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/page/arithmetic.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "bench/timing.hpp"
#include "extract/level/simd/lane_kernels.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {
namespace {

using Index = TetMesh::Index;

/// On which side of a level the vertices are.
class Sides {
 public:
  Sides(const ScaledField<double>& field, const Level<double>& level) {
    for (const auto& t : field.tensors) above_.push_back(level_function(t, level) > 0);
    for (std::size_t v = 0; v < above_.size(); ++v)
      if (field.is_zero[v]) above_[v] = kNone;
  }

  /// Of each vertex: 1 above, 0 below, neither where the tensor vanishes.
  const std::vector<char>& of_vertices() const { return above_; }
  char of(Index vertex) const { return above_[as_size(vertex)]; }
  bool has_both(std::span<const Index> simplex) const {
    const auto is = [&](char side) { return [this, side](Index v) { return of(v) == side; }; };
    return std::any_of(simplex.begin(), simplex.end(), is(0)) &&
           std::any_of(simplex.begin(), simplex.end(), is(1)) &&
           std::none_of(simplex.begin(), simplex.end(), is(kNone));
  }

 private:
  static constexpr char kNone = 2;
  std::vector<char> above_;
};

/// Seconds of the proofs of the simplices with vertices on both sides.
template <std::size_t Vertices>
double seconds_of_proofs(const std::vector<std::array<Index, Vertices>>& simplices,
                         const ScaledField<double>& field, const Level<double>& level,
                         const Sides& sides) {
  std::vector<std::array<Deviator<double>, Vertices>> crossed;
  for (const auto& simplex : simplices)
    if (sides.has_both(simplex))
      crossed.push_back(field.simplex<Vertices>(simplex, sides.of_vertices()).tensors);
  std::vector<SimplexProof<double, Vertices>> proofs(crossed.size());
  return seconds_of([&] { prove_simplices<Vertices>(crossed, level, proofs); });
}

double seconds_of_crossings(const std::vector<std::array<Index, 2>>& edges,
                            const ScaledField<double>& field, const Level<double>& level,
                            const Sides& sides) {
  std::vector<std::array<Deviator<double>, 2>> ends;
  std::vector<char> rising;
  for (const auto& edge : edges)
    if (sides.has_both(edge)) {
      ends.push_back(field.simplex<2>(edge, sides.of_vertices()).tensors);
      rising.push_back(sides.of(edge[1]));
    }
  std::vector<double> weights(ends.size());
  return seconds_of([&] { single_crossings(ends, rising, level, weights); });
}

}  // namespace

Arithmetic measure_arithmetic(const TetMesh& mesh, std::span<const ModeValue> modes) {
  Arithmetic result;
  const ScaledField<double> field(mesh);
  for (const ModeValue& mode : modes) {
    const Level<double> level = make_level<double>(mode);
    const Sides sides(field, level);
    std::vector<Index> numbers;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (sides.has_both(mesh.tets[t])) numbers.push_back(static_cast<Index>(t));
    const TetComplex cells = tet_complex(mesh, numbers);
    std::vector<std::array<Index, 4>> tets;
    for (const Index t : numbers) tets.push_back(mesh.tets[as_size(t)]);
    result.crossed += tets.size();
    result.edges += seconds_of_crossings(cells.edges, field, level, sides);
    result.faces += seconds_of_proofs(cells.faces, field, level, sides);
    result.tets += seconds_of_proofs(tets, field, level, sides);
  }
  return result;
}

}  // namespace tensortopo
