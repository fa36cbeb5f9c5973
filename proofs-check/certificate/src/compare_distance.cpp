// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_distance.hpp"

#include <algorithm>
#include <deque>

#include "closed_curves.hpp"
#include "parallel.hpp"

namespace certificate {
namespace {

/// How often a triangle is cut in four, and how many corners that may make.
constexpr int kCuts = 8;
constexpr std::size_t kMaxPoints = 3000;

/// A triangle cut in four, again and again, at exact points.
class Parts : public ExactTensors {
 public:
  Parts(const Level& level, const std::array<Corner, 3>& corners)
      : level_(level), corners_(corners) {
    for (const Corner& corner : corners) shift_ = std::max(shift_, corner.shift);
  }

  /// Is all of it on the side of its corners?
  bool are_one_sided() {
    if (level_.is_one_sided(corners_)) return true;
    constexpr int kOne = 1 << kCuts;
    return split({add({kOne, 0, 0}), add({0, kOne, 0}), add({0, 0, kOne})}, kCuts);
  }

  Tensor<mpz_class> exact(std::uint32_t id) const override {
    Tensor<mpz_class> sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Tensor<mpz_class> t = corners_[i].exact();
      const auto up = static_cast<unsigned long>(shift_ - corners_[i].shift);
      for (std::size_t k = 0; k < 6; ++k) sum[k] += mpz_class(points_[id].weights[i] * t[k]) << up;
    }
    return sum;
  }

 private:
  using Weights = std::array<int, 3>;  ///< of what the balls of the corners enclose
  struct Point {
    Weights weights;
    Tensor<Ball> ball;
  };
  using Triangle = std::array<std::uint32_t, 3>;

  std::uint32_t add(const Weights& weights) {
    Point& point = points_.emplace_back(weights, Tensor<Ball>{});
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 6; ++k)
        point.ball[k] += Ball(weights[i]) * (*corners_[i].ball)[k];
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    Weights sum{};
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] = (points_[a].weights[i] + points_[b].weights[i]) / 2;
    return add(sum);
  }
  bool split(const Triangle& t, int cuts) {
    if (points_.size() > kMaxPoints) return false;
    const std::uint32_t a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
    for (const Triangle& part : {Triangle{a, b, c}, {t[0], c, b}, {t[1], a, c}, {t[2], b, a}})
      if (!is_one_sided(part) && (cuts <= 1 || !split(part, cuts - 1))) return false;
    return true;
  }
  bool is_one_sided(const Triangle& part) const {
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = {&points_[part[i]].ball, shift_, this, part[i], corners_[0].above};
    return level_.is_one_sided(corners);
  }

  const Level& level_;
  std::array<Corner, 3> corners_;
  long shift_ = corners_[0].shift;
  std::deque<Point> points_;
};

class Distances {
 public:
  Distances(const LevelCase& c, const PlacedSurface& placed, const std::vector<bool>& left_out)
      : c_(c), placed_(placed), left_out_(left_out), claim_(*c.claims.distance) {}

  /// What is not so, if anything; and what is not proved to be so.
  std::string wrong();
  std::string unproved();

 private:
  bool is_asked(std::size_t triangle) const {
    const std::size_t tet = placed_.tets[triangle];
    return !left_out_[tet] && !is_coarse_[tet];
  }
  std::array<std::size_t, 3> vertices_of(std::size_t triangle) const {
    std::array<std::size_t, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = c_.surface.triangles[c_.claims.triangles[0] + triangle][i] -
                  c_.claims.vertices[0];
    return result;
  }
  std::string where(std::size_t tet) const {
    return " in tetrahedron " + std::to_string(c_.input.cells[tet]);
  }
  std::string wrong_coarse_bound() const;
  std::string reached_crossing(const MovedVertices& moved) const;

  const LevelCase& c_;
  const PlacedSurface& placed_;
  const std::vector<bool>& left_out_;
  const DistanceClaim& claim_;
  std::vector<bool> is_coarse_, is_used_;
};

std::string Distances::wrong_coarse_bound() const {
  const mpq_class square = mpq_class(claim_.coarse_bound) * mpq_class(claim_.coarse_bound);
  for (std::size_t tet = 0; tet < is_coarse_.size(); ++tet) {
    if (!is_coarse_[tet]) continue;
    const auto& v = c_.input.tets[tet];
    bool longer = false;
    for_subsets(4, 2, [&](const auto& ends) {
      mpq_class sum;
      for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class d = mpq_class(c_.input.points[v[ends[0]]][k]) -
                            mpq_class(c_.input.points[v[ends[1]]][k]);
        sum += d * d;
      }
      longer = longer || sum > square;
    });
    if (longer) return "an edge longer than coarse_bound" + where(tet);
  }
  return {};
}

