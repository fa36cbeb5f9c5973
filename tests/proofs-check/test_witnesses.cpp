// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What a refutation names, looked at by other means.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <regex>
#include <string>

#include "proofs-check/forgeries/lies.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

double certificate_mode(const std::string& text) {
  const auto slash = text.find('/');
  return std::stod(text) / (slash == text.npos ? 1 : std::stod(text.substr(slash + 1)));
}

/// The mode by the formula of FORMAT.md.
double mode_at(const TetMesh& mesh, const std::vector<std::size_t>& vertices,
               const std::vector<double>& weights) {
  SymmetricTensor<double> t{};
  double total = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& v = mesh.tensors[vertices[i]];
    t.xx += weights[i] * v.xx, t.yy += weights[i] * v.yy, t.zz += weights[i] * v.zz;
    t.xy += weights[i] * v.xy, t.yz += weights[i] * v.yz, t.xz += weights[i] * v.xz;
    total += weights[i];
  }
  const double mean = (t.xx + t.yy + t.zz) / 3;
  const double x = (t.xx - mean) / total, y = (t.yy - mean) / total, z = (t.zz - mean) / total,
               xy = t.xy / total, yz = t.yz / total, xz = t.xz / total;
  const double norm = x * x + y * y + z * z + 2 * (xy * xy + yz * yz + xz * xz);
  const double det = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
  return 3 * std::sqrt(6.0) * det / std::pow(norm, 1.5);
}

/// Which points a report names, and whether each is on the side that it says. A point as near to
/// the level as 1e-9 is not counted.
std::size_t count_points(const std::string& report, const TetMesh& mesh, double mu) {
  static const std::regex kPlace(R"(at weights of the vertices (\[[0-9,]+\]): ([^;\n]*))"),
      kPoint(R"((\[[0-9,]+\]) (above|below))");
  std::size_t count = 0;
  for (std::sregex_iterator p(report.begin(), report.end(), kPlace), end; p != end; ++p) {
    const auto vertices = Json::parse((*p)[1].str()).get<std::vector<std::size_t>>();
    const std::string points = (*p)[2];
    for (std::sregex_iterator q(points.begin(), points.end(), kPoint); q != end; ++q) {
      const auto weights = Json::parse((*q)[1].str()).get<std::vector<double>>();
      EXPECT_EQ(weights.size(), vertices.size()) << report;
      const double over = mode_at(mesh, vertices, weights) - mu;
      if (std::abs(over) < 1e-9) continue;
      EXPECT_EQ(over > 0, (*q)[2] == "above") << over << '\n' << report;
      ++count;
    }
  }
  return count;
}

/// A vertex, a number, an exact point: no refutation is without one beside what was claimed.
TEST(Witnesses, AreNamedByEachRefutation) {
  std::vector<LieRow> rows = lies_of_claims();
  for (auto more : {lies_of_files(), lies_across()})
    rows.insert(rows.end(), more.begin(), more.end());
  Court court("witnesses");
  Pick pick(77);
  std::size_t refutations = 0, points = 0;
  for (std::size_t n = 0; n < rows.size() * 3; ++n) {
    const auto& all = honest_exhibits();
    Exhibit forged = all[(n / rows.size() + n) % all.size()];
    if (!rows[n % rows.size()].tell(forged, pick)) continue;
    court.verdict(forged);
    const std::string report = court.report();
    for (std::size_t at = 0; (at = report.find("refuted: ", at)) != std::string::npos; ++at) {
      if (at > 0 && report[at - 1] != '\n') continue;
      const std::string line = report.substr(at, report.find('\n', at) - at);
      const auto derived = line.find("; derived ");
      if (derived == std::string::npos) continue;  // the first line
      ++refutations;
      const bool names_number =
          std::any_of(line.begin() + static_cast<std::ptrdiff_t>(derived), line.end(),
                      [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
      const bool is_of_words = line.find("array '") != std::string::npos ||
                               line.find("'s sha256") != std::string::npos ||
                               line.find("the key is left out") != std::string::npos ||
                               line.find("claimed of modes only") != std::string::npos;
      EXPECT_TRUE(names_number || is_of_words) << rows[n % rows.size()].field << '\n' << line;
    }
    const auto& levels = forged.certificate["levels"];
    if (levels.size() != 1 || !levels[0].contains("mode")) continue;
    points += count_points(report, forged.mesh, certificate_mode(levels[0]["mode"]));
  }
  EXPECT_GT(refutations, 100u);
  EXPECT_GT(points, 50u);
}

/// The largest difference of modes at the vertices, in each tetrahedron with a triangle there.
double largest_residual(const Exhibit& e, double mu) {
  double largest = 0;
  for (std::size_t t = 0; t < e.surface.triangles.size(); ++t) {
    const auto& tet = e.mesh.tets[as_size(e.surface.tet[t])];
    std::array<Vector3<double>, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = e.mesh.points[as_size(tet[i])];
    for (const auto v : e.surface.triangles[t]) {
      std::vector<double> weights;
      for (std::size_t i = 0; i < 4; ++i) {
        auto q = p;
        q[i] = e.surface.points[as_size(v)];
        weights.push_back(dot(q[1] - q[0], cross(q[2] - q[0], q[3] - q[0])));
      }
      const double mode =
          mode_at(e.mesh, std::vector<std::size_t>(tet.begin(), tet.end()), weights);
      if (std::isfinite(mode)) largest = std::max(largest, std::abs(mode - mu));
    }
  }
  return largest;
}

/// A bound of what is so at the vertices as they are written, and a sharp one.
TEST(Residual, IsABoundAtTheVerticesAsTheyAre) {
  Court court("residual");
  std::size_t compared = 0;
  for (const Exhibit& honest : honest_exhibits()) {
    const auto& levels = honest.certificate["levels"];
    if (levels.size() != 1 || !levels[0].contains("mode") || !levels[0]["cones"].empty()) continue;
    const auto mu = certificate_mode(levels[0]["mode"]);
    for (const double by : {0.0, 1e-9, 1e-3}) {
      Exhibit e = honest;
      for (auto& p : e.surface.points) p.x += by;
      e.rehash();
      court.verdict(e);
      const std::string report = court.report(), key = "residual at most ";
      const auto at = report.find(key);
      ASSERT_NE(at, std::string::npos) << report;
      const double bound = std::stod(report.substr(at + key.size()));
      const double exact = largest_residual(e, mu);
      EXPECT_GE(bound, exact - 1e-12) << report;
      EXPECT_LE(bound, 1.02 * exact + 1e-8) << report;  // three digits are printed, rounded up
      ++compared;
    }
  }
  EXPECT_GT(compared, 8u);
}

}  // namespace
}  // namespace tensortopo::test
