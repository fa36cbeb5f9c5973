// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "hex_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace tensortopo::scenarios {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Division i of the interval from 0 to b in n parts; the last is b itself.
double division(double b, int i, int n) { return i == n ? b : i * (b / n); }

// The points (i, j) of each layer from `first` on are numbered from the layer's base; where a layer
// is narrower than the block, `skip` columns are left out on each side.
struct Layer {
  Index base = 0;
  int skip = 0, columns = 0;
  Index point(int i, int j) const { return base + j * columns + (i - skip); }
};

void add_hexes(HexMesh& mesh, const Layer& low, const Layer& high, int from, int to, int rows,
               int material) {
  for (int j = 0; j < rows; ++j)
    for (int i = from; i < to; ++i) {
      mesh.hexes.push_back({low.point(i, j), low.point(i + 1, j), low.point(i + 1, j + 1),
                            low.point(i, j + 1), high.point(i, j), high.point(i + 1, j),
                            high.point(i + 1, j + 1), high.point(i, j + 1)});
      mesh.materials.push_back(material);
    }
}

// Kuhn's six: from corner 0 to corner 6, one axis at a time, turned to positive volume.
constexpr std::array<std::array<int, 4>, 6> kKuhn{
    {{0, 1, 2, 6}, {0, 5, 1, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 4, 5, 6}, {0, 7, 4, 6}}};

}  // namespace

HexMesh box_mesh(const std::array<int, 3>& cells, const Vector3<double>& size) {
  const auto [nx, ny, nz] = cells;
  if (nx < 1 || ny < 1 || nz < 1) throw std::invalid_argument("box_mesh: no cells");
  HexMesh mesh;
  Layer below;
  for (int k = 0; k <= nz; ++k) {
    const Layer layer{static_cast<Index>(mesh.points.size()), 0, nx + 1};
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        mesh.points.push_back(
            {division(size.x, i, nx), division(size.y, j, ny), division(size.z, k, nz)});
    if (k > 0) add_hexes(mesh, below, layer, 0, nx, ny, 0);
    below = layer;
  }
  return mesh;
}

HexMesh slab_mesh(const std::array<int, 3>& cells, int slab_layers, const SlabShape& shape) {
  const auto [nx, ny, nz] = cells;
  if (nx < 3 || nx % 3 != 0 || ny < 1 || nz < 1 || slab_layers < 1)
    throw std::invalid_argument("slab_mesh: the lattice has no thirds");
  const int third = nx / 3;
  const Vector3<double>& block = shape.block;
  const auto x_of = [&, third = third](int i, double y) {
    const double left = (block.x - shape.width) / 2 + shape.slope * (y - block.y / 2);
    const double right = left + shape.width;
    const auto part = [&](int n) { return static_cast<double>(n) / third; };
    if (i <= third) return left * part(i);
    if (i <= 2 * third) return left + shape.width * part(i - third);
    return right + (block.x - right) * part(i - 2 * third);
  };
  HexMesh mesh;
  Layer below;
  for (int k = 0; k <= nz + slab_layers; ++k) {
    const bool in_slab = k > nz;
    const int from = in_slab ? third : 0, to = in_slab ? 2 * third : nx;
    const Layer layer{static_cast<Index>(mesh.points.size()), from, to - from + 1};
    const double z =
        in_slab ? block.z + division(shape.height, k - nz, slab_layers) : division(block.z, k, nz);
    for (int j = 0; j <= ny; ++j) {
      const double y = division(block.y, j, ny);
      for (int i = from; i <= to; ++i) mesh.points.push_back({x_of(i, y), y, z});
    }
    const bool stiff = !in_slab && (2 * k - 1) * block.z / (2 * nz) < shape.stiff_height;
    if (k > 0) add_hexes(mesh, below, layer, from, to, ny, stiff ? 1 : 0);
    below = layer;
  }
  return mesh;
}

TetMesh to_tets(const HexMesh& mesh) {
  TetMesh tets;
  tets.points = mesh.points;
  tets.tets.reserve(kKuhn.size() * mesh.hexes.size());
  for (const auto& hex : mesh.hexes)
    for (const auto& corners : kKuhn) {
      tets.cell_ids.push_back(static_cast<std::int64_t>(tets.tets.size()));
      tets.tets.push_back(
          {hex[at(corners[0])], hex[at(corners[1])], hex[at(corners[2])], hex[at(corners[3])]});
    }
  return tets;
}

std::array<Vector3<double>, 4> top_face(const HexMesh& mesh, Index hex) {
  const auto& corners = mesh.hexes[static_cast<std::size_t>(hex)];
  const auto point = [&](std::size_t c) {
    return mesh.points[static_cast<std::size_t>(corners[c])];
  };
  return {point(4), point(5), point(6), point(7)};
}

std::vector<Index> highest_hexes(const HexMesh& mesh) {
  double top = mesh.points.front().z;
  for (const auto& p : mesh.points) top = std::max(top, p.z);
  std::vector<Index> found;
  for (Index hex = 0; hex < static_cast<Index>(mesh.hexes.size()); ++hex) {
    const auto face = top_face(mesh, hex);
    if (std::all_of(face.begin(), face.end(), [&](const auto& p) { return p.z == top; }))
      found.push_back(hex);
  }
  return found;
}

std::vector<Index> lowest_points(const HexMesh& mesh) {
  double bottom = mesh.points.front().z;
  for (const auto& p : mesh.points) bottom = std::min(bottom, p.z);
  std::vector<Index> found;
  for (Index i = 0; i < static_cast<Index>(mesh.points.size()); ++i)
    if (mesh.points[static_cast<std::size_t>(i)].z == bottom) found.push_back(i);
  return found;
}

}  // namespace tensortopo::scenarios
