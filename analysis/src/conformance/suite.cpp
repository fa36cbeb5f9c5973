// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "contours/vtk_contours.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/read_text.hpp"
#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

namespace {

constexpr int kSubdivisions = 3;
constexpr double kStandardResolution = 16;

double longest_edge(const TetMesh& mesh) {
  double longest = 0;
  for (const auto& tet : mesh.tets)
    for (const auto& [i, j] : kTetEdges) {
      const auto d = mesh.points[static_cast<std::size_t>(tet[static_cast<std::size_t>(i)])] -
                     mesh.points[static_cast<std::size_t>(tet[static_cast<std::size_t>(j)])];
      longest = std::max(longest, dot(d, d));
    }
  return std::sqrt(longest);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names{"linear contour"};
  for (int k = 1; k <= kSubdivisions; ++k) names.push_back(fmt::format("subdivided {}x", k));
  names.emplace_back("tensortopo");
  return names;
}

void score_member(const FamilyMember& member, const SuiteEntry& entry, int number,
                  SuiteReport& report) {
  const auto& modes = entry.modes.empty() ? member.modes : entry.modes;
  std::vector<TetMesh> meshes{member.mesh};
  for (int k = 0; k < entry.subdivisions; ++k) meshes.push_back(subdivide(meshes.back()));
  for (const ModeValue& mode : modes) {
    ++report.cases;
    const Standard standard = certified_standard(member.mesh, mode, kStandardResolution);
    if (!standard.level.undecided.empty()) {
      ++report.undecided;
      continue;
    }
    const auto add = [&](const std::string& method, const SurfaceMesh& surface) {
      report.results.push_back({entry.name, entry.file.empty(), number, mode, method,
                                longest_edge(member.mesh),
                                score_surface(member.mesh, standard, merge_points(surface))});
    };
    for (std::size_t k = 0; k < meshes.size(); ++k)
      add(report.methods[k], vtk_triangles(meshes[k], mode, VtkFilter::contour_grid));
    add(report.methods.back(), extract_mode_surface<double>(member.mesh, mode).surface);
  }
}

}  // namespace

std::vector<SuiteEntry> read_suite(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  try {
    const auto json = nlohmann::json::parse(text);
    std::vector<SuiteEntry> suite;
    for (const auto& item : json.at("suite")) {
      SuiteEntry entry;
      if (item.contains("file")) {
        entry.file = file.parent_path() / item.at("file").get<std::string>();
        entry.name = entry.file.stem().string();
      } else {
        entry.name = item.at("kind").get<std::string>();
        const auto kind = field_kind(entry.name);
        if (!kind) throw std::invalid_argument("no kind is called " + entry.name);
        entry.kind = *kind;
      }
      entry.subdivisions = item.value("subdivisions", kSubdivisions);
      if (entry.subdivisions < 0 || entry.subdivisions > kSubdivisions)
        throw std::invalid_argument("subdivisions must be from 0 to 3");
      entry.seed = item.value("seed", std::uint64_t{1});
      entry.count = item.value("count", 1);
      entry.tetrahedra = item.value("tetrahedra", std::size_t{0});
      if (item.contains("modes"))
        for (const auto& mode : item.at("modes"))
          entry.modes.push_back(parse_mode(mode.get<std::string>()));
      suite.push_back(std::move(entry));
    }
    return suite;
  } catch (const nlohmann::json::parse_error& problem) {
    throw IoError(IoError::Kind::invalid, file,
                  fmt::format("no suite: no JSON (byte {})", problem.byte));
  } catch (const nlohmann::json::exception&) {
    throw IoError(IoError::Kind::invalid, file,
                  "no suite: must be {\"suite\": [{\"kind\" or \"file\": ...}, ...]}, with seed, "
                  "count, tetrahedra, subdivisions and modes");
  } catch (const std::invalid_argument& problem) {
    throw IoError(IoError::Kind::invalid, file, std::string("no suite: ") + problem.what());
  }
}

SuiteReport run_suite(const std::vector<SuiteEntry>& suite, const Progress& progress) {
  SuiteReport report;
  report.methods = method_names();
  for (std::size_t e = 0; e < suite.size(); ++e)
    for (int i = 0; i < suite[e].count; ++i) {
      if (progress)
        progress(suite[e].name, (static_cast<double>(e) + static_cast<double>(i) / suite[e].count) /
                                    static_cast<double>(suite.size()));
      if (!suite[e].file.empty()) {
        score_member({suite[e].name, read_mesh(suite[e].file).mesh, {}}, suite[e], i, report);
        continue;
      }
      FamilyRequest request;
      request.seed = suite[e].seed;
      request.member = i;
      request.members = suite[e].count;
      request.tetrahedra = suite[e].tetrahedra;
      score_member(family_member(suite[e].kind, request), suite[e], i, report);
    }
  return report;
}

}  // namespace tensortopo
