// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "cell_signatures.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {

namespace {

using Index = TetMesh::Index;

template <std::size_t Count>
bool contains(const std::array<Index, 4>& tet, const std::array<Index, Count>& vertices) {
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](Index v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); });
}

}  // namespace

Extraction extract_with_topology(const TetMesh& mesh, const ModeValue& mu) {
  ExtractOptions options;
  options.keep_topology = true;
  return extract_mode_surface<double>(mesh, mu, options);
}

std::vector<std::string> names_of_crossings(const Extraction& extraction) {
  std::vector<std::string> names(extraction.surface.points.size());
  for (const auto& edge : extraction.topology.edges)
    for (std::size_t i = 0; i < edge.crossings.size(); ++i)
      names[as_size(edge.crossings[i].vertex)] = std::to_string(edge.vertices[0]) + "-" +
                                                 std::to_string(edge.vertices[1]) + "/" +
                                                 std::to_string(i);
  return names;
}

std::vector<std::optional<std::string>> cell_signatures(const TetMesh& mesh, const ModeValue& mu,
                                                        const Extraction& extraction) {
  const auto names = names_of_crossings(extraction);
  const LevelTopology& topology = extraction.topology;
  std::map<Index, const LevelTopology::Tet*> sheets;
  for (const auto& tet : topology.tets) sheets[tet.tet] = &tet;
  std::vector<std::optional<std::string>> result(mesh.tets.size(), "");
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    auto& text = *result[t];
    const auto& tet = mesh.tets[t];
    for (const Index v : tet) {
      const double m = mode(deviator(mesh.tensors[as_size(v)]));
      text += m > mu.approx() ? '+' : '-';
    }
    for (const auto& edge : topology.edges) {
      if (!contains(tet, edge.vertices)) continue;
      text +=
          " e" + std::to_string(edge.vertices[0]) + "-" + std::to_string(edge.vertices[1]) + ":";
      for (const auto& crossing : edge.crossings) text += crossing.rising ? '/' : '\\';
    }
    for (const auto& face : topology.faces) {
      if (!contains(tet, face.vertices)) continue;
      std::vector<std::string> arcs;
      for (const auto& arc : face.arcs) {
        std::array<std::string, 2> ends{names[as_size(arc[0])], names[as_size(arc[1])]};
        std::sort(ends.begin(), ends.end());
        arcs.push_back(ends[0] + "~" + ends[1]);
      }
      std::sort(arcs.begin(), arcs.end());
      for (const Index v : face.vertices) text += " " + std::to_string(v);
      text += ":";
      for (const auto& arc : arcs) text += " " + arc;
      text += " loops " + std::to_string(face.loops.size());
    }
    if (const auto found = sheets.find(static_cast<Index>(t)); found != sheets.end()) {
      std::vector<std::string> all;
      for (const auto& sheet : found->second->sheets) {
        std::vector<std::string> loops;
        for (const auto& loop : sheet.loops) {
          // A cycle, from its least step on.
          std::vector<std::string> steps;
          for (const auto& arc : loop)
            steps.push_back(names[as_size(arc.from)] + ">" + std::to_string(arc.opposite));
          std::rotate(steps.begin(), std::min_element(steps.begin(), steps.end()), steps.end());
          loops.emplace_back();
          for (const auto& step : steps) loops.back() += step + " ";
        }
        std::sort(loops.begin(), loops.end());
        std::string one = " sheet " + std::to_string(sheet.euler_characteristic) + ":";
        for (const auto& loop : loops) one += " (" + loop + ")";
        all.push_back(one);
      }
      std::sort(all.begin(), all.end());
      for (const auto& one : all) text += one;
    }
  }
  for (const auto& cell : extraction.unresolved) result[as_size(cell.tet)].reset();
  for (const auto& cone : topology.cones) result[as_size(cone.tet)].reset();
  return result;
}

std::vector<std::optional<std::string>> curve_signatures(const TetMesh& mesh,
                                                         const CurveExtraction& extraction) {
  const CurveMesh& curves = extraction.curves;
  const auto face_of = [&](CurveMesh::Index v) {
    std::string text;
    for (const auto corner : curves.carrier_vertices[as_size(v)])
      text += std::to_string(corner) + " ";
    return text;
  };
  std::vector<std::vector<std::string>> arcs(mesh.tets.size());
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    const auto& line = curves.lines[i];
    const std::string from = face_of(line.front()), to = face_of(line.back());
    arcs[as_size(curves.tet[i])].push_back(
        line.front() == line.back() ? "closed" : std::min(from, to) + "- " + std::max(from, to));
  }
  std::vector<std::optional<std::string>> result(mesh.tets.size(), "");
  for (std::size_t t = 0; t < arcs.size(); ++t) {
    std::sort(arcs[t].begin(), arcs[t].end());
    for (const std::string& arc : arcs[t]) *result[t] += arc + "; ";
  }
  for (const auto& cell : extraction.unresolved) result[as_size(cell.tet)].reset();
  for (const auto& cell : extraction.special) result[as_size(cell.tet)].reset();
  return result;
}

}  // namespace tensortopo::test
