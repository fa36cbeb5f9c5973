// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/tensor/symmetric_tensor.hpp"
#include "support/surfaces/topology.hpp"

namespace tensortopo::test {

/// A rational number, such as a mode that tests hand to exact and to floating-point code alike.
struct Fraction {
  std::int64_t numerator = 0, denominator = 1;

  double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
};

/// The field constant + x dx + y dy + z dz, with integer entries: evaluated at points with small
/// dyadic coordinates it is exact in doubles.
struct LinearField {
  SymmetricTensor<double> constant, dx, dy, dz;

  SymmetricTensor<double> at(const Vector3<double>& p) const {
    return constant + p.x * dx + p.y * dy + p.z * dz;
  }
  std::array<SymmetricTensor<double>, 4> at(const std::array<Vector3<double>, 4>& points) const {
    return {at(points[0]), at(points[1]), at(points[2]), at(points[3])};
  }
};

/// What {mode = m} looks like in one tetrahedron.
struct TetCase {
  std::array<Vector3<double>, 4> points;
  Fraction mode;
  std::vector<ComponentTopology> components;  ///< sorted
  int edge_crossings = 0;                     ///< on all six edges
  /// Thin enough that lattices coarser than about 110 intervals an edge get it wrong.
  bool thin = false;
};

/// A point where the gradient of the mode of a 3D linear field vanishes though the mode is not
/// -1 or 1; such a field has at most one, and it is a saddle.
struct Saddle {
  Vector3<double> point;
  double mode = 0;
};

/// A linear field with known mode surfaces in known tetrahedra.
struct FieldWitness {
  std::string name, note;
  LinearField field;
  int rank = 4;  ///< of the four tensors after removing traces
  std::optional<Saddle> saddle;
  std::vector<TetCase> cases;
};

const std::vector<FieldWitness>& field_witnesses();

/// Curves {mode = m} inside one triangle.
struct CurveCase {
  Fraction mode;
  int closed_loops = 0, open_arcs = 0;
  bool tangent = false;  ///< a loop touches an edge from inside at exactly this level
};

enum class CriticalKind { minimum, maximum, saddle };

struct PlanarCriticalPoint {
  CriticalKind kind;
  double mode = 0, x = 0, y = 0;
};

/// A planar linear field constant + x dx + y dy on a triangle.
struct PlanarWitness {
  std::string name, note;
  SymmetricTensor<double> constant, dx, dy;
  std::array<std::array<double, 2>, 3> triangle;
  std::vector<CurveCase> curves;
  std::vector<PlanarCriticalPoint> critical_points;  ///< isolated and finite ones; maybe not all

  SymmetricTensor<double> at(double x, double y) const { return constant + x * dx + y * dy; }
  std::array<SymmetricTensor<double>, 3> corners() const {
    return {at(triangle[0][0], triangle[0][1]), at(triangle[1][0], triangle[1][1]),
            at(triangle[2][0], triangle[2][1])};
  }
};

const std::vector<PlanarWitness>& planar_witnesses();

/// Four tensors in special position, at the vertices of one tetrahedron.
struct StratumWitness {
  std::string name, note;
  std::array<Vector3<double>, 4> points;
  std::array<SymmetricTensor<double>, 4> tensors;
  int rank = 4;                               ///< after removing traces
  std::optional<Fraction> constant_mode;      ///< the mode wherever the deviator is not zero
  std::optional<Vector3<double>> zero_point;  ///< a point of the tetrahedron with zero deviator
  std::optional<Fraction> first_vertex_mode;  ///< the mode at vertex 0, exactly
};

const std::vector<StratumWitness>& stratum_witnesses();

/// The witness with this name; throws std::out_of_range if there is none.
const FieldWitness& field_witness(const std::string& name);
const PlanarWitness& planar_witness(const std::string& name);
const StratumWitness& stratum_witness(const std::string& name);

}  // namespace tensortopo::test
