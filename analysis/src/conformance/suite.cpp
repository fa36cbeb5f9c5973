// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

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

constexpr std::array<std::string_view, 7> kKeys{"kind",       "file",         "seed", "count",
                                                "tetrahedra", "subdivisions", "modes"};

/// A number of an entry.
std::int64_t whole_number(const nlohmann::json& item, const char* key, std::int64_t otherwise,
                          std::int64_t least, std::int64_t most) {
  const auto value = item.value(key, nlohmann::json(otherwise));
  // Unsigned numbers of JSON may be larger than what is signed.
  const bool is_known = value.is_number_integer() &&
                        !(value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX);
  if (!is_known || value.get<std::int64_t>() < least || value.get<std::int64_t>() > most)
    throw std::invalid_argument(
        fmt::format("{} must be a whole number from {} to {}", key, least, most));
  return value.get<std::int64_t>();
}

}  // namespace

std::vector<SuiteEntry> read_suite(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  try {
    const auto json = nlohmann::json::parse(text);
    std::vector<SuiteEntry> suite;
    for (const auto& item : json.at("suite")) {
      SuiteEntry entry;
      if (item.contains("file") && item.contains("kind"))
        throw std::invalid_argument("an entry has a kind or a file, not both");
      if (item.contains("file")) {
        entry.file = file.parent_path() / item.at("file").get<std::string>();
        entry.name = entry.file.stem().string();
        if (!std::filesystem::exists(entry.file))
          throw std::invalid_argument(entry.file.string() + ": there is no such file");
      } else {
        entry.name = item.at("kind").get<std::string>();
        const auto kind = field_kind(entry.name);
        if (!kind) throw std::invalid_argument("no kind is called " + entry.name);
        entry.kind = *kind;
      }
      for (const auto& [key, value] : item.items())
        if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
          throw std::invalid_argument("\"" + key + "\" is no key of an entry");
      entry.subdivisions =
          static_cast<int>(whole_number(item, "subdivisions", kSubdivisions, 0, kSubdivisions));
      entry.seed = static_cast<std::uint64_t>(whole_number(item, "seed", 1, 0, INT64_MAX));
      entry.count = static_cast<int>(whole_number(item, "count", 1, 1, 1000000));
      entry.tetrahedra = static_cast<std::size_t>(whole_number(item, "tetrahedra", 0, 0, 10000000));
      if (item.contains("modes") && !item.at("modes").is_array())
        throw std::invalid_argument("modes must be a list");
      if (item.contains("modes"))
        for (const auto& mode : item.at("modes")) {
          entry.modes.push_back(parse_mode(mode.get<std::string>()));
          if (is_degenerate(entry.modes.back()))
            throw std::invalid_argument("mode " + mode.get<std::string>() +
                                        ": has curves, and a suite is of surfaces");
        }
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
