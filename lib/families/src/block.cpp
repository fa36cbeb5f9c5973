// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/block.hpp"

#include <array>
#include <vector>

#include "tensortopo/families/elastic_stress.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"

namespace tensortopo {

namespace {

// A point force downwards on the surface at this height.
struct Force {
  double x = 0, y = 0, surface = 0, size = 0;
};

constexpr int kPerSide = 8;  // forces along a patch's side

// `total` newtons on the square of half width w around (x, y), or on its disc by a paraboloid.
void add_patch(std::vector<Force>& forces, double x, double y, double w, double top, double total,
               bool paraboloid = false) {
  std::vector<Force> patch;
  double sum = 0;
  for (int i = 0; i < kPerSide; ++i)
    for (int j = 0; j < kPerSide; ++j) {
      const double u = (2 * i + 1.0) / kPerSide - 1, v = (2 * j + 1.0) / kPerSide - 1;
      const double pressure = paraboloid ? 1 - u * u - v * v : 1;
      if (pressure <= 0) continue;
      patch.push_back({x + w * u, y + w * v, top + w / 2, pressure});
      sum += pressure;
    }
  for (Force& force : patch) {
    force.size *= total / sum;
    forces.push_back(force);
  }
}

SymmetricTensor<double> stress_of(const std::vector<Force>& forces, double poisson,
                                  const Vector3<double>& p) {
  SymmetricTensor<double> sum;
  for (const Force& f : forces)
    sum = sum + boussinesq_stress<double>({p.x - f.x, p.y - f.y, f.surface - p.z}, f.size, poisson);
  // The half space has its z axis downwards.
  sum.xz = -sum.xz, sum.yz = -sum.yz;
  return sum;
}

TetMesh plain_block(const std::array<int, 3>& proportions, const Vector3<double>& size,
                    std::size_t tetrahedra, const std::vector<Force>& forces) {
  TetMesh mesh = kuhn_box(cells_for(proportions, tetrahedra), {}, size);
  sample_field(mesh, [&](const Vector3<double>& p) { return stress_of(forces, 0.3, p); });
  return mesh;
}

TetMesh slab_block(std::size_t tetrahedra) {
  constexpr double length = 108, width = 68, height = 48, slope = 0.45, slab = 36, top = 60;
  // 9 x 6 x 4 hexahedra and the slab's 3 x 6 x 1 are the smallest.
  std::array<int, 3> cells{9, 6, 4};
  int m = 1;
  const auto count = [&] { return 6 * 234 * static_cast<std::size_t>(m * m * m); };
  while (count() < tetrahedra) ++m;
  for (int& n : cells) n *= m;
  const int third = cells[0] / 3;
  const auto left_edge = [&](double y) { return (length - slab) / 2 + slope * (y - width / 2); };
  const auto place = [&](int i, int j, int k) {
    const double y = width * j / cells[1], left = left_edge(y), right = left + slab;
    const double x = i <= third       ? left * i / third
                     : i <= 2 * third ? left + slab * (i - third) / third
                                      : right + (length - right) * (i - 2 * third) / third;
    return Vector3<double>{x, y, height * k / cells[2]};
  };
  TetMesh mesh = kuhn_mesh({cells[0], cells[1], cells[2] + m}, place, [&](int i, int, int k) {
    return k < cells[2] || (i >= third && i < 2 * third);
  });
  std::vector<Force> forces;
  constexpr int along = 4;
  for (int j = 0; j < along; ++j) {
    const double y = width * (2 * j + 1) / (2 * along);
    add_patch(forces, left_edge(y) + slab / 2, y, slab / 2, top, 2000.0 / along);
  }
  sample_field(mesh, [&](const Vector3<double>& p) { return stress_of(forces, 0.4, p); });
  return mesh;
}

}  // namespace

std::string name_of(Block block) {
  switch (block) {
    case Block::compressed:
      return "s1_compress";
    case Block::pushed_and_pulled:
      return "s2_pushpull";
    case Block::three_loads:
      return "s3_three";
    case Block::slab:
      break;
  }
  return "s4_slab";
}

TetMesh block_field(Block block, std::size_t tetrahedra) {
  std::vector<Force> forces;
  switch (block) {
    case Block::compressed:
      add_patch(forces, 50, 50, 10, 100, 100000);
      return plain_block({4, 4, 5}, {100, 100, 100}, tetrahedra, forces);
    case Block::pushed_and_pulled:
      add_patch(forces, 37.5, 40, 25, 50, 100000, true);
      add_patch(forces, 112.5, 40, 25, 50, -100000, true);
      return plain_block({15, 8, 5}, {150, 80, 50}, tetrahedra, forces);
    case Block::three_loads:
      for (const double x : {160.0 / 6, 80.0, 800.0 / 6}) add_patch(forces, x, 40, 8, 40, 60000);
      return plain_block({4, 2, 1}, {160, 80, 40}, tetrahedra, forces);
    case Block::slab:
      break;
  }
  return slab_block(tetrahedra);
}

}  // namespace tensortopo
