// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "real_field_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/curve_checks.hpp"
#include "extract/curves/exact_degenerate_points.hpp"
#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {

namespace {

using Index = TetMesh::Index;
using Face = std::array<Index, 3>;

TetMesh bundled(const std::string& name) {
  for (const auto& file : bundled_files())
    if (file.filename().string().rfind(name, 0) == 0) return read(file);
  throw std::runtime_error("no bundled field " + name);
}

/// How many vertices of the curves lie inside each face.
std::map<Face, int> points_in_faces(const CurveMesh& curves) {
  std::map<Face, int> result;
  for (std::size_t v = 0; v < curves.points.size(); ++v) {
    const auto& on = curves.carrier_vertices[v];
    if (curves.carrier[v] == Carrier::face) ++result[{on[0], on[1], on[2]}];
  }
  return result;
}

std::set<Face> faces_of(const TetMesh& mesh) {
  std::set<Face> faces;
  for (auto tet : mesh.tets) {
    std::sort(tet.begin(), tet.end());
    for (std::size_t omitted = 0; omitted < 4; ++omitted) {
      Face face{};
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != omitted) face[k++] = tet[i];
      faces.insert(face);
    }
  }
  return faces;
}

/// Every so many elements, so that at most so many remain.
std::vector<Face> thinned(const std::vector<Face>& all, std::size_t most) {
  std::vector<Face> result;
  const std::size_t step = all.size() / most + 1;
  for (std::size_t i = 0; i < all.size(); i += step) result.push_back(all[i]);
  return result;
}

}  // namespace

const SymmetricField& symmetric_block() {
  static const SymmetricField field = made_symmetric(bundled("s1_compress_off"));
  return field;
}

void expect_flawless_surface_of_symmetric_block(const std::string& mode) {
  SCOPED_TRACE("mode " + mode);
  const TetMesh& mesh = symmetric_block().mesh;
  const Extraction extraction = extract(mesh, mode);
  std::cout << extraction.surface.triangles.size() << " triangles, "
            << summary(extraction.surface).components.size() << " components\n";
  EXPECT_FALSE(extraction.surface.triangles.empty());
  EXPECT_EQ(flaws(extraction, mesh), "");
  EXPECT_EQ(unresolved_text(extraction), "");
}

void expect_axis_among_curves_of_symmetric_block(Degeneracy kind) {
  SCOPED_TRACE(mode_of(kind));
  const auto& [mesh, axis] = symmetric_block();
  const auto extraction = extract_degenerate_curves(mesh, kind);
  const CurveMesh& curves = extraction.curves;
  std::cout << curves.lines.size() << " lines, " << curve_invariants(curves).components
            << " components\n";
  EXPECT_TRUE(extraction.unresolved.empty());
  // Tetrahedra on the two sides of a mirror are no images of each other. Where eigenvectors turn
  // in opposite senses on them, a curve in the mirror counts twice, and may end.
  EXPECT_EQ(flaws(extraction, mesh, mode_of(kind), CurveEnds::free), "");
  std::multiset<std::pair<Index, Index>> along;
  for (const auto& line : curves.lines) {
    const auto vertex = [&](Index v) {
      const auto& on = curves.carrier_vertices[static_cast<std::size_t>(v)];
      return on[1] < 0 ? on[0] : -1;
    };
    if (line.size() == 2) along.insert(std::minmax(vertex(line[0]), vertex(line[1])));
  }
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    EXPECT_EQ(along.count(std::minmax(axis[i], axis[i + 1])), mode_of(kind) < 0 ? 1u : 0u);
}

void expect_curves_of_symmetric_block_near_those_of_general_fields(Degeneracy kind) {
  const std::uint64_t seed = 20250601;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  const TetMesh& mesh = symmetric_block().mesh;
  TetMesh near = mesh;
  for (auto& t : near.tensors) t = t + std::ldexp(1.0, -40) * random.tensor();
  ExtractOptions options;
  options.sampling.resolution = 200;  // polylines bend by less than what is asked below
  const auto exact = extract_degenerate_curves(mesh, kind, options);
  const auto nearby = extract_degenerate_curves(near, kind, options);
  EXPECT_TRUE(nearby.unresolved.empty());
  const auto components = away_from(exact.curves, nearby.curves, 5);
  std::cout << components.size() << " components\n";
  EXPECT_GT(components.size(), 10u);
  for (const auto& [component, away] : components)
    EXPECT_TRUE(away.distance < 0.05 || away.length < 0.05)  // of a hundred
        << "away by " << away.distance << ", length " << away.length;
}

void expect_exact_counts_on_faces(const std::string& name, std::size_t most) {
  SCOPED_TRACE(name);
  const TetMesh mesh = bundled(name);
  const auto linear = extract_degenerate_curves(mesh, Degeneracy::linear);
  const auto planar = extract_degenerate_curves(mesh, Degeneracy::planar);
  EXPECT_TRUE(linear.unresolved.empty() && planar.unresolved.empty());
  const auto linear_points = points_in_faces(linear.curves);
  const auto planar_points = points_in_faces(planar.curves);
  const auto in = [](const std::map<Face, int>& counts, const Face& face) {
    const auto found = counts.find(face);
    return found == counts.end() ? 0 : found->second;
  };
  std::vector<Face> passed, others;
  for (const Face& face : faces_of(mesh))
    (in(linear_points, face) + in(planar_points, face) > 0 ? passed : others).push_back(face);
  std::size_t special = 0, counted = 0;
  for (const auto* list : {&passed, &others})
    for (const Face& face : thinned(*list, most)) {
      std::array<SymmetricTensor<double>, 3> corners;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = mesh.tensors[static_cast<std::size_t>(face[i])];
      const auto exact = exact_degenerate_points(corners);
      if (!exact) {
        ++special;
        continue;
      }
      ++counted;
      EXPECT_EQ(in(linear_points, face), exact->linear)
          << face[0] << ' ' << face[1] << ' ' << face[2];
      EXPECT_EQ(in(planar_points, face), exact->planar)
          << face[0] << ' ' << face[1] << ' ' << face[2];
    }
  std::cout << name << ": " << counted << " of " << passed.size() + others.size() << " faces, "
            << passed.size() << " passed through, " << special << " in special position\n";
  EXPECT_GT(counted, 20 * special);
  EXPECT_FALSE(passed.empty());
}

}  // namespace tensortopo::test
