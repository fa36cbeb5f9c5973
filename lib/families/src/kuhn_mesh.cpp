// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/kuhn_mesh.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

// Each tetrahedron walks from the lowest to the highest corner, one axis at a time; the even orders
// of the axes are the positively oriented ones.
constexpr std::array<std::array<int, 3>, 6> kOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

}  // namespace

TetMesh kuhn_mesh(const std::array<int, 3>& cells,
                  const std::function<Vector3<double>(int, int, int)>& place,
                  const std::function<bool(int, int, int)>& keep) {
  const auto [nx, ny, nz] = cells;
  if (nx < 1 || ny < 1 || nz < 1) throw std::invalid_argument("kuhn_mesh: no cells");
  const std::size_t lattice = as_size(nx + 1) * as_size(ny + 1) * as_size(nz + 1);
  if (lattice > 0x7fffffff) throw std::invalid_argument("kuhn_mesh: more points than an index has");
  const auto id = [ny = ny, nz = nz](const std::array<int, 3>& p) {
    return (as_size(p[0]) * as_size(ny + 1) + as_size(p[1])) * as_size(nz + 1) + as_size(p[2]);
  };
  std::vector<Index> number(lattice, -1);
  TetMesh mesh;
  const auto corner = [&](const std::array<int, 3>& p) {
    Index& n = number[id(p)];
    if (n < 0) {
      n = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(place(p[0], p[1], p[2]));
    }
    return n;
  };
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) {
        if (keep && !keep(x, y, z)) continue;
        for (std::size_t order = 0; order < kOrders.size(); ++order) {
          std::array<int, 3> at{x, y, z};
          std::array<Index, 4> tet{corner(at)};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[as_size(kOrders[order][step])];
            tet[step + 1] = corner(at);
          }
          if (order >= 3) std::swap(tet[1], tet[2]);
          mesh.cell_ids.push_back(static_cast<std::int64_t>(mesh.tets.size()));
          mesh.tets.push_back(tet);
        }
      }
  mesh.tensors.resize(mesh.points.size());
  return mesh;
}

TetMesh kuhn_box(const std::array<int, 3>& cells, const Vector3<double>& low,
                 const Vector3<double>& high) {
  return kuhn_slab(cells, low, high, 0, 1);
}

TetMesh kuhn_slab(const std::array<int, 3>& cells, const Vector3<double>& low,
                  const Vector3<double>& high, int slab, int slabs) {
  if (slabs < 1 || slabs > cells[0] || slab < 0 || slab >= slabs)
    throw std::invalid_argument("kuhn_slab: there is no such slab of hexahedra");
  const auto first_of = [&](int s) {
    return static_cast<int>(static_cast<std::int64_t>(cells[0]) * s / slabs);
  };
  const int first = first_of(slab);
  const auto between = [](double a, double b, int i, int n) {
    return i == n ? b : a + (b - a) * i / n;
  };
  return kuhn_mesh({first_of(slab + 1) - first, cells[1], cells[2]}, [&](int i, int j, int k) {
    return Vector3<double>{between(low.x, high.x, first + i, cells[0]),
                           between(low.y, high.y, j, cells[1]),
                           between(low.z, high.z, k, cells[2])};
  });
}

std::array<int, 3> cells_for(const std::array<int, 3>& proportions, std::size_t tetrahedra) {
  const std::size_t unit =
      6 * as_size(proportions[0]) * as_size(proportions[1]) * as_size(proportions[2]);
  int m = 1;
  while (unit * as_size(m) * as_size(m) * as_size(m) < tetrahedra) ++m;
  return {m * proportions[0], m * proportions[1], m * proportions[2]};
}

void sample_field(TetMesh& mesh,
                  const std::function<SymmetricTensor<double>(const Vector3<double>&)>& field) {
  mesh.tensors.resize(mesh.points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.points.size(), 1024),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i)
                        mesh.tensors[i] = field(mesh.points[i]);
                    });
}

TetMesh side_by_side(std::span<const TetMesh> meshes) {
  TetMesh all;
  int columns = 1;
  while (columns * columns < static_cast<int>(meshes.size())) ++columns;
  for (std::size_t part = 0; part < meshes.size(); ++part) {
    const TetMesh& mesh = meshes[part];
    if (mesh.points.empty()) continue;
    Vector3<double> low = mesh.points.front(), high = low;
    for (const auto& p : mesh.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    int exponent = 0;
    const bool is_power = std::frexp(extent, &exponent) == 0.5;
    const double scale = std::ldexp(1.0, is_power ? 1 - exponent : -exponent);
    const int row = static_cast<int>(part) / columns, column = static_cast<int>(part) % columns;
    const Vector3<double> corner{1.25 * column, 0, -1.25 * row};
    const auto first = static_cast<Index>(all.points.size());
    for (const auto& p : mesh.points) all.points.push_back(scale * (p - low) + corner);
    all.tensors.insert(all.tensors.end(), mesh.tensors.begin(), mesh.tensors.end());
    for (auto tet : mesh.tets) {
      for (Index& v : tet) v += first;
      all.cell_ids.push_back(static_cast<std::int64_t>(all.tets.size()));
      all.tets.push_back(tet);
    }
  }
  return all;
}

}  // namespace tensortopo
