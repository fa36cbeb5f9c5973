// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The kernels of an extraction, on the tetrahedra of Kelvin's field: one iteration is one simplex,
// taken in turn from those that hold the level (or from all, for the screen).
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "extract/level/simd/lane_kernels.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"
#include "extract/topology/boundary/face_curves.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/families/field_family.hpp"
#include "tensortopo/manifold/field_lift.hpp"
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {
namespace {

/// A field, a level, and which tetrahedra have vertices on both sides of it.
struct Case {
  TetMesh mesh = family_member(FieldKind::kelvin, {1, 0, 1, 20000}).mesh;
  ScaledField<double> field{mesh};
  Level<double> level = make_level<double>(ModeValue::parse("1/2"));
  std::vector<char> above;
  std::vector<std::array<TetMesh::Index, 4>> crossed;

  Case() {
    for (const auto& t : field.tensors) above.push_back(level_function(t, level) > 0);
    for (const auto& v : mesh.tets) {
      int count = 0;
      for (const auto i : v) count += above[static_cast<std::size_t>(i)];
      if (count > 0 && count < 4) crossed.push_back(v);
    }
  }

  /// The first vertices of a crossed tetrahedron; of an edge, two on different sides.
  template <std::size_t Vertices>
  LevelSimplex<double, Vertices> simplex(std::size_t i) const {
    auto v = crossed[i % crossed.size()];
    const auto is_above = [&](std::size_t k) { return above[static_cast<std::size_t>(v[k])]; };
    for (std::size_t k = 2; k < 4 && is_above(0) == is_above(1); ++k) std::swap(v[1], v[k]);
    std::array<TetMesh::Index, Vertices> part;
    std::copy_n(v.begin(), Vertices, part.begin());
    return field.simplex<Vertices>(part, above);
  }
};

const Case& shared_case() {
  static const Case one;
  return one;
}

void screen_tetrahedron(benchmark::State& state) {
  const Case& c = shared_case();
  std::vector<std::array<Deviator<double>, 4>> cells;
  for (const auto& v : c.mesh.tets) {
    cells.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      cells.back()[k] = c.field.tensors[static_cast<std::size_t>(v[k])];
  }
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(screen::excludes(cells[i], c.level.lode_angle));
    i = (i + 1) % cells.size();
  }
}
BENCHMARK(screen_tetrahedron);

template <std::size_t Vertices>
std::vector<LevelSimplex<double, Vertices>> simplices() {
  std::vector<LevelSimplex<double, Vertices>> all;
  for (std::size_t i = 0; i < shared_case().crossed.size(); ++i)
    all.push_back(shared_case().simplex<Vertices>(i));
  return all;
}

void edge_crossings_counted(benchmark::State& state) {
  const auto edges = simplices<2>();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(edge_crossings(edges[i], shared_case().level));
    i = (i + 1) % edges.size();
  }
}
BENCHMARK(edge_crossings_counted);

template <std::size_t Vertices>
void proof(benchmark::State& state) {
  const auto all = simplices<Vertices>();
  std::size_t i = 0, proved = 0, tried = 0;
  for (auto _ : state) {
    const auto p = prove_simplex(all[i].tensors, shared_case().level);
    proved += p.kind != SimplexProof<double, Vertices>::Kind::none;
    ++tried;
    i = (i + 1) % all.size();
  }
  state.counters["proved"] = static_cast<double>(proved) / static_cast<double>(tried);
}
BENCHMARK(proof<3>)->Name("face_proof");
BENCHMARK(proof<4>)->Name("tetrahedron_proof");

template <std::size_t Vertices>
std::vector<std::array<Deviator<double>, Vertices>> vertex_tensors() {
  std::vector<std::array<Deviator<double>, Vertices>> all;
  for (const auto& simplex : simplices<Vertices>()) all.push_back(simplex.tensors);
  return all;
}

// The same with lanes, 64 simplices a call; an iteration is still one simplex.
constexpr std::size_t kBlock = 64;

template <std::size_t Vertices>
void proof_in_lanes(benchmark::State& state) {
  const auto all = vertex_tensors<Vertices>();
  std::vector<SimplexProof<double, Vertices>> proofs(kBlock);
  std::size_t i = 0;
  while (state.KeepRunningBatch(kBlock)) {
    prove_simplices<Vertices>(std::span(all).subspan(i, kBlock), shared_case().level, proofs);
    benchmark::DoNotOptimize(proofs.data());
    i = i + 2 * kBlock <= all.size() ? i + kBlock : 0;
  }
}
BENCHMARK(proof_in_lanes<3>)->Name("face_proof_in_lanes");
BENCHMARK(proof_in_lanes<4>)->Name("tetrahedron_proof_in_lanes");

void edge_crossings_in_lanes(benchmark::State& state) {
  const auto ends = vertex_tensors<2>();
  std::vector<char> rising;
  for (const auto& edge : simplices<2>()) rising.push_back(edge.above[1]);
  std::vector<double> weights(kBlock);
  std::size_t i = 0;
  while (state.KeepRunningBatch(kBlock)) {
    single_crossings(std::span(ends).subspan(i, kBlock), std::span(rising).subspan(i, kBlock),
                     shared_case().level, weights);
    benchmark::DoNotOptimize(weights.data());
    i = i + 2 * kBlock <= ends.size() ? i + kBlock : 0;
  }
}
BENCHMARK(edge_crossings_in_lanes);

void manifold_lifting(benchmark::State& state) {
  const Case& c = shared_case();
  const auto parameter = mode_parameter<double>(ModeValue::parse("1/2"));
  TetrahedronField<double> field;
  std::optional<CharacteristicTensor<double>> characteristic;
  for (std::size_t i = 0; !characteristic; ++i) {
    field.vertex = c.simplex<4>(i).tensors;
    characteristic = characteristic_tensor(field);
  }
  const MediumEigenvectorManifold<double> manifold(*characteristic, parameter);
  const FieldLift<double> lift(field);
  double angle = 0;
  for (auto _ : state) {
    angle += 0.1;
    const auto v = manifold.sphere_point(angle, 0.37 * angle);
    benchmark::DoNotOptimize(lift.weights(manifold.tensor_at(v)));
  }
}
BENCHMARK(manifold_lifting);

template <class Scalar>
void invariants(benchmark::State& state) {
  std::vector<Deviator<Scalar>> tensors;
  for (const auto& t : shared_case().mesh.tensors) {
    const auto d = deviator(t);
    tensors.push_back(tensor_cast<Scalar>(d));
    if (tensors.size() == 1000) break;
  }
  std::size_t i = 0;
  for (auto _ : state) {
    Scalar p = norm_form(tensors[i]), q = determinant_form(tensors[i]);
    benchmark::DoNotOptimize(p);
    benchmark::DoNotOptimize(q);
    i = (i + 1) % tensors.size();
  }
}
BENCHMARK(invariants<double>);
BENCHMARK(invariants<Interval>);
BENCHMARK(invariants<Rational>);

}  // namespace
}  // namespace tensortopo

BENCHMARK_MAIN();
