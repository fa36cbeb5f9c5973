// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analyze/analyzed_mesh.hpp"
#include "analyze/persistence/curve_transitions.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/persistence/certified_linking.hpp"
#include "tensortopo/persistence/mode_regions.hpp"

namespace tensortopo {

/// The contour tree of the mode, and the topological graph.
struct GraphCommand {
  std::filesystem::path input;
  ReadOptions read;
  Provenance provenance;         ///< for the output
  std::filesystem::path output;  ///< .vtp, for the tree and transitions; may be empty
};

/// A component of degenerate curves.
struct GraphCurve {
  int mode = 1;               ///< or -1
  std::size_t component = 0;  ///< of those of this mode
  bool is_closed = false;
  double length = 0;
  std::size_t wedges = 0, trisectors = 0;  ///< vertices of the polyline, by the sign of separation
  std::size_t transitions = 0;             ///< of one into the other, along it, by these signs
  CurveArcCounts arcs;                     ///< by proof
};

/// Two closed curves with a linking number other than 0.
struct CurveLink {
  std::size_t first = 0, second = 0;  ///< as indices into `GraphReport::curves`
  int number = 0;                     ///< of the curves, or if that is not proved, of the polygons
  std::optional<LinkObstacle> obstacle;  ///< why it is not proved
};

struct GraphReport : AnalyzedMesh {
  std::filesystem::path output;
  std::vector<std::int64_t> cell_ids;
  ContourTree tree;
  ModeRegions regions;
  std::vector<GraphCurve> curves;  ///< those of mode 1 first
  /// Between wedges and trisectors, curve by curve.
  std::vector<CurveTransition> transitions;
  std::vector<CurveLink> links;     ///< with a linking number that is not 0
  std::size_t pairs_of_closed = 0;  ///< of which the linking number was looked at
  std::size_t certified_pairs = 0;  ///< of these, with a number that is proved
  std::size_t not_linkable = 0;     ///< of the others, not known of the polygons either
  /// Of pairs without a proof: how many for each reason.
  std::map<LinkObstacle, std::size_t> link_obstacles;
  double seconds = 0;

  /// The curve of a node, if it is one.
  std::vector<std::optional<std::size_t>> curve_of_node;
};

/// Throws UsageError, IoError.
GraphReport run_graph(const GraphCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const GraphReport& report);
/// Tables for people. Ends with a newline.
std::string to_text(const GraphReport& report);

}  // namespace tensortopo
