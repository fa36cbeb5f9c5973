// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "scenario.hpp"

#include <stdexcept>

namespace tensortopo::scenarios {

namespace {

constexpr Material kSteel{210000, 0.3};
constexpr Material kRubber{10, 0.4};
constexpr Material kBelt{1000, 0.3};  // under the rubber, as steel belts hold a tread block

using Cells = std::array<int, 3>;
using Shape = Load::Shape;

Scenario steel_block(std::string_view name, const Cells& cells, const Vector3<double>& size,
                     std::vector<Load> loads) {
  return {std::string(name), box_mesh(cells, size), {kSteel}, std::move(loads)};
}

// Where no plane of mesh points is the plane of symmetry or antisymmetry (75 and 19 are odd),
// no tensor of the field is special by the choice of the mesh alone.
Scenario push_and_pull(std::string_view name, bool full) {
  constexpr double force = 100000, radius = 25;
  return steel_block(name, full ? Cells{75, 40, 25} : Cells{19, 10, 6}, {150, 80, 50},
                     {{Shape::paraboloid, 37.5, 40, radius, force},
                      {Shape::paraboloid, 112.5, 40, radius, -force}});
}

Scenario compress(std::string_view name, bool full, double x, double y) {
  return steel_block(name, full ? Cells{40, 40, 50} : Cells{10, 10, 12}, {100, 100, 100},
                     {{Shape::square, x, y, 10, 100000}});
}

Scenario three_loads(std::string_view name, bool full) {
  constexpr double length = 160;
  std::vector<Load> loads;
  for (const double x : {length / 6, length / 2, 5 * length / 6})
    loads.push_back({Shape::square, x, 40, 8, 60000});
  return steel_block(name, full ? Cells{80, 40, 20} : Cells{20, 10, 5}, {length, 80, 40},
                     std::move(loads));
}

Scenario slab(std::string_view name, bool full) {
  const SlabShape shape{{108, 68, 48}, 36, 12, 0.45, 8};
  return {std::string(name),
          full ? slab_mesh({54, 34, 24}, 6, shape) : slab_mesh({18, 8, 8}, 2, shape),
          {kRubber, kBelt},
          {{Shape::everywhere, 0, 0, 0, 2000}}};
}

}  // namespace

const std::vector<std::string>& scenario_names() {
  static const std::vector<std::string> names{"s1_compress", "s1_compress_off", "s2_pushpull",
                                              "s3_three", "s4_slab"};
  return names;
}

Scenario make_scenario(std::string_view name, Size size) {
  const bool full = size == Size::full;
  if (name == "s1_compress") return compress(name, full, 50, 50);
  if (name == "s1_compress_off") return compress(name, full, 53.7, 47.9);
  if (name == "s2_pushpull") return push_and_pull(name, full);
  if (name == "s3_three") return three_loads(name, full);
  if (name == "s4_slab") return slab(name, full);
  throw std::invalid_argument("no scenario is called " + std::string(name));
}

}  // namespace tensortopo::scenarios
