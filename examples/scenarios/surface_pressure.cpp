// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_pressure.hpp"

#include <array>
#include <map>
#include <stdexcept>

namespace tensortopo::scenarios {

namespace {

using Face = std::array<Vector3<double>, 4>;

constexpr int kSamples = 20;  // along each side of a face

double intensity(const Load& load, double x, double y) {
  const double u = (x - load.x) / load.half_width, v = (y - load.y) / load.half_width;
  switch (load.shape) {
    case Load::Shape::square:
      return u >= -1 && u <= 1 && v >= -1 && v <= 1 ? 1 : 0;
    case Load::Shape::paraboloid:
      return u * u + v * v < 1 ? 1 - u * u - v * v : 0;
    case Load::Shape::everywhere:
      break;
  }
  return 1;
}

// The point of the bilinear face at parameters in [0, 1].
Vector3<double> point_of(const Face& f, double s, double t) {
  return (1 - s) * (1 - t) * f[0] + s * (1 - t) * f[1] + s * t * f[2] + (1 - s) * t * f[3];
}

double mean_intensity(const Load& load, const Face& face) {
  double sum = 0;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const auto p = point_of(face, (i + 0.5) / kSamples, (j + 0.5) / kSamples);
      sum += intensity(load, p.x, p.y);
    }
  return sum / (kSamples * kSamples);
}

// The area vector of a planar quadrilateral: half the product of its diagonals.
Vector3<double> area_vector(const Face& f) { return 0.5 * cross(f[2] - f[0], f[3] - f[1]); }

// The centre of a planar quadrilateral: of its two triangles, by area.
Vector3<double> centre_of(const Face& f) {
  const double a = cross(f[1] - f[0], f[2] - f[0]).z, b = cross(f[2] - f[0], f[3] - f[0]).z;
  const auto first = (1.0 / 3) * (f[0] + f[1] + f[2]), second = (1.0 / 3) * (f[0] + f[2] + f[3]);
  return (1 / (a + b)) * (a * first + b * second);
}

}  // namespace

std::vector<FacePressure> surface_pressures(const Scenario& scenario) {
  std::map<Index, double> on_hex;
  const auto candidates = highest_hexes(scenario.mesh);
  for (const Load& load : scenario.loads) {
    std::map<Index, double> part;
    double force = 0;
    for (const Index hex : candidates) {
      const Face face = top_face(scenario.mesh, hex);
      const double mean = mean_intensity(load, face);
      if (mean == 0) continue;
      part[hex] = mean;
      force += mean * area_vector(face).z;
    }
    if (part.empty())
      throw std::invalid_argument("a load of " + scenario.name + " meets no face of the mesh");
    for (const auto& [hex, mean] : part) on_hex[hex] += mean * (load.force / force);
  }
  std::vector<FacePressure> pressures;
  for (const auto& [hex, pressure] : on_hex) pressures.push_back({hex, pressure});
  return pressures;
}

Wrench resultant(const HexMesh& mesh, const std::vector<FacePressure>& pressures) {
  Wrench sum;
  for (const auto& [hex, pressure] : pressures) {
    const Face face = top_face(mesh, hex);
    const auto force = -pressure * area_vector(face);
    sum.force += force;
    sum.moment += cross(centre_of(face), force);
  }
  return sum;
}

}  // namespace tensortopo::scenarios
