// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/loop_cut.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "topology/tensor_sphere.hpp"

namespace tensortopo::theory {
namespace {

using Matrix = Eigen::Matrix3d;
using Direction = Eigen::Vector3d;
using Edge = std::array<LevelComplex::Index, 2>;
using Face = std::array<LevelComplex::Index, 3>;

Matrix unit_matrix(const Deviator<Integer>& tensor) {
  const BoundedDeviator b = bounded(tensor, binary_size(tensor));
  const Deviator<double> d = {b.a.value, b.b.value, b.xy.value, b.yz.value, b.xz.value};
  const SymmetricTensor<double> t = to_tensor(d);
  Matrix m;
  m << t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz;
  return m / m.norm();
}

double mode_of(const Matrix& t) {
  return 3 * std::sqrt(6.0) * t.determinant() / std::pow(t.norm(), 3);
}

// For mode mu >= 0: the medium eigenvector, of either sign, and sigma = d.N (v x d) for it.
struct Medium {
  Direction vector;
  double sigma;
};
Medium medium_of(const Matrix& t, const Matrix& normal) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(t);
  const Direction v = solver.eigenvectors().col(1), d = solver.eigenvectors().col(2);
  return {v, d.dot(normal * v.cross(d))};
}

class Parts {
 public:
  explicit Parts(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[of(i)] = of(j); }
  int count() {
    int parts = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) parts += of(i) == i ? 1 : 0;
    return parts;
  }

 private:
  std::vector<std::size_t> parent_;
};

// A point of the level on an edge, with the vector of sigma <= 0.
struct Node {
  Matrix tensor;
  Direction lifted;
};

enum class Cut { none, loop, arc };

struct Link {
  std::size_t from, to;
  Cut cut;
  bool is_outer;  ///< in a face of the tetrahedron
};

class Graph {
 public:
  Graph(const LevelComplex& complex, const LoopTetrahedron& t) : complex_(complex), side_(t.side) {
    const auto number = [](const Rational& q) { return q.convert_to<double>(); };
    normal_ = Direction(number(t.values[0]), number(t.values[1]), number(t.values[2])).asDiagonal();
    const double s = number(t.s);
    mu_ = s * (9 - s * s) / std::pow(3 + s * s, 1.5);
    std::map<Face, int> faces;
    for (const auto& cell : complex.cells())
      for (std::size_t k = 0; k < 4; ++k) {
        Face face{};
        for (std::size_t i = 0, n = 0; i < 4; ++i)
          if (i != k) face[n++] = cell[i];
        std::sort(face.begin(), face.end());
        ++faces[face];
      }
    for (const auto& [face, cells] : faces) add_face(face, cells == 1);
    for (const auto& cell : complex.cells()) add_diagonals(cell);
  }

  const std::vector<Link>& links() const { return links_; }
  std::size_t size() const { return nodes_.size(); }

