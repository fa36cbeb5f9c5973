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
#include "require_folder.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/persistence/linking_number.hpp"

namespace tensortopo {
namespace {

/// A closed polygon and its box.
struct Polygon {
  std::size_t curve = 0;
  std::vector<Vector3<double>> points;
  std::array<double, 3> low{}, high{};
};

std::array<double, 3> coordinates_of(const Vector3<double>& p) { return {p.x, p.y, p.z}; }

bool are_apart(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return true;
  return false;
}

Polygon polygon_of(const CurveMesh& curves, const std::vector<CurveMesh::Index>& line) {
  Polygon polygon;
  for (const auto v : line) polygon.points.push_back(curves.points[as_size(v)]);
  polygon.low = polygon.high = coordinates_of(polygon.points[0]);
  for (const auto& p : polygon.points)
    for (std::size_t i = 0; i < 3; ++i) {
      polygon.low[i] = std::min(polygon.low[i], coordinates_of(p)[i]);
      polygon.high[i] = std::max(polygon.high[i], coordinates_of(p)[i]);
    }
  return polygon;
}

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

void add_curves(GraphReport& report, const PersistenceInput& input, std::vector<Polygon>& closed) {
  for (std::size_t side = 0; side < 2; ++side) {
    const CurveMesh& curves = input.curves[side].curves;
    std::vector<GraphCurve> made;
    for (const ModeMaximum& maximum : input.trees[side].maxima)
      if (maximum.curve)
        made.push_back({side == 0 ? 1 : -1, *maximum.curve, maximum.is_closed, maximum.length});
    count_separations(curves, made);
    for (std::size_t c = 0; c < made.size(); ++c) {
      if (!made[c].is_closed) continue;
      if (const auto line = closed_line(curves, c)) {
        closed.push_back(polygon_of(curves, *line));
        closed.back().curve = report.curves.size() + c;
      }
    }
    report.curves.insert(report.curves.end(), made.begin(), made.end());
  }
}

void write_tree(const ContourTree& tree, const std::filesystem::path& file) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const ContourNode& node : tree.nodes)
    points->InsertNextPoint(node.place.x, node.place.y, node.place.z);
  for (const auto& arc : tree.arcs) {
    lines->InsertNextCell(2);
    for (const std::size_t node : arc) lines->InsertCellPoint(static_cast<vtkIdType>(node));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  add_array(*data, "mode", 1, tree.nodes.size(), [&](std::size_t i) {
    return std::array<double, 3>{tree.nodes[i].mode.middle(), 0, 0};
  });
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("kind");
  for (const ContourNode& node : tree.nodes)
    kinds->InsertNextValue(node.maximum ? 1 : node.minimum ? -1 : 0);
  data->GetPointData()->AddArray(kinds);
  write_poly_data(*data, file);
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
  ReadResult read = read_analyzed(command.input, command.read, report);
  report.output = command.output;
  const PersistenceInput input = persistence_input(read.mesh, progress);
  report.tree = contour_tree(read.mesh, input);
  report.regions = mode_regions(report.tree, input);
  std::vector<Polygon> closed;
  add_curves(report, input, closed);
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
  for (std::size_t i = 0; i < closed.size(); ++i)
    for (std::size_t j = i + 1; j < closed.size(); ++j) {
      ++report.pairs_of_closed;
      if (are_apart(closed[i], closed[j])) continue;
      const auto number = linking_number(closed[i].points, closed[j].points);
      report.not_linkable += !number;
      if (number.value_or(0) != 0)
        report.links.push_back({closed[i].curve, closed[j].curve, *number});
    }
  if (!command.output.empty()) write_tree(report.tree, command.output);
  report.cell_ids = std::move(read.mesh.cell_ids);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
