// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/persistence/graph_command.hpp"

#include <vtkCellArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "analyze/poly_data_output.hpp"
#include "origin_notes.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/persistence/linking_number.hpp"

namespace tensortopo {
namespace {

/// A closed curve, and the polygon extracted of it, if it has three vertices.
struct ClosedCurve {
  std::size_t curve = 0;  ///< in the report
  std::vector<Vector3<double>> polygon;
};

void count_separations(const CurveMesh& curves, std::vector<GraphCurve>& components) {
  std::vector<int> last(components.size(), 0);
  for (std::size_t line = 0; line < curves.lines.size(); ++line) {
    const auto c = as_size(curves.component[line]);
    for (const auto v : curves.lines[line]) {
      const double separation = curves.separation[as_size(v)];
      const int sign = separation > 0 ? 1 : separation < 0 ? -1 : 0;
      if (sign == 0) continue;
      ++(sign > 0 ? components[c].wedges : components[c].trisectors);
      components[c].transitions += last[c] == -sign;
      last[c] = sign;
    }
  }
}

using SidesArcs = std::array<std::optional<CurveArcs>, 2>;

void add_curves(GraphReport& report, const PersistenceInput& input, const SidesArcs& arcs,
                CertifiedLinks& links, std::vector<ClosedCurve>& closed) {
  for (std::size_t side = 0; side < 2; ++side) {
    const CurveMesh& curves = input.curves[side].curves;
    std::vector<GraphCurve> made;
    for (const ModeMaximum& maximum : input.trees[side].maxima)
      if (maximum.curve)
        made.push_back(
            {side == 0 ? 1 : -1, *maximum.curve, maximum.is_closed, maximum.length, 0, 0, 0, {}});
    count_separations(curves, made);
    const auto counts =
        count_arcs(*arcs[side], made.size(), report.curves.size(), report.transitions);
    for (std::size_t c = 0; c < made.size(); ++c) {
      made[c].arcs = counts[c];
      if (!made[c].is_closed) continue;
      const auto lines = lines_of_closed(curves, c);
      if (!lines) continue;
      links.add(*arcs[side], *lines);
      closed.push_back({report.curves.size() + c, {}});
      for (const auto v : closed_line(curves, c).value_or(std::vector<CurveMesh::Index>{}))
        closed.back().polygon.push_back(curves.points[as_size(v)]);
    }
    report.curves.insert(report.curves.end(), made.begin(), made.end());
  }
}

/// The linking numbers of all pairs: proved of the curves, or else computed of the polygons.
void add_links(GraphReport& report, CertifiedLinks& links, const std::vector<ClosedCurve>& closed) {
  for (std::size_t i = 0; i < closed.size(); ++i)
    for (std::size_t j = i + 1; j < closed.size(); ++j) {
      ++report.pairs_of_closed;
      CertifiedLink link = links.link(i, j);
      report.certified_pairs += link.number.has_value();
      if (link.obstacle) {
        ++report.link_obstacles[*link.obstacle];
        if (!closed[i].polygon.empty() && !closed[j].polygon.empty())
          link.number = linking_number(closed[i].polygon, closed[j].polygon);
        report.not_linkable += !link.number;
      }
      if (link.number.value_or(0) != 0)
        report.links.push_back({closed[i].curve, closed[j].curve, *link.number, link.obstacle});
    }
}

/// The tree as points and lines, and after its nodes the transitions as points.
void write_tree(const GraphReport& report, const std::filesystem::path& file) {
  const ContourTree& tree = report.tree;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines, transitions;
  for (const ContourNode& node : tree.nodes)
    points->InsertNextPoint(node.place.x, node.place.y, node.place.z);
  for (const CurveTransition& transition : report.transitions) {
    const auto p = transition.place.middle();
    transitions->InsertNextCell(1);
    transitions->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
  }
  for (const auto& arc : tree.arcs) {
    lines->InsertNextCell(2);
    for (const std::size_t node : arc) lines->InsertCellPoint(static_cast<vtkIdType>(node));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  if (!report.transitions.empty()) data->SetVerts(transitions);
  const std::size_t nodes = tree.nodes.size();
  add_array(*data, "mode", 1, nodes + report.transitions.size(), [&](std::size_t i) {
    const double mode = i < nodes ? tree.nodes[i].mode.middle()
                                  : report.curves[report.transitions[i - nodes].curve].mode;
    return std::array<double, 3>{mode, 0, 0};
  });
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("kind");
  for (const ContourNode& node : tree.nodes)
    kinds->InsertNextValue(node.maximum ? 1 : node.minimum ? -1 : 0);
  for (const CurveTransition& transition : report.transitions)
    kinds->InsertNextValue(transition.is_jump ? 3 : 2);
  data->GetPointData()->AddArray(kinds);
  data->GetPointData()->SetActiveScalars("mode");
  write_poly_data(*data, file, origin_notes(report));
}

}  // namespace

GraphReport run_graph(const GraphCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (!command.output.empty()) {
    if (lower_extension(command.output) != ".vtp")
      throw UsageError(command.output.string() + ": the name must end in .vtp");
    require_folder(command.output);
  }
  if (progress) progress("reading", 0);
  GraphReport report;
  report.provenance = command.provenance;
  // In this order the result does not depend on how the mesh is numbered.
  TetMesh mesh = in_canonical_order(read_analyzed(command.input, command.read, report).mesh);
  report.output = command.output;
  const PersistenceInput input = persistence_input(mesh, progress);
  report.tree = contour_tree(mesh, input);
  report.regions = mode_regions(report.tree, input);
  SidesArcs arcs;
  arcs[0].emplace(mesh, Degeneracy::linear, input.curves[0].curves);
  arcs[1].emplace(mesh, Degeneracy::planar, input.curves[1].curves);
  std::vector<ClosedCurve> closed;
  CertifiedLinks links(mesh);
  add_curves(report, input, arcs, links, closed);
  add_links(report, links, closed);
  const auto linear = static_cast<std::size_t>(
      std::count_if(report.curves.begin(), report.curves.end(),
                    [](const GraphCurve& curve) { return curve.mode > 0; }));
  for (const ContourNode& node : report.tree.nodes) {
    std::optional<std::size_t> curve;
    if (node.maximum) curve = input.trees[0].maxima[*node.maximum].curve;
    if (node.minimum)
      if (const auto planar = input.trees[1].maxima[*node.minimum].curve) curve = linear + *planar;
    report.curve_of_node.push_back(curve);
  }
  if (!command.output.empty()) write_tree(report, command.output);
  report.cell_ids = std::move(mesh.cell_ids);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
