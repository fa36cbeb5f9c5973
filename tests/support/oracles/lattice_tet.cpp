// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

// Marching tetrahedra on the Kuhn subdivision. The tetrahedron is the set n >= x >= y >= z >= 0 of
// the integer lattice, which is a union of the six Kuhn simplices of the unit cubes; a point has
// barycentric coordinates (n - x, x - y, y - z, z).

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "brute_force.hpp"
#include "lattice_counter.hpp"

namespace tensortopo::test {

namespace {

constexpr int leaf = 7;        // cubes a side of a leaf block
constexpr int row = leaf + 1;  // points a side of a leaf block

// The three steps of each Kuhn simplex from the lower to the upper corner of a cube; corner c of
// a cube has the coordinates of its bits (1: x, 2: y, 4: z).
struct KuhnSimplex {
  std::array<int, 4> corners;
  bool x_before_y, y_before_z;
};
constexpr std::array<KuhnSimplex, 6> kuhn{{{{0, 1, 3, 7}, true, true},
                                           {{0, 1, 5, 7}, true, false},
                                           {{0, 2, 3, 7}, false, true},
                                           {{0, 2, 6, 7}, false, true},
                                           {{0, 4, 5, 7}, true, false},
                                           {{0, 4, 6, 7}, false, false}}};

class Marcher {
 public:
  Marcher(const TetCorners& corners, double mode, int n);
  void visit(int x, int y, int z, int size);
  std::vector<ComponentTopology> components() { return counter_.components(); }
  double cell_angle() const;

 private:
  Five<double> tensor_at(double x, double y, double z) const;
  bool is_free(int x, int y, int z, int size) const;
  void visit_leaf(int x, int y, int z);
  void fill_signs(int x, int y, int z);
  void visit_cube(int x, int y, int z, unsigned above);
  void visit_simplex(int x, int y, int z, const KuhnSimplex& simplex, unsigned above,
                     std::array<int, 64>& ids);
  bool is_above(int x, int y, int z) const;

  LevelQuestion question_;
  int n_;
  double signed_square_, lode_;
  Five<double> origin_, dx_, dy_, dz_;
  double half_diagonal_ = 0;  // of a unit cube, in the norm whose square is 3 |T|^2
  PolygonCounter counter_;
  std::array<std::array<unsigned, row>, row> signs_{};  // bit z of [x][y]
  double least_norm_ = 1e300;                           // square, over the leaf blocks visited
};

Marcher::Marcher(const TetCorners& corners, double mode, int n)
    : question_(corners, mode),
      n_(n),
      counter_(static_cast<std::size_t>(2 * n) * static_cast<std::size_t>(n)) {
  signed_square_ = mode * std::abs(mode);
  lode_ = std::acos(mode) / 3;
  long double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const long double c : question_.corner(i)) largest = std::max(largest, std::abs(c));
  }
  int exponent = 0;
  if (largest > 0) std::frexp(largest, &exponent);
  std::array<Five<long double>, 4> t;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t c = 0; c < 5; ++c) t[i][c] = std::ldexp(question_.corner(i)[c], -exponent);
  }
  for (std::size_t c = 0; c < 5; ++c) {
    origin_[c] = static_cast<double>(t[0][c]);
    dx_[c] = static_cast<double>((t[1][c] - t[0][c]) / n);
    dy_[c] = static_cast<double>((t[2][c] - t[1][c]) / n);
    dz_[c] = static_cast<double>((t[3][c] - t[2][c]) / n);
  }
  for (const int sign_y : {-1, 1}) {
    for (const int sign_z : {-1, 1}) {
      Five<double> diagonal;
      for (std::size_t c = 0; c < 5; ++c) diagonal[c] = dx_[c] + sign_y * dy_[c] + sign_z * dz_[c];
      half_diagonal_ = std::max(half_diagonal_, std::sqrt(square_norm(diagonal)) / 2);
    }
  }
}

double Marcher::cell_angle() const { return 2 * half_diagonal_ / std::sqrt(least_norm_); }

Five<double> Marcher::tensor_at(double x, double y, double z) const {
  Five<double> t;
  for (std::size_t c = 0; c < 5; ++c) t[c] = origin_[c] + x * dx_[c] + y * dy_[c] + z * dz_[c];
  return t;
}

