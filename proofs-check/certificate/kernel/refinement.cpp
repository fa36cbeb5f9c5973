// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "refinement.hpp"

#include <algorithm>
#include <cmath>

#include "cut_length.hpp"
#include "field.hpp"

namespace certificate {
namespace {

/// Next to modes 1 and -1 cells around a tube of radius rho, in angles, are some sqrt(rho) long, so
/// it takes 1 / sqrt(rho) times as many; also there their number is bounded.
constexpr double kMaxCells = 40000, kThinTube = 0.25, kMostTimes = 25;
/// Around a point where the level is singular, cuts go on without end, and integers get ever longer.
/// Their words, squared, say about how long each point takes, and a proof by integers some times as
/// long; the sum is bounded. Integers of a few words are left to the bound on cells.
constexpr std::size_t kMaxWork = 1000000, kProofByIntegers = 8;

/// Tensors whose angle has at most this cosine are nearly opposite; a mean of unit tensors that is
/// at most this large nearly vanishes.
constexpr double kNearlyOpposite = -1 + 0x1p-9, kNearlyVanishing = 0x1p-10;

}  // namespace

Refinement::Refinement(const Level& level, std::span<const Corner> roots)
    : level_(level), roots_(roots.begin(), roots.end()) {
  Cell cell{};
  for (std::size_t i = 0; i < roots.size(); ++i) {
    Point point{*roots[i].ball, roots[i].shift, {}, 0, 1U << i, roots[i].above};
    point.length = std::sqrt(product(point.ball, point.ball).value);
    point.weights[i] = 1;
    points_.push_back(std::move(point));
    cell.points[i] = static_cast<Id>(i);
  }
  cells_at_.resize(roots.size());
  add_cell(cell);
}

void Refinement::add_cell(const Cell& cell) {
  for (std::size_t i = 0; i < corners(); ++i) cells_at_[cell.points[i]].push_back(cells_.size());
  cells_.push_back(cell);
}

std::uint64_t Refinement::key(std::span<const Id> ids) {
  std::array<std::uint64_t, 3> sorted{};
  for (std::size_t i = 0; i < ids.size(); ++i) sorted[i] = ids[i] + std::uint64_t{1};  // 0: no third
  std::sort(sorted.begin(), sorted.end());
  return sorted[0] << 42 | sorted[1] << 21 | sorted[2];
}

void Refinement::note(Cell& cell, Proof proof, std::span<const int> along) {
  cell.proof = proof;
  if (proof != Proof::monotone) return;
  long shift = 0;
  for (std::size_t i = 0; i < corners(); ++i) shift = std::max(shift, points_[cell.points[i]].shift);
  std::array<mpz_class, 4> direction;
  for (std::size_t i = 0; i < corners(); ++i) {
    const Point& p = points_[cell.points[i]];
    const mpz_class factor = mpz_class(along[i]) << static_cast<unsigned long>(shift - p.shift);
    for (std::size_t k = 0; k < 4; ++k) direction[k] += factor * p.weights[k];
  }
  cell.direction = std::make_shared<const std::array<mpz_class, 4>>(std::move(direction));
}

Tensor<mpz_class> Refinement::exact(std::uint32_t point) const {
  Tensor<mpz_class> sum{};
  for (std::size_t i = 0; i < corners(); ++i) {
    const mpz_class& weight = points_[point].weights[i];
    if (weight == 0) continue;
    const Tensor<mpz_class> root = roots_[i].exact();
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * root[k];
  }
  return sum;
}

/// A part of a monotone cell that is not proved to be empty stays monotone.
void Refinement::prove(Cell& cell) {
  const auto with = [&](const auto& proved) {
    if (proved.by_integers) work_ += kProofByIntegers * words_squared_;
    if (cell.proof == Proof::open || proved.proof == Proof::empty)
      note(cell, proved.proof, proved.direction);
  };
  const auto& [a, b, c, d] = cell.points;
  if (corners() == 2) return with(level_.prove(corners_at(std::array{a, b}), asks_for_side_));
  if (corners() == 3) return with(level_.prove(corners_at(std::array{a, b, c}), asks_for_side_));
  with(level_.prove(corners_at(cell.points), asks_for_side_));
}

EdgeLevel level_in_edge(const Level& level, const std::array<Corner, 2>& corners,
                        std::size_t words_squared) {
  const auto proved = level.prove(corners);
  EdgeLevel result{proved.proof != Proof::open, corners[0].above != corners[1].above,
                   proved.by_integers ? kProofByIntegers * words_squared : 0};
  if (result.decided) return result;
  Refinement parts(level, corners);
  result = {parts.run(), 0, result.work + parts.work()};
  for (const auto& part : parts.cells())
    if (!part.cut && parts.is_crossed(part)) ++result.crossings;
  return result;
}

bool Refinement::is_settled(Id a, Id b) {
  const auto [place, is_new] = settled_.try_emplace(key(a, b), false);
  if (!is_new) return place->second;
  const EdgeLevel edge = level_in_edge(level_, corners_at(std::array{a, b}), words_squared_);
  work_ += edge.work;
  return place->second = edge.decided && edge.crossings < 2;
}

bool Refinement::is_crossed(const Cell& cell) const {
  for (std::size_t i = 1; i < corners(); ++i)
    if (points_[cell.points[i]].above != points_[cell.points[0]].above) return true;
  return false;
}

/// Is a proof missing?
bool Refinement::is_open(const Cell& cell) {
  if (cell.proof == Proof::open || corners() != 3) return cell.proof == Proof::open;
  const auto& [a, b, c, none] = cell.points;
  return !is_settled(a, b) || !is_settled(b, c) || !is_settled(a, c);
}

Tensor<double> Refinement::unit(Id a) const {
  Tensor<double> result;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = points_[a].ball[i].value / points_[a].length;
  return result;
}

void Refinement::wait(std::size_t c, Waiting& waiting) const {
  Longest longest{-1, c, {}};
  for_subsets(corners(), 2, [&](const auto& members) {
    const Id a = cells_[c].points[members[0]], b = cells_[c].points[members[1]];
    const double length = cut_length(unit(a), unit(b), level_.tube());
    if (!(length <= std::get<double>(longest))) longest = {length, c, {a, b}};
  });
  waiting.push(longest);
}

/// So much of each point, in whole numbers: the finer, the smaller the sum of the tensors is.
void Refinement::round(Place& place) const {
  Tensor<double> sum{};
  double total = 0, all = 0;
  for (std::size_t i = 0; i < place.size; ++i) {
    const Tensor<double> m = unit(place.points[i]);
    for (std::size_t k = 0; k < m.size(); ++k) sum[k] += place.shares[i] * m[k];
    total += place.shares[i];
    all += place.shares[i] /= points_[place.points[i]].length;
  }
  place.smallness = std::sqrt(product(sum, sum)) / total;
  const int bits = 6 - std::ilogb(std::max(place.smallness, 0x1p-44));
  for (double& share : place.shares) share = std::round(std::ldexp(share / all, bits));
}

/// Where an edge is cut: about half way in the angle between the tensors, for these are of similar
/// size, because balls are; a little off the middle, for planes of symmetry lie there. An edge that
/// seems to meet the level twice is cut between, so that each part meets it once. The sum of
/// nearly opposite tensors is to be about as small as it can be: all that happens on such an edge
/// happens there, and cuts elsewhere come near in as many steps as the closeness has bits, for each
/// edge of each cell anew.
Refinement::Place Refinement::place_on(Id a, Id b) const {
  Place place{2, {a, b}, {17, 15}};
  const double cosine = product(unit(a), unit(b));
  const Point &p = points_[a], &q = points_[b];
  for (const double share : {17, 13, 21, 9, 25}) {
    if (p.above != q.above || !(cosine >= kNearlyOpposite)) break;
    Tensor<Ball> m;
    for (std::size_t k = 0; k < m.size(); ++k)
      m[k] = Ball(share, 0) * p.ball[k] + Ball(32 - share, 0) * q.ball[k];
    if (level_.seems_above(m) != p.above) return place.shares = {share, 32 - share}, place;
  }
  if (!(cosine < kNearlyOpposite)) return place;
  const double off = std::sqrt(std::max(1 + cosine, 0x1p-88)) / 32;
  place.shares = {0.5 + off, 0.5 - off};
  round(place);
  return place;
}

/// The point of a face or a cell where the field is smallest, if it nearly vanishes there, for the
/// same reason. It is the least sum of the first point's unit tensor and multiples of the others'.
std::optional<Refinement::Place> Refinement::small_field(std::span<const Id> part) const {
  Place place{part.size(), {}, {1}};
  std::copy(part.begin(), part.end(), place.points.begin());
  // The matrix of products of the others, and right sides: eliminated row by row, as it is positive
  // definite. What comes out is a place to cut, and need not be exact.
  const std::size_t others = part.size() - 1;
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t i = 0; i < others; ++i) {
    for (std::size_t j = 0; j < others; ++j)
      rows[i][j] = i == j ? 1 : product(unit(part[i + 1]), unit(part[j + 1]));
    rows[i][3] = -product(unit(part[i + 1]), unit(part[0]));
  }
  double determinant = 1, sum = 0, least = 1;
  for (std::size_t i = 0; i < others; ++i) {
    const double pivot = rows[i][i];
    determinant *= pivot;
    for (double& x : rows[i]) x /= pivot;
    for (std::size_t j = 0; j < others; ++j)
      for (std::size_t k = 4; j != i && k-- > i;) rows[j][k] -= rows[j][i] * rows[i][k];
  }
  if (!(determinant > 0x1p-8)) return std::nullopt;
  for (std::size_t i = 0; i < others; ++i) {
    place.shares[i + 1] = rows[i][3];
    sum += rows[i][3], least = std::min(least, rows[i][3]);
  }
  if (!(least > (1 + sum) / 64)) return std::nullopt;
  round(place);
  if (!(place.smallness < kNearlyVanishing)) return std::nullopt;
  return place;
}

