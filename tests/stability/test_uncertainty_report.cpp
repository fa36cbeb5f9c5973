// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

#include "slab_with_radii.hpp"
#include "support/compared.hpp"
#include "support/folder.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_surface_file.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

ExtractCommand slab(const Folder& folder, const std::string& uncertainty) {
  ExtractCommand command;
  command.input = slab_file();
  command.output = folder / "surface.vtp";
  command.modes = {ModeValue::parse("1/2"), ModeValue::parse("0")};
  command.uncertainty = uncertainty;
  return command;
}

TEST(Uncertainty, IsInTheReportAndInTheFile) {
  const Folder folder;
  Compared compared("surfaces with parts that are stable and others");
  for (const char* radius : {"0.01%", "1%", "2000"}) {
    const ExtractReport report = run_extract(slab(folder, radius));
    const SurfaceFile file = read_surface_file(report.output);
    const SurfaceArray* stable = file.find_cell_data("stable");
    const SurfaceArray* instability = file.find_cell_data("instability");
    ASSERT_NE(stable, nullptr);
    ASSERT_NE(instability, nullptr);
    ASSERT_EQ(stable->values.size(), file.polygons.size());
    for (std::size_t i = 0; i < stable->values.size(); ++i)
      EXPECT_EQ(stable->values[i], instability->values[i] == 0 ? 1 : 0);
    const SurfaceArray* crossings = file.find_point_data("crossing_stable");
    const SurfaceArray* reasons_why = file.find_point_data("crossing_instability");
    ASSERT_NE(crossings, nullptr);
    ASSERT_NE(reasons_why, nullptr);
    ASSERT_EQ(crossings->values.size(), file.points.size());
    std::array<std::size_t, 3> told{};  // no crossing, not stable, stable
    for (std::size_t v = 0; v < crossings->values.size(); ++v) {
      const double reason = reasons_why->values[v];
      EXPECT_EQ(crossings->values[v], reason < 0 ? -1 : reason == 0 ? 1 : 0);
      ++told[static_cast<std::size_t>(crossings->values[v] + 1)];
    }
    std::size_t stable_crossings = 0, other_crossings = 0;
    for (const SurfaceReport& surface : report.surfaces) {
      const StabilitySummary& s = surface.stability->summary;
      stable_crossings += s.stable_crossings;
      for (const auto& [reason, count] : s.crossing_reasons) other_crossings += count;
    }
    EXPECT_EQ(told[2], stable_crossings);
    EXPECT_EQ(told[1], other_crossings);
    EXPECT_GT(told[1] + told[2], 0u);
    std::size_t triangles = 0;
    for (const SurfaceReport& surface : report.surfaces) {
      ASSERT_TRUE(surface.stability);
      const StabilitySummary& s = surface.stability->summary;
      EXPECT_EQ(surface.stability->radius, radius);
      EXPECT_EQ(s.stable_tets + s.unstable_tets, report.tetrahedra);
      std::size_t reasons = 0;
      for (const auto& [reason, count] : s.reasons) reasons += count;
      EXPECT_EQ(reasons, s.unstable_tets);
      EXPECT_LE(s.crossed_stable_tets, surface.statistics.tets_crossed);
      EXPECT_LE(s.components.size(), surface.invariants.components);
      // A component of stable triangles only is stable: nothing is left out here.
      EXPECT_TRUE(report.unresolved.empty());
      std::vector<char> all_stable(surface.invariants.components, 1);
      const SurfaceArray* component = file.find_cell_data("component");
      std::size_t first = triangles;
      const double least = component->values[first];
      for (; triangles < first + surface.triangles; ++triangles)
        if (stable->values[triangles] == 0)
          all_stable[static_cast<std::size_t>(component->values[triangles] - least)] = 0;
      EXPECT_EQ(static_cast<std::size_t>(std::accumulate(all_stable.begin(), all_stable.end(), 0)),
                s.components.size());
      compared.count(s.crossed_stable_tets > 0 && s.unstable_tets > 0);
    }
  }
}

TEST(Uncertainty, OfAnArrayIsThatOfTheRadiiAtTheVertices) {
  const Folder folder;
  const std::vector<double> radii = slab_radii();
  ExtractCommand command = slab(folder, "array:error");
  command.input = write_slab(folder / "slab.vtk", radii);
  const ExtractReport report = run_extract(command);
  const TetMesh mesh = read_mesh(command.input).mesh;
  const UncertainField field(mesh, radii);
  Compared compared("levels with parts that are stable and others", 2);
  for (std::size_t i = 0; i < report.surfaces.size(); ++i) {
    const LevelStability level = level_stability(field, command.modes[i]);
    const auto stable = static_cast<std::size_t>(
        std::count(level.tets.begin(), level.tets.end(), Stability::stable));
    EXPECT_EQ(report.surfaces[i].stability->summary.stable_tets, stable);
    compared.count(stable > 0 && stable < mesh.tets.size());
  }
}

