// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "conformance/suite.hpp"

#include "append_format.hpp"

namespace tensortopo {

namespace {

// Sums over cases.
struct Tally {
  std::size_t cases = 0, right = 0;
  std::size_t components = 0, missed = 0, extra = 0, wrong = 0;
  std::size_t holes = 0, non_manifold = 0;
  std::size_t crossings = 0, missed_crossings = 0, extra_crossings = 0;
  std::size_t empty = 0;  ///< nothing given where there is something
  double largest = 0;     ///< sampled distance, either way, over the cell's size
  std::vector<double> distances;

  void add(const SuiteResult& result) {
    const SurfaceScore& s = result.score;
    ++cases;
    right += s.conforms();
    components += s.matched.size() + s.missed.size();
    missed += s.missed.size();
    extra += s.extra.size();
    wrong += s.wrong_topology();
    holes += s.holes;
    non_manifold += s.non_manifold_edges + s.non_manifold_vertices;
    crossings += s.crossings;
    missed_crossings += s.missed_crossings;
    extra_crossings += s.extra_crossings;
    const double distance = std::max(s.to_truth, s.from_truth) / result.cell;
    if (!std::isfinite(distance)) {
      ++empty;
      return;
    }
    distances.push_back(distance);
    largest = std::max(largest, distance);
  }

  /// Median and largest distance as text; a dash where nothing was drawn in any case.
  std::pair<std::string, std::string> distance() const {
    if (distances.empty()) return {"-", "-"};
    auto sorted = distances;
    std::sort(sorted.begin(), sorted.end());
    return {fmt::format("{:.2g}", sorted[sorted.size() / 2]), fmt::format("{:.2g}", largest)};
  }
};

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 100 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

constexpr const char* kIntroduction =
    R"(# What linear contouring gets wrong

Written by `tensortopo conformance --suite examples/suite/suite.json`; `examples/suite/make`
repeats it.

Each case is a mode of a small generated field (`tensortopo generate`), or of a stress field
of `examples/data`. Its truth is certified: components with Euler characteristic and boundary
loops, and the number of crossings on each edge of the mesh. Scored against it are

- **linear contour**: `vtkContourGrid` on the modes at the vertices, the usual way to draw a mode
  surface;
- **subdivided**: the same after cutting each tetrahedron in eight, once, twice, three times (up
  to 512 times the tetrahedra), with the modes of the piecewise linear field at the new vertices;
- **tensortopo**: this library's extraction at its default resolution, on the mesh as it is. It
  shares its proofs with the truth, so its row tests the scoring and the drawing, not the proofs
  (for those see `tests/`).

A case is *right* if every component is there with the right topology, none is added, nothing
is open inside the domain, doubled or pinched, and no edge has a wrong number of crossings. Of
components: *missed*, *extra*, or matched with *another topology*. Of crossings of the mesh's
own edges: *missed* or *extra*. Distances are the larger of the two one-sided ones, sampled at
vertices, edge midpoints and centroids of triangles, in units of the longest edge of the mesh;
cases in which nothing was drawn have none (*empty*).

)";

using Tallies = std::map<std::string, std::map<std::string, Tally>>;

void table(std::string& text, const char* what, const std::vector<std::string>& order,
           const std::vector<std::string>& methods, const Tallies& tallies) {
  append_format(
      text,
      "| {} | method | cases | right | components | missed | extra | other topology | holes | "
      "pinched | crossings | missed | extra | empty | distance, median | largest |\n",
      what);
  text += "|";
  for (int i = 0; i < 16; ++i) text += " --- |";
  text += '\n';
  for (const auto& name : order)
    for (const auto& method : methods) {
      const auto found = tallies.at(name).find(method);
      if (found == tallies.at(name).end()) continue;  // not subdivided so often
      const Tally& t = found->second;
      const auto [median, largest] = t.distance();
      append_format(text,
                    "| {} | {} | {} | {:.0f} % | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} "
                    "| {} | {} |\n",
                    method == methods.front() ? name : "", method, t.cases,
                    percent(t.right, t.cases), t.components, t.missed, t.extra, t.wrong, t.holes,
                    t.non_manifold, t.crossings, t.missed_crossings, t.extra_crossings, t.empty,
                    median, largest);
    }
  text += '\n';
}

}  // namespace

std::string to_markdown(const SuiteReport& report) {
  Tallies by_kind, by_mode, all;
  std::vector<std::string> kinds, modes;
  const auto note = [](std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  std::map<std::string, double> values;
  for (const SuiteResult& result : report.results) {
    const std::string kind = result.name, mode = result.mode.text();
    note(kinds, kind);
    by_kind[kind][result.method].add(result);
    if (!result.generated) continue;
    note(modes, mode);
    values[mode] = result.mode.approx();
    by_mode[mode][result.method].add(result);
    all["all"][result.method].add(result);
  }
  std::sort(modes.begin(), modes.end(),
            [&](const auto& a, const auto& b) { return values[a] < values[b]; });
  std::string text = kIntroduction;
  append_format(
      text,
      "{} cases, of which {} are left out because some tetrahedron is undecided (each is named "
      "in its truth file).\n\n",
      report.cases, report.undecided);
  if (report.results.empty()) return text;
  if (!modes.empty()) {
    text += "All generated fields:\n\n";
    table(text, "", {"all"}, report.methods, all);
  }
  text += "By field; the stress fields are subdivided twice:\n\n";
  table(text, "kind", kinds, report.methods, by_kind);
  if (!modes.empty()) {
    text += "Generated fields by mode:\n\n";
    table(text, "mode", modes, report.methods, by_mode);
  }
  text.pop_back();
  return text;
}

std::string to_json(const SuiteReport& report) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["cases"] = report.cases;
  json["undecided"] = report.undecided;
  json["results"] = Json::array();
  for (const SuiteResult& r : report.results)
    json["results"].push_back({{"name", r.name},
                               {"member", r.member},
                               {"mode", r.mode.text()},
                               {"method", r.method},
                               {"conforms", r.score.conforms()},
                               {"components_missed", r.score.missed.size()},
                               {"components_extra", r.score.extra.size()},
                               {"wrong_topology", r.score.wrong_topology()},
                               {"holes", r.score.holes},
                               {"seam_edges", r.score.seam_edges},
                               {"non_manifold_edges", r.score.non_manifold_edges},
                               {"non_manifold_vertices", r.score.non_manifold_vertices},
                               {"missed_crossings", r.score.missed_crossings},
                               {"extra_crossings", r.score.extra_crossings},
                               {"distance_to_truth", r.score.to_truth},
                               {"distance_from_truth", r.score.from_truth},
                               {"certified_bound_of_truth", r.score.certified},
                               {"longest_edge", r.cell}});
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tensortopo
