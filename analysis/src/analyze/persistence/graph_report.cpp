// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analyze/persistence/graph_command.hpp"
#include "append_format.hpp"
#include "counted.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {
namespace {

const char* kind_of(const ContourNode& node) {
  if (node.maximum) return "maximum";
  return node.minimum ? "minimum" : "saddle";
}

}  // namespace

std::string to_json(const GraphReport& report) {
  using Object = nlohmann::ordered_json;
  Object json;
  json["input"] = analyzed_mesh_json(report);
  json["complete"] = report.tree.is_complete;
  json["loops_in_mesh"] = report.tree.has_loops;
  json["nodes"] = Object::array();
  for (std::size_t i = 0; i < report.tree.nodes.size(); ++i) {
    const ContourNode& node = report.tree.nodes[i];
    Object row{{"kind", kind_of(node)}};
    row["mode"] = node.mode.middle();
    row["range"] = {node.mode.low, node.mode.high};
    row["point"] = {node.place.x, node.place.y, node.place.z};
    row["tet"] = node.tet < 0 ? Object(nullptr) : Object(report.cell_ids[as_size(node.tet)]);
    const auto& curve = report.curve_of_node[i];
    row["curve"] = curve ? Object(*curve) : Object(nullptr);
    json["nodes"].push_back(std::move(row));
  }
  json["arcs"] = Object::array();
  for (const auto& arc : report.tree.arcs) json["arcs"].push_back({arc[0], arc[1]});
  const auto linear = static_cast<std::size_t>(
      std::count_if(report.curves.begin(), report.curves.end(),
                    [](const GraphCurve& curve) { return curve.mode > 0; }));
  json["regions"] = Object::array();
  for (const ModeRegion& region : report.regions.regions) {
    Object row{{"sign", region.sign}};
    row["curves"] = Object::array();
    for (const std::size_t c : region.curves)
      row["curves"].push_back(region.sign > 0 ? c : linear + c);
    row["nodes"] = region.nodes.size();
    json["regions"].push_back(std::move(row));
  }
  json["regions_complete"] = report.regions.is_complete;
  json["borders"] = Object::array();
  for (const RegionBorder& border : report.regions.borders)
    json["borders"].push_back({border.positive, border.negative});
  json["curves"] = Object::array();
  for (const GraphCurve& curve : report.curves)
    json["curves"].push_back({{"mode", curve.mode},
                              {"component", curve.component},
                              {"closed", curve.is_closed},
                              {"length", curve.length},
                              {"wedge_vertices", curve.wedges},
                              {"trisector_vertices", curve.trisectors},
                              {"transitions", curve.transitions},
                              {"wedge_arcs", curve.arcs.wedges},
                              {"trisector_arcs", curve.arcs.trisectors},
                              {"mixed_arcs", curve.arcs.mixed},
                              {"arcs_not_proved", curve.arcs.not_proved},
                              {"proved_transitions", curve.arcs.zeros},
                              {"jumps", curve.arcs.jumps}});
  json["transitions"] = Object::array();
  for (const CurveTransition& transition : report.transitions) {
    const auto point = transition.place.middle();
    Object row{{"curve", transition.curve}, {"kind", transition.is_jump ? "jump" : "zero"}};
    row["point"] = {point.x, point.y, point.z};
    row["within"] = transition.radius();
    row["tets"] = Object::array();
    for (const auto t : transition.tets) row["tets"].push_back(report.cell_ids[as_size(t)]);
    json["transitions"].push_back(std::move(row));
  }
  json["links"] = Object::array();
  for (const CurveLink& link : report.links)
    json["links"].push_back(
        {{"curves", {link.first, link.second}},
         {"number", link.number},
         {"status", link.obstacle ? "undecided" : "certified"},
         {"reason", link.obstacle ? Object(name_of(*link.obstacle)) : Object(nullptr)}});
  json["pairs_of_closed_curves"] = report.pairs_of_closed;
  json["certified_pairs"] = report.certified_pairs;
  json["undecided_pairs"] = Object::object();
  for (const auto& [obstacle, count] : report.link_obstacles)
    json["undecided_pairs"][std::string(name_of(obstacle))] = count;
  json["links_not_known"] = report.not_linkable;
  if (!report.output.empty()) json["output"] = report.output.string();
  json["seconds"] = report.seconds;
  return json.dump(2, ' ', false, Object::error_handler_t::replace);
}

std::string to_text(const GraphReport& report) {
  std::string text;
  std::size_t maxima = 0, minima = 0, positive = 0;
  for (const ContourNode& node : report.tree.nodes) {
    maxima += node.maximum.has_value();
    minima += node.minimum.has_value();
  }
  for (const ModeRegion& region : report.regions.regions) positive += region.sign > 0;
  append_format(text, "{}: {}\n\ncontour tree: {} maxima, {} minima, {} saddles, ",
                report.input.string(), counted_tets(report.tetrahedra), maxima, minima,
                report.tree.nodes.size() - maxima - minima);
  if (report.tree.has_loops) {
    text += "no arcs: the mesh has holes through it, and the Reeb graph may be no tree\n"
            "regions of the neutral surface: not known, for the same reason\n";
  } else {
    append_format(
        text, "{} arcs{}\n", report.tree.arcs.size(),
        report.tree.is_complete ? "" : " (not complete: points or curves are not proved)");
    append_format(text, "regions of the neutral surface: {} positive, {} negative, {} borders{}\n",
                  positive, report.regions.regions.size() - positive, report.regions.borders.size(),
                  report.regions.is_complete ? "" : " (not complete)");
  }
  for (const ModeRegion& region : report.regions.regions)
    if (!region.curves.empty())
      append_format(text, "  a {} region with {}\n", region.sign > 0 ? "positive" : "negative",
                    counted(region.curves.size(), "degenerate curve"));
  CurveArcCounts all;
  for (const GraphCurve& curve : report.curves) all += curve.arcs;
  append_format(text, "degenerate curves: {}\n", report.curves.size());
  append_format(text,
                "  in tetrahedra: {} of wedges, {} of trisectors, {} of both, {} not proved\n",
                counted(all.wedges, "arc"), all.trisectors, all.mixed, all.not_proved);
  append_format(text, "  transitions: {} inside tetrahedra, {} at faces, where the sign jumps\n",
                all.zeros, all.jumps);
  std::size_t certified = 0;
  for (const CurveLink& link : report.links) certified += !link.obstacle;
  append_format(text, "linking numbers other than 0: {} of {} pairs of closed curves",
                report.links.size(), report.pairs_of_closed);
  if (!report.links.empty()) append_format(text, ", {} of them certified", certified);
  append_format(text, " (of all pairs {} certified", report.certified_pairs);
  for (const auto& [obstacle, count] : report.link_obstacles)
    append_format(text, ", {} undecided: {}", count, name_of(obstacle));
  if (report.not_linkable > 0)
    append_format(text, ", {} not known of polygons either", report.not_linkable);
  text += ")\n";
  if (!report.output.empty()) append_format(text, "\n{}\n", report.output.string());
  return text;
}

}  // namespace tensortopo
