// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "deck.hpp"

#include <fmt/format.h>

#include <string>

#include "surface_pressure.hpp"

namespace tensortopo::scenarios {

namespace {

constexpr std::size_t kWidth = 20;  // characters that CalculiX takes of a number

}  // namespace

std::string deck_number(double x) {
  std::string text = fmt::format("{}", x);
  for (int digits = 16; text.size() > kWidth; --digits) text = fmt::format("{:.{}g}", x, digits);
  return text;
}

std::string deck(const Scenario& scenario, Solver solver) {
  const HexMesh& mesh = scenario.mesh;
  std::string text = fmt::format("*HEADING\n{}\n*NODE, NSET=NALL\n", scenario.name);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto& p = mesh.points[i];
    text += fmt::format("{}, {}, {}, {}\n", i + 1, deck_number(p.x), deck_number(p.y),
                        deck_number(p.z));
  }
  for (std::size_t m = 0; m < scenario.materials.size(); ++m) {
    text += fmt::format("*ELEMENT, TYPE=C3D8I, ELSET=E{}\n", m + 1);
    for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
      if (mesh.materials[h] != static_cast<int>(m)) continue;
      text += std::to_string(h + 1);
      for (const Index corner : mesh.hexes[h]) text += fmt::format(", {}", corner + 1);
      text += "\n";
    }
  }
  text += "*NSET, NSET=BOTTOM\n";
  for (const Index point : lowest_points(mesh)) text += fmt::format("{},\n", point + 1);
  for (std::size_t m = 0; m < scenario.materials.size(); ++m)
    text += fmt::format(
        "*MATERIAL, NAME=M{0}\n*ELASTIC\n{1}, {2}\n"
        "*SOLID SECTION, ELSET=E{0}, MATERIAL=M{0}\n",
        m + 1, deck_number(scenario.materials[m].young),
        deck_number(scenario.materials[m].poisson));
  text += fmt::format("*BOUNDARY\nBOTTOM, 1, 3\n*STEP\n*STATIC, SOLVER={}\n*DLOAD\n",
                      solver == Solver::direct ? "SPOOLES" : "ITERATIVE SCALING");
  // P2 is the face of corners 5 to 8.
  for (const auto& [hex, pressure] : surface_pressures(scenario))
    text += fmt::format("{}, P2, {}\n", hex + 1, deck_number(pressure));
  text +=
      "*RESTART, WRITE, FREQUENCY=1\n"
      "*ELEMENT OUTPUT\nS\n*NODE OUTPUT\nU\n"
      "*NODE PRINT, NSET=BOTTOM, TOTALS=YES\nRF\n*END STEP\n";
  return text;
}

}  // namespace tensortopo::scenarios
