// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fine_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "support/oracles/lattice_counter.hpp"
#include "support/oracles/level_sign.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo::test {

namespace {

using Place = std::array<int, 3>;

constexpr std::array<Place, 6> kOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

class FineMesh {
 public:
  FineMesh(const TetMesh& mesh, int cubes, double mode, int parts)
      : cubes_(cubes), parts_(parts), fine_(cubes * parts) {
    const auto corner = [&](const Place& p) {
      return mesh.tensors[static_cast<std::size_t>((p[0] * (cubes + 1) + p[1]) * (cubes + 1) +
                                                   p[2])];
    };
    for (int cube = 0; cube < cubes * cubes * cubes; ++cube)
      for (const Place& order : kOrders) {
        Place at{cube / (cubes * cubes), cube / cubes % cubes, cube % cubes};
        std::array<ExactDeviator, 4> corners{ExactDeviator(corner(at))};
        for (std::size_t step = 0; step < 3; ++step) {
          ++at[static_cast<std::size_t>(order[step])];
          corners[step + 1] = ExactDeviator(corner(at));
        }
        questions_.emplace_back(corners, mode);
      }
    const auto side = static_cast<std::size_t>(fine_ + 1);
    above_.resize(side * side * side);
    for (int x = 0; x <= fine_; ++x)
      for (int y = 0; y <= fine_; ++y)
        for (int z = 0; z <= fine_; ++z) above_[id({x, y, z})] = is_above({x, y, z});
  }

  std::vector<ComponentTopology> components() {
    PolygonCounter counter(above_.size() / 4 + 16);
    for (int x = 0; x < fine_; ++x)
      for (int y = 0; y < fine_; ++y)
        for (int z = 0; z < fine_; ++z)
          for (const Place& order : kOrders) add_tet({x, y, z}, order, counter);
    return counter.components();
  }

 private:
  std::size_t id(const Place& p) const {
    const auto side = static_cast<std::size_t>(fine_ + 1);
    return (static_cast<std::size_t>(p[0]) * side + static_cast<std::size_t>(p[1])) * side +
           static_cast<std::size_t>(p[2]);
  }

  bool is_above(const Place& p) const {
    Place cube{}, rest{};
    for (std::size_t i = 0; i < 3; ++i) {
      cube[i] = std::min(p[i] / parts_, cubes_ - 1);
      rest[i] = p[i] - cube[i] * parts_;
    }
    std::size_t best = 0;
    const auto rest_of = [&](std::size_t order, std::size_t step) {
      return rest[static_cast<std::size_t>(kOrders[order][step])];
    };
    while (rest_of(best, 0) < rest_of(best, 1) || rest_of(best, 1) < rest_of(best, 2)) ++best;
    const int r0 = rest_of(best, 0), r1 = rest_of(best, 1), r2 = rest_of(best, 2);
    const int number = (cube[0] * cubes_ + cube[1]) * cubes_ + cube[2];
    return questions_[static_cast<std::size_t>(number) * 6 + best].is_above(
        std::array<std::int64_t, 4>{parts_ - r0, r0 - r1, r1 - r2, r2});
  }

  void add_tet(Place at, const Place& order, PolygonCounter& counter) const {
    std::array<Place, 4> corners{at};
    std::array<std::uint32_t, 4> mask{0};  // steps taken so far
    for (std::size_t step = 0; step < 3; ++step) {
      ++at[static_cast<std::size_t>(order[step])];
      corners[step + 1] = at;
      mask[step + 1] = mask[step] | 1u << order[step];
    }
    std::vector<std::size_t> up, down;
    for (std::size_t i = 0; i < 4; ++i) (above_[id(corners[i])] ? up : down).push_back(i);
    if (up.empty() || down.empty()) return;
    const auto crossing = [&](std::size_t i, std::size_t j) {
      if (i > j) std::swap(i, j);
      return counter.vertex(static_cast<std::uint32_t>(id(corners[i])) * 8 + (mask[j] ^ mask[i]));
    };
    if (up.size() == 2) {
      const std::array<int, 4> quad{crossing(up[0], down[0]), crossing(up[1], down[0]),
                                    crossing(up[1], down[1]), crossing(up[0], down[1])};
      counter.add_polygon(quad.data(), 4);
    } else {
      const auto& lone = up.size() == 1 ? up : down;
      const auto& others = up.size() == 1 ? down : up;
      const std::array<int, 3> triangle{crossing(lone[0], others[0]), crossing(lone[0], others[1]),
                                        crossing(lone[0], others[2])};
      counter.add_polygon(triangle.data(), 3);
    }
    for (std::size_t omitted = 0; omitted < 4; ++omitted)
      add_side(corners, omitted, crossing, counter);
  }

  // The side of the polygon in one face, if that lies on the boundary of the cube.
  template <class Crossing>
  void add_side(const std::array<Place, 4>& corners, std::size_t omitted, const Crossing& crossing,
                PolygonCounter& counter) const {
    std::array<std::size_t, 3> face{};
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != omitted) face[k++] = i;
    bool outer = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int end : {0, fine_})
        outer = outer || std::all_of(face.begin(), face.end(), [&](std::size_t i) {
                  return corners[i][axis] == end;
                });
    if (!outer) return;
    std::array<int, 2> ends{};
    std::size_t count = 0;
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}})
      if (above_[id(corners[face[i]])] != above_[id(corners[face[j]])])
        ends[count++] = crossing(face[i], face[j]);
    if (count == 2) counter.add_boundary_segment(ends[0], ends[1]);
  }

  int cubes_, parts_, fine_;
  std::vector<LevelQuestion> questions_;  // one a coarse tetrahedron
  std::vector<char> above_;
};

}  // namespace

std::vector<ComponentTopology> fine_components(const TetMesh& mesh, int cubes,
                                               const std::string& mode, int parts) {
  return FineMesh(mesh, cubes, ModeValue::parse(mode).approx(), parts).components();
}

}  // namespace tensortopo::test