TEST(Uncertainty, OfAnArrayThatHasNoRadiiIsRefused) {
  const Folder folder;
  const std::vector<double> radii = slab_radii();
  ExtractCommand command = slab(folder, "array:error");
  const auto refused = [&](const std::string& name, const std::vector<double>& given) {
    command.uncertainty = "array:" + name;
    command.input = write_slab(folder / "slab.vtk", given);
    EXPECT_THROW(run_extract(command), IoError) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / "surface.vtp")) << name;
  };
  refused("other", radii);
  refused("S", radii);  // the tensors
  std::vector<double> wrong = radii;
  wrong.pop_back();
  refused("error", wrong);
  for (const double value : {-1e-300, std::nan(""), HUGE_VAL}) {
    wrong = radii, wrong[5] = value;
    refused("error", wrong);
  }
  command.uncertainty = "array:";
  EXPECT_THROW(run_extract(command), UsageError);
}

TEST(Uncertainty, ThatIsNoneOfItsFormsIsBadUsage) {
  const Folder folder;
  for (const char* text : {"-1", "1 %", "%", "nan", "1e400", "one", "-0.1%", "1%%"}) {
    EXPECT_THROW(run_extract(slab(folder, text)), UsageError) << text;
    EXPECT_FALSE(std::filesystem::exists(folder / "surface.vtp")) << text;
  }
}

TEST(Uncertainty, OfCurvesIsInTheReportAndBesideThatOfASurface) {
  const Folder folder;
  Compared compared("kinds with parts that are stable and others");
  for (const char* radius : {"0.0001%", "0.1%", "1%"}) {
    ExtractCommand command = slab(folder, radius);
    command.modes = {ModeValue::parse("1"), ModeValue::parse("1/2"), ModeValue::parse("-1")};
    const ExtractReport report = run_extract(command);
    const SurfaceFile file = read_surface_file(report.output);
    const SurfaceArray* stable = file.find_cell_data("stable");
    const SurfaceArray* component = file.find_cell_data("component");
    ASSERT_NE(stable, nullptr);
    ASSERT_EQ(stable->values.size(), file.lines.size() + file.polygons.size());
    // Vertices of the surface come first, and each kind has its own crossings.
    const SurfaceArray* crossings = file.find_point_data("crossing_stable");
    ASSERT_NE(crossings, nullptr);
    ASSERT_EQ(crossings->values.size(), file.points.size());
    std::size_t of_reports = 0;
    for (const SurfaceReport& surface : report.surfaces)
      of_reports += surface.stability->summary.stable_crossings;
    for (const CurveReport& curves : report.curves)
      of_reports += curves.stability->summary.stable_crossings;
    EXPECT_EQ(static_cast<std::size_t>(
                  std::count(crossings->values.begin(), crossings->values.end(), 1.0)),
              of_reports);
    // Lines come first, and of them those of mode 1; components of curves follow the surface's.
    std::map<double, bool> all_stable;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const auto [found, fresh] = all_stable.emplace(component->values[i], true);
      found->second = found->second && stable->values[i] != 0;
    }
    std::size_t of_stable_lines = 0, claimed = 0;
    for (const auto& [number, is_stable] : all_stable) of_stable_lines += is_stable;
    for (const CurveReport& curves : report.curves) {
      ASSERT_TRUE(curves.stability);
      const StabilitySummary& s = curves.stability->summary;
      EXPECT_EQ(s.stable_tets + s.unstable_tets, report.tetrahedra);
      EXPECT_LE(s.stable_crossings, s.crossings);
      EXPECT_LE(s.components.size(), curves.invariants.components);
      claimed += s.components.size();
      compared.count(s.crossed_stable_tets > 0 && s.unstable_tets > 0);
    }
    EXPECT_LE(claimed, of_stable_lines);
    const bool is_complete = std::all_of(report.curves.begin(), report.curves.end(),
                                         [](const CurveReport& c) { return c.unresolved.empty(); });
    EXPECT_TRUE(!is_complete || claimed == of_stable_lines);
  }
}

}  // namespace
}  // namespace tensortopo::test
