// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "symmetric_field.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace tensortopo::test {

namespace {

using Index = TetMesh::Index;
using Tensor = SymmetricTensor<double>;

/// A symmetry of the square: the exchange of x and y, or not, and then mirrors.
struct Symmetry {
  bool exchange, mirror_x, mirror_y;

  /// Where it takes the column (i, j), counted from the middle.
  std::pair<int, int> operator()(std::pair<int, int> column) const {
    if (exchange) std::swap(column.first, column.second);
    return {mirror_x ? -column.first : column.first, mirror_y ? -column.second : column.second};
  }
  Tensor operator()(Tensor t) const {
    if (exchange) {
      std::swap(t.xx, t.yy);
      std::swap(t.xz, t.yz);
    }
    if (mirror_x != mirror_y) t.xy = -t.xy;
    if (mirror_x) t.xz = -t.xz;
    if (mirror_y) t.yz = -t.yz;
    return t;
  }
  /// What undoes it.
  Tensor back(Tensor t) const {
    return Symmetry{exchange, false, false}(Symmetry{false, mirror_x, mirror_y}(t));
  }
};

std::vector<Symmetry> all_symmetries() {
  std::vector<Symmetry> all;
  for (int bits = 0; bits < 8; ++bits)
    all.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0});
  return all;
}

/// A tensor at column (i, j) with 0 <= j <= i that the symmetries which keep the column do not
/// change.
Tensor fixed_by_symmetries(Tensor t, std::pair<int, int> column) {
  const auto [i, j] = column;
  if (i == j) {
    t.xx = t.yy = (t.xx + t.yy) / 2;
    t.xz = t.yz = (t.xz + t.yz) / 2;
  }
  if (i == 0) t.xy = t.xz = 0;
  if (j == 0) t.xy = t.yz = 0;
  return t;
}

class Lattice {
 public:
  explicit Lattice(const TetMesh& mesh) {
    for (const auto& p : mesh.points) xs_.insert(p.x), ys_.insert(p.y), zs_.insert(p.z);
    if (xs_.size() != ys_.size() || xs_.size() % 2 == 0 ||
        xs_.size() * ys_.size() * zs_.size() != mesh.points.size())
      throw std::invalid_argument("made_symmetric: the vertices are no lattice around an axis");
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const auto& p = mesh.points[v];
      vertices_[{p.z, {from_middle(xs_, p.x), from_middle(ys_, p.y)}}] = static_cast<Index>(v);
    }
  }

  int half() const { return static_cast<int>(xs_.size() / 2); }
  const std::set<double>& heights() const { return zs_; }
  std::size_t vertex(double z, std::pair<int, int> column) const {
    return static_cast<std::size_t>(vertices_.at({z, column}));
  }

 private:
  static int from_middle(const std::set<double>& values, double x) {
    return static_cast<int>(std::distance(values.begin(), values.find(x))) -
           static_cast<int>(values.size() / 2);
  }

  std::set<double> xs_, ys_, zs_;
  std::map<std::pair<double, std::pair<int, int>>, Index> vertices_;
};

}  // namespace

SymmetricField made_symmetric(TetMesh mesh) {
  const Lattice lattice(mesh);
  const auto symmetries = all_symmetries();
  const std::vector<Tensor> given = mesh.tensors;
  SymmetricField field;
  for (const double z : lattice.heights()) {
    for (int i = 0; i <= lattice.half(); ++i)
      for (int j = 0; j <= i; ++j) {
        const std::pair column{i, j};
        Tensor sum{};
        for (const auto& g : symmetries) sum = sum + g.back(given[lattice.vertex(z, g(column))]);
        const Tensor mean = fixed_by_symmetries(0.125 * sum, column);
        for (const auto& g : symmetries) mesh.tensors[lattice.vertex(z, g(column))] = g(mean);
      }
    field.axis.push_back(static_cast<Index>(lattice.vertex(z, {0, 0})));
  }
  field.mesh = std::move(mesh);
  return field;
}

}  // namespace tensortopo::test