// Whether the Lode angle, which changes by at most the angle between tensors, cannot reach that
// of the level anywhere in a block of cubes.
bool Marcher::is_free(int x, int y, int z, int size) const {
  const double half = size / 2.0;
  const Five<double> centre = tensor_at(x + half, y + half, z + half);
  const double p = square_norm(centre), radius = size * half_diagonal_ * (1 + 1e-9);
  if (!(radius * radius < 0.98 * p)) return false;
  const double sine = radius / std::sqrt(p);
  const double mode = std::numbers::sqrt2 * cubic_form(centre) / (p * std::sqrt(p));
  const double angle = std::acos(std::clamp(mode, -1.0, 1.0)) / 3;
  return std::abs(angle - lode_) > std::asin(sine) + 1e-7;
}

void Marcher::visit(int x, int y, int z, int size) {
  // Cubes with x < y or y < z or x >= n lie outside.
  if (x >= n_ || y > x + size - 1 || z > y + size - 1) return;
  if (is_free(x, y, z, size)) return;
  if (size == leaf) {
    visit_leaf(x, y, z);
    return;
  }
  const int half = size / 2;
  for (int child = 0; child < 8; ++child) {
    visit(x + (child & 1) * half, y + ((child >> 1) & 1) * half, z + (child >> 2) * half, half);
  }
}

bool Marcher::is_above(int x, int y, int z) const {
  const std::array<std::int64_t, 4> weights{n_ - x, x - y, y - z, z};
  return question_.is_above(weights);
}

void Marcher::fill_signs(int x, int y, int z) {
  for (int i = 0; i < row; ++i) {
    for (int j = 0; j < row; ++j) {
      const Five<double> start = tensor_at(x + i, y + j, z);
      std::array<double, row> p, g;
      for (std::size_t k = 0; k < row; ++k) {
        Five<double> t;
        for (std::size_t c = 0; c < 5; ++c) t[c] = start[c] + static_cast<double>(k) * dz_[c];
        p[k] = square_norm(t);
        const double q = cubic_form(t);
        g[k] = 2 * q * std::abs(q) - signed_square_ * p[k] * p[k] * p[k];
      }
      unsigned bits = 0, unsure = 0;
      for (std::size_t k = 0; k < row; ++k) {
        bits |= static_cast<unsigned>(g[k] > 0) << k;
        // The largest coordinate of a corner lies in [1/2, 1): rounding moves the tensor by less
        // than 1e-14, hence by less than 1e-11 of itself where p passes, and g by less than
        // 1e-9 p^3.
        const bool sure = p[k] > 1e-6 && std::abs(g[k]) > 1e-9 * p[k] * p[k] * p[k];
        unsure |= static_cast<unsigned>(!sure) << k;
        least_norm_ = std::min(least_norm_, p[k]);
      }
      for (; unsure != 0; unsure &= unsure - 1) {
        const int k = std::countr_zero(unsure);
        const int px = x + i, py = y + j, pz = z + k;
        if (px > n_ || py > px || pz > py) continue;  // outside: never asked for
        const unsigned bit = 1u << k;
        bits = is_above(px, py, pz) ? bits | bit : bits & ~bit;
      }
      signs_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = bits;
    }
  }
}

void Marcher::visit_leaf(int x, int y, int z) {
  fill_signs(x, y, z);
  for (int i = 0; i < leaf && x + i < n_; ++i) {
    for (int j = 0; j < leaf && y + j <= x + i; ++j) {
      const auto si = static_cast<std::size_t>(i), sj = static_cast<std::size_t>(j);
      const unsigned r0 = signs_[si][sj], r1 = signs_[si + 1][sj], r2 = signs_[si][sj + 1],
                     r3 = signs_[si + 1][sj + 1];
      const unsigned any = r0 | r1 | r2 | r3, all = r0 & r1 & r2 & r3;
      unsigned active = (any | any >> 1) & ~(all & all >> 1) & ((1u << leaf) - 1);
      for (; active != 0; active &= active - 1) {
        const int k = std::countr_zero(active);
        if (z + k > y + j) break;
        const unsigned above = (r0 >> k & 1) | (r1 >> k & 1) << 1 | (r2 >> k & 1) << 2 |
                               (r3 >> k & 1) << 3 | (r0 >> k & 2) << 3 | (r1 >> k & 2) << 4 |
                               (r2 >> k & 2) << 5 | (r3 >> k & 2) << 6;
        visit_cube(x + i, y + j, z + k, above);
      }
    }
  }
}

