// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "random_fields.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

namespace tensortopo::test {

namespace {

double round_to_24_bits(double value) { return std::round(value * 0x1p24) * 0x1p-24; }

}  // namespace

double Random::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  const double value = round_to_24_bits(radius * std::cos(2 * std::numbers::pi * uniform()));
  return value + std::floor(uniform() * 0x1p26) * 0x1p-50;
}

SymmetricTensor<double> Random::tensor() {
  SymmetricTensor<double> t;
  for (double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *entry = normal();
  return t;
}

TetTensors Random::tet_tensors() {
  TetTensors result;
  for (auto& t : result) t = tensor();
  return result;
}

TetMesh reference_tet_mesh(const TetTensors& tensors) {
  return single_tet_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, tensors);
}

TetMesh single_tet_mesh(const std::array<Vector3<double>, 4>& points, const TetTensors& tensors) {
  TetMesh mesh;
  mesh.points.assign(points.begin(), points.end());
  mesh.tensors.assign(tensors.begin(), tensors.end());
  const double volume =
      dot(points[1] - points[0], cross(points[2] - points[0], points[3] - points[0]));
  if (volume > 0) {
    mesh.tets = {{0, 1, 2, 3}};
  } else {
    mesh.tets = {{0, 2, 1, 3}};
  }
  mesh.cell_ids = {0};
  return mesh;
}

TetMesh cube_mesh(int n) {
  TetMesh mesh;
  const auto id = [n](int x, int y, int z) { return (x * (n + 1) + y) * (n + 1) + z; };
  for (int x = 0; x <= n; ++x) {
    for (int y = 0; y <= n; ++y) {
      for (int z = 0; z <= n; ++z) {
        mesh.points.push_back(
            {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  // Each tetrahedron walks from the lower to the upper corner of its cube, one axis at a time;
  // the even orders of the axes are the positively oriented ones.
  constexpr std::array<std::array<int, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int cube = 0; cube < n * n * n; ++cube) {
    const std::array<int, 3> corner{cube / (n * n), cube / n % n, cube % n};
    for (std::size_t order = 0; order < 6; ++order) {
      std::array<int, 3> at = corner;
      std::array<TetMesh::Index, 4> tet{id(at[0], at[1], at[2])};
      for (std::size_t step = 0; step < 3; ++step) {
        ++at[static_cast<std::size_t>(orders[order][step])];
        tet[step + 1] = id(at[0], at[1], at[2]);
      }
      if (order >= 3) std::swap(tet[1], tet[2]);
      mesh.tets.push_back(tet);
      mesh.cell_ids.push_back(static_cast<std::int64_t>(mesh.cell_ids.size()));
    }
  }
  mesh.tensors.resize(mesh.points.size());
  return mesh;
}

void fill_with_normal_tensors(TetMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  mesh.tensors.resize(mesh.points.size());
  for (auto& t : mesh.tensors) t = random.tensor();
}

void fill_with_smooth_tensors(TetMesh& mesh, std::uint64_t seed, int waves, double shortest) {
  Random random(seed);
  struct Wave {
    Vector3<double> vector;
    double phase = 0;
    SymmetricTensor<double> amplitude;
  };
  const SymmetricTensor<double> constant = random.tensor();
  std::vector<Wave> all(static_cast<std::size_t>(waves));
  for (Wave& wave : all) {
    const Vector3<double> direction{random.normal(), random.normal(), random.normal()};
    const double length = std::sqrt(dot(direction, direction));
    const double number = 2 * std::numbers::pi / shortest * random.uniform();
    wave.vector = (number / length) * direction;
    wave.phase = 2 * std::numbers::pi * random.uniform();
    wave.amplitude = random.tensor();
  }
  mesh.tensors.clear();
  for (const auto& point : mesh.points) {
    SymmetricTensor<double> t = constant;
    for (const Wave& wave : all) {
      // Rounded so that the last digits of the sine do not depend on the platform.
      t = t + round_to_24_bits(std::sin(dot(wave.vector, point) + wave.phase)) * wave.amplitude;
    }
    mesh.tensors.push_back(t);
  }
}

SymmetricTensor<double> rounded(const SymmetricTensor<double>& t, int places) {
  const auto entry = [places](double x) {
    return std::ldexp(std::round(std::ldexp(x, places)), -places) + 0.0;
  };
  return {entry(t.xx), entry(t.yy), entry(t.zz), entry(t.xy), entry(t.yz), entry(t.xz)};
}

std::string exact_text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%a", value);
  return buffer;
}

std::string exact_text(const SymmetricTensor<double>& t) {
  std::string text = "{";
  for (const double entry : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) {
    if (text.size() > 1) text += ", ";
    text += exact_text(entry);
  }
  return text + "}";
}

std::string exact_text(const TetTensors& tensors) {
  std::string text = "{{";
  for (const auto& t : tensors) {
    if (text.size() > 2) text += ",\n  ";
    text += exact_text(t);
  }
  return text + "}}";
}

}  // namespace tensortopo::test