 private:
  void add_face(const Face& face, bool is_outer) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge = {std::min(face[i], face[(i + 1) % 3]),
                         std::max(face[i], face[(i + 1) % 3])};
      if (complex_.is_above(edge[0]) != complex_.is_above(edge[1])) ends.push_back(node_on(edge));
    }
    if (ends.size() == 2) links_.push_back({ends[0], ends[1], cut_between(ends), is_outer});
  }

  // Opposite corners of a disc with four corners: joined across it where the boundary is not met on
  // the way, which its sides alone do not show if the boundary crosses all of them.
  void add_diagonals(const LevelComplex::Cell& cell) {
    std::vector<LevelComplex::Index> above, below;
    for (const auto v : cell) (complex_.is_above(v) ? above : below).push_back(v);
    if (above.size() != 2 || below.size() != 2) return;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      const auto corner = [&](std::size_t i) {
        const auto u = above[i], w = below[(i + k) % 2];
        return node_on({std::min(u, w), std::max(u, w)});
      };
      const std::vector<std::size_t> ends = {corner(0), corner(1)};
      if (!is_met_between(ends)) links_.push_back({ends[0], ends[1], Cut::none, false});
    }
  }

  bool is_met_between(const std::vector<std::size_t>& ends) const {
    bool is_met = false;
    return carried(ends, 1.0 / 32, is_met).dot(nodes_[ends[1]].lifted) <= 0 || is_met;
  }

  std::size_t node_on(const Edge& edge) {
    const auto [place, fresh] = index_.try_emplace(edge, nodes_.size());
    if (!fresh) return place->second;
    const bool rises = complex_.is_above(edge[1]);
    const Matrix from = unit_matrix(complex_.tensor(edge[0])),
                 to = unit_matrix(complex_.tensor(edge[1]));
    double low = 0, high = 1;
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      const bool above = mode_of((1 - middle) * from + middle * to) > mu_;
      (above == rises ? high : low) = middle;
    }
    const Matrix t = (1 - low) * from + low * to;
    const Medium m = medium_of(t, normal_);
    nodes_.push_back({t / t.norm(), m.sigma <= 0 ? m.vector : Direction(-m.vector)});
    return place->second;
  }

  // The vector of the first end at the second one; where sigma becomes positive on the way.
  Direction carried(const std::vector<std::size_t>& ends, double first_step, bool& has_crossed,
                    Direction* crossing = nullptr) const {
    const Node &from = nodes_[ends[0]], &to = nodes_[ends[1]];
    Direction v = from.lifted;
    has_crossed = false;
    for (double at = 0, step = first_step; at < 1;) {
      const double next = std::min(1.0, at + step);
      const Medium m = medium_of((1 - next) * from.tensor + next * to.tensor, normal_);
      const double product = m.vector.dot(v);
      if (std::abs(product) < 0.9 && step > 1e-6) {
        step /= 2;
        continue;
      }
      v = product > 0 ? m.vector : Direction(-m.vector);
      if ((product > 0 ? m.sigma : -m.sigma) > 0 && !has_crossed) {
        has_crossed = true;
        if (crossing != nullptr) *crossing = v;
      }
      at = next;
    }
    return v;
  }

  Cut cut_between(const std::vector<std::size_t>& ends) const {
    bool has_crossed = false;
    Direction crossing = nodes_[ends[0]].lifted;
    const Direction v = carried(ends, 1.0 / 4, has_crossed, &crossing);
    if (v.dot(nodes_[ends[1]].lifted) > 0) return Cut::none;
    return crossing.x() * crossing.z() * side_ > 0 ? Cut::loop : Cut::arc;
  }

  const LevelComplex& complex_;
  int side_;
  Matrix normal_;
  double mu_ = 0;
  std::map<Edge, std::size_t> index_;
  std::vector<Node> nodes_;
  std::vector<Link> links_;
};

}  // namespace

std::optional<LoopCut> cut_along_loops(const LoopTetrahedron& t) {
  LevelComplex complex = tensor_tetrahedron(t.deviators(), ModeLevel::of_parameter(t.s));
  if (!complex.refine(kCellBudget)) return std::nullopt;
  LoopCut result;
  result.surface = level_surface(complex);
  const Graph graph(complex, t);
  Parts sheets(graph.size()), pieces(graph.size()), outer(graph.size());
  std::vector<std::size_t> cuts;
  for (const Link& link : graph.links()) {
    if (link.cut != Cut::loop) sheets.join(link.from, link.to);
    if (link.cut == Cut::none) pieces.join(link.from, link.to);
    if (!link.is_outer) continue;
    outer.join(link.from, link.to);
    if (link.cut == Cut::loop) return std::nullopt;
    if (link.cut == Cut::arc) cuts.push_back(link.from);
  }
  if (cuts.size() != 0 && cuts.size() != 2) return std::nullopt;
  result.sheets = sheets.count();
  result.pieces = pieces.count();
  result.arcs = static_cast<int>(cuts.size() / 2);
  // A closed curve adds one part at most, and so does an arc: more are a sign of cuts unresolved.
  if (result.sheets > result.surface.components + 1) return std::nullopt;
  if (result.pieces > result.sheets + result.arcs) return std::nullopt;
  // A cut from a boundary loop to itself makes two of it, one between two loops joins them.
  result.rims = result.surface.boundary_loops;
  if (result.arcs == 1) result.rims += outer.of(cuts[0]) == outer.of(cuts[1]) ? 1 : -1;
  return result;
}

}  // namespace tensortopo::theory