void Marcher::visit_cube(int x, int y, int z, unsigned above) {
  std::array<int, 64> ids;
  ids.fill(-1);
  for (const KuhnSimplex& simplex : kuhn) {
    if ((x == y && !simplex.x_before_y) || (y == z && !simplex.y_before_z)) continue;
    unsigned pattern = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      pattern |= (above >> simplex.corners[i] & 1) << i;
    }
    if (pattern != 0 && pattern != 15) visit_simplex(x, y, z, simplex, pattern, ids);
  }
}

void Marcher::visit_simplex(int x, int y, int z, const KuhnSimplex& simplex, unsigned above,
                            std::array<int, 64>& ids) {
  // The vertex between corners i < j of the simplex: its edge is named by the lower end and the
  // step, as corner bits.
  const auto vertex = [&](std::size_t i, std::size_t j) {
    const int from = simplex.corners[i], step = simplex.corners[j] ^ from;
    int& id = ids[static_cast<std::size_t>(8 * from + step)];
    if (id < 0) {
      const int px = x + (from & 1), py = y + (from >> 1 & 1), pz = z + (from >> 2);
      const int point = (px * (n_ + 1) + py) * (n_ + 1) + pz;
      id =
          counter_.vertex(static_cast<std::uint32_t>(point) * 8 + static_cast<std::uint32_t>(step));
    }
    return id;
  };
  const auto side = [&](std::size_t i) { return above >> i & 1; };
  std::array<int, 4> polygon{};
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (side(i) != side(j)) polygon[static_cast<std::size_t>(count++)] = vertex(i, j);
    }
  }
  counter_.add_polygon(polygon.data(), count);

  if (x != n_ - 1 && x != y && y != z && z != 0) return;
  std::array<unsigned, 4> planes{};  // of the outer planes, those through each corner
  for (std::size_t i = 0; i < 4; ++i) {
    const int c = simplex.corners[i];
    const int px = x + (c & 1), py = y + (c >> 1 & 1), pz = z + (c >> 2);
    planes[i] = static_cast<unsigned>(px == n_) | static_cast<unsigned>(px == py) << 1 |
                static_cast<unsigned>(py == pz) << 2 | static_cast<unsigned>(pz == 0) << 3;
  }
  for (std::size_t opposite = 0; opposite < 4; ++opposite) {
    const std::size_t a = opposite == 0 ? 1 : 0, b = opposite <= 1 ? 2 : 1,
                      c = opposite <= 2 ? 3 : 2;  // a < b < c
    if ((planes[a] & planes[b] & planes[c]) == 0) continue;
    if (side(a) == side(b) && side(b) == side(c)) continue;
    if (side(b) == side(c)) counter_.add_boundary_segment(vertex(a, b), vertex(a, c));
    if (side(a) == side(c)) counter_.add_boundary_segment(vertex(a, b), vertex(b, c));
    if (side(a) == side(b)) counter_.add_boundary_segment(vertex(a, c), vertex(b, c));
  }
}

}  // namespace

LatticeView lattice_view(const TetCorners& corners, double mode, int n) {
  if (n < 1 || n > 800) throw std::invalid_argument("1 to 800 intervals an edge");
  Marcher marcher(corners, mode, n);
  int root = leaf;
  while (root < n) root *= 2;
  marcher.visit(0, 0, 0, root);
  LatticeView view;
  view.topology.components = marcher.components();
  view.cell_angle = marcher.cell_angle();

  const LevelQuestion question(corners, mode);
  std::size_t edge = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j, ++edge) {
      bool last = false;
      for (int step = 0; step <= n; ++step) {
        std::array<std::int64_t, 4> weights{};
        weights[i] = n - step, weights[j] = step;
        const bool next = question.is_above(weights);
        view.topology.edge_crossings[edge] += step > 0 && next != last;
        last = next;
      }
    }
  }
  return view;
}

}  // namespace tensortopo::test