Refinement::Id Refinement::add_point(const Place& place) {
  Point m;
  long shift = 0;
  double all = 0;
  for (std::size_t i = 0; i < place.size; ++i)
    shift = std::max(shift, points_[place.points[i]].shift);
  for (std::size_t i = 0; i < place.size; ++i) {
    const Point& p = points_[place.points[i]];
    const mpz_class share = mpz_class(place.shares[i])
                            << static_cast<unsigned long>(shift - p.shift);
    for (std::size_t k = 0; k < corners(); ++k) m.weights[k] += share * p.weights[k];
    for (std::size_t k = 0; k < m.ball.size(); ++k)
      m.ball[k] = m.ball[k] + Ball(place.shares[i], 0) * p.ball[k];
    m.support |= p.support;
    all += place.shares[i];
  }
  m.shift = shift + scale_to_one(m.ball);
  std::size_t words = 1 + static_cast<std::size_t>(std::max(m.shift, 0L)) / 64;
  for (const mpz_class& w : m.weights) words = std::max(words, mpz_size(w.get_mpz_t()));
  work_ += words_squared_ = words * words;
  const Id id = static_cast<Id>(points_.size());
  points_.push_back(std::move(m));
  cells_at_.emplace_back();
  Point& stored = points_.back();
  // Errors of doubles are not small compared with such a sum.
  if (all > 32) stored.ball = enclosure(exact(id), stored.shift);
  stored.length = std::sqrt(product(stored.ball, stored.ball).value);
  stored.above = level_.above({&stored.ball, stored.shift, this, id});
  return id;
}