std::string Distances::wrong() {
  is_coarse_.assign(c_.input.tets.size(), false);
  is_used_.assign(placed_.carriers.size(), false);
  if (claim_.reach.size() != placed_.carriers.size())
    return std::to_string(placed_.carriers.size()) + " vertices";
  for (const Number cell : claim_.coarse) {
    const auto place = std::lower_bound(c_.input.cells.begin(), c_.input.cells.end(), cell);
    if (place == c_.input.cells.end() || *place != cell)
      return "no tetrahedron " + std::to_string(cell);
    is_coarse_[static_cast<std::size_t>(place - c_.input.cells.begin())] = true;
  }
  for (std::size_t t = 0; t < placed_.tets.size(); ++t) {
    if (!is_asked(t)) continue;
    for (const std::size_t v : vertices_of(t)) {
      is_used_[v] = true;
      if (reach_length(claim_.reach[v]) > claim_.bound)
        return "a reach above the bound, of vertex " + std::to_string(c_.claims.vertices[0] + v);
    }
  }
  return wrong_coarse_bound();
}

/// A crossing's vertex moves past no other crossing of its edge: as there are points of
/// different sides at its ends, it passes its own.
std::string Distances::reached_crossing(const MovedVertices& moved) const {
  for (const EdgeClaim& edge : c_.claims.edges) {
    for (std::size_t i = 0; i < edge.crossings.size() && edge.crossings.size() > 1; ++i) {
      const std::size_t v = edge.crossings[i].vertex - c_.claims.vertices[0];
      if (v >= is_used_.size() || !is_used_[v]) continue;
      for (const auto way : {MovedVertices::kBehind, MovedVertices::kAhead}) {
        const auto& w = moved.weights(v, way);
        const mpq_class total = mpq_class(w[0]) + mpq_class(w[1]), at = mpq_class(w[1]) / total;
        const auto bracket_end = [](const CrossingClaim& x, int end) {
          return mpq_class(x.i + end, mpz_class(1) << x.k);
        };
        if ((i > 0 && at < bracket_end(edge.crossings[i - 1], 1)) ||
            (i + 1 < edge.crossings.size() && at > bracket_end(edge.crossings[i + 1], 0)))
          return "vertex " + std::to_string(edge.crossings[i].vertex) + " moves past a crossing";
      }
    }
  }
  return {};
}

std::string Distances::unproved() {
  const MovedVertices moved(c_, placed_);
  std::vector<char> near(placed_.carriers.size(), 1), shown(placed_.tets.size(), 1);
  parallel_for(near.size(), [&](std::size_t v) {
    near[v] = !is_used_[v] || (moved.stays(v) && moved.is_within(v, claim_.bound));
  });
  const auto far = std::find(near.begin(), near.end(), 0) - near.begin();
  if (static_cast<std::size_t>(far) < near.size())
    return "vertex " + std::to_string(c_.claims.vertices[0] + static_cast<std::size_t>(far)) +
           " moves out of its place or bound";
  parallel_for(shown.size(), [&](std::size_t t) {
    if (!is_asked(t)) return;
    const auto [a, b, c] = vertices_of(t);
    for (const auto way : {MovedVertices::kBehind, MovedVertices::kAhead}) {
      const std::array corners{moved.corner(a, way), moved.corner(b, way), moved.corner(c, way)};
      shown[t] = shown[t] && Parts(c_.level, corners).are_one_sided();
    }
  });
  const auto missing = std::count(shown.begin(), shown.end(), 0);
  if (missing > 0) {
    const auto first = static_cast<std::size_t>(std::find(shown.begin(), shown.end(), 0) -
                                                shown.begin());
    return std::to_string(missing) + " triangles not shown to stay clear, the first" +
           where(placed_.tets[first]);
  }
  if (std::string wrong = reached_crossing(moved); !wrong.empty()) return wrong;
  for (const auto& [tet, loops] : placed_.closed_sheets)
    if (!is_coarse_[tet] && !is_covered(c_, moved, tet, loops))
      return "a sheet not shown to be covered" + where(tet);
  return {};
}

}  // namespace

void compare_distance(const LevelCase& c, const PlacedSurface* placed,
                      const std::vector<bool>& left_out, Ledger& ledger) {
  if (placed == nullptr) return ledger.leave_open("distance", "other claims are refuted");
  Distances distances(c, *placed, left_out);
  const std::string claimed = "within " + std::to_string(c.claims.distance->bound);
  if (const std::string wrong = distances.wrong(); !wrong.empty())
    return ledger.refute("distance", claimed, wrong);
  if (const std::string why = distances.unproved(); !why.empty())
    return ledger.leave_open("distance", why);
  ledger.certify();
}

}  // namespace certificate