/// Puts a point into an edge, a face or a cell, and so into all cells that have it.
void Refinement::cut(const Place& place, Waiting& waiting) {
  const Id m = add_point(place);
  const std::span part(place.points.begin(), place.size);
  // What is crossed once at most has such parts.
  if (const auto known = place.size == 2 ? settled_.find(key(part)) : settled_.end();
      known != settled_.end() && known->second)
    for (const Id end : part) settled_[key(end, m)] = true;
  for (const std::size_t c : cells_around(part)) {
    const Cell cell = cells_[c];
    cells_[c].cut = true;
    for (const Id old : part) {
      Cell child = cell;
      std::replace(child.points.begin(),
                   child.points.begin() + static_cast<std::ptrdiff_t>(corners()), old, m);
      add_cell(child);
      wait(cells_.size() - 1, waiting);
    }
  }
}

/// Those that are to be cut with this edge, face or cell.
std::vector<std::size_t> Refinement::cells_around(std::span<const Id> part) {
  auto& around = cells_at_[part[0]];
  std::erase_if(around, [&](std::size_t c) { return !is_left(cells_[c]); });
  std::vector<std::size_t> result;
  for (const std::size_t c : around) {
    const auto end = cells_[c].points.begin() + static_cast<std::ptrdiff_t>(corners());
    if (std::all_of(part.begin(), part.end(),
                    [&](Id id) { return std::find(cells_[c].points.begin(), end, id) != end; }))
      result.push_back(c);
  }
  return result;
}

/// Cuts an edge, or first a cell or a face around it in which the field nearly vanishes.
void Refinement::bisect(const std::array<Id, 2>& edge, Waiting& waiting) {
  for (const std::size_t c : cells_around(edge)) {
    if (corners() == 2) break;
    const Cell& cell = cells_[c];
    if (const auto place = small_field(std::span(cell.points.begin(), corners())))
      return cut(*place, waiting);
    for (const Id other : cell.points) {
      if (corners() == 3 || other == edge[0] || other == edge[1]) continue;
      if (const auto place = small_field(std::array{edge[0], edge[1], other}))
        return cut(*place, waiting);
    }
  }
  cut(place_on(edge[0], edge[1]), waiting);
}

/// The cell with the longest edge of all comes first: so each open cell is cut through its own
/// longest edge only, which keeps parts from getting long and thin, in angles.
bool Refinement::run() {
  Waiting waiting;
  wait(0, waiting);
  const double times = std::sqrt(kThinTube / std::sqrt(std::max(level_.tube(), 0.0)));
  const double most = kMaxCells * std::clamp(times, 1.0, kMostTimes);
  while (!waiting.empty()) {
    const auto [length, c, edge] = waiting.top();
    waiting.pop();
    if (!is_left(cells_[c])) continue;
    // A part of a monotone cell may be empty all the same.
    if (cells_[c].proof == Proof::open || !is_crossed(cells_[c])) prove(cells_[c]);
    if (cells_[c].proof == Proof::empty || !is_open(cells_[c])) continue;
    if (static_cast<double>(cells_.size()) > most / (asks_for_side_ ? 12 : 1)) return false;
    if (work_ > kMaxWork / (asks_for_side_ ? 100 : 1)) return false;
    bisect(edge, waiting);
    if (is_left(cells_[c])) wait(c, waiting);  // another cell was cut
    if (asks_for_side_ && points_.back().above != points_.front().above) return false;
  }
  return true;
}

}  // namespace certificate
