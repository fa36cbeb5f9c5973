// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {

/// Adds what reports say of any surface's topology to a JSON object, `parts` last.
inline void add_topology(nlohmann::ordered_json& json, const SurfaceInvariants& known) {
  json["components"] = known.components;
  json["boundary_loops"] = known.boundary_loops;
  json["euler_characteristic"] = known.euler_characteristic;
  json["orientable"] = known.orientable;
  json["closed"] = known.closed;
  json["manifold"] = known.manifold;
  json["area"] = known.area;
}

/// How many there are, and of the first, and one that it lies on, the vertices and cells.
inline nlohmann::ordered_json torn_faces_json(const TornFaces& torn) {
  nlohmann::ordered_json json{{"count", torn.count}};
  if (torn.count > 0) json["vertices"] = torn.vertices, json["cells"] = torn.cells;
  return json;
}

/// The file written, or null.
template <class Report>
nlohmann::ordered_json output_json(const Report& report) {
  if (!report.written) return nullptr;
  return {{"path", report.output.string()}, {"bytes", report.bytes}};
}

/// The first 100 of the tetrahedra that are left out.
template <class Cells, class JsonOf>
nlohmann::ordered_json listed_cells_json(const Cells& cells, const JsonOf& json_of) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& cell : cells) {
    if (json.size() == 100) break;
    json.push_back(json_of(cell));
  }
  return json;
}

/// What the report of an extraction says of its field.
template <class Report>
nlohmann::ordered_json input_json(const Report& report) {
  return {{"path", report.input.string()},
          {"sha256", report.sha256},
          {"vertices", report.vertices},
          {"tetrahedra", report.tetrahedra},
          {"tensor", report.tensor_name},
          {"components", name_of(report.components.order)},
          {"components_text", report.components.text()},
          {"notes", report.notes},
          {"cells_left_out", report.cells_left_out},
          {"torn_faces", torn_faces_json(report.torn_faces)}};
}

/// Begins the report of an extraction: its kind, what made it, and its field.
template <class Report>
nlohmann::ordered_json begin_json(const char* schema, const Report& report) {
  auto options = nlohmann::ordered_json::object();
  for (const auto& [name, values] : report.provenance.options) {
    auto& json = options[name.substr(2)];
    json = true;
    if (!values.empty()) json = values;
  }
  return {{"schema", {{"name", schema}, {"version", 1}}},
          {"version", report.provenance.version},
          {"options", options},
          {"input", input_json(report)}};
}

inline nlohmann::ordered_json parts_json(const SurfaceInvariants& known) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& part : known.parts)
    json.push_back({{"euler_characteristic", part.euler_characteristic},
                    {"boundary_loops", part.boundary_loops},
                    {"genus", part.genus},
                    {"triangles", part.triangles},
                    {"area", part.area},
                    {"orientable", part.orientable},
                    {"manifold", part.manifold}});
  return json;
}

}  // namespace tensortopo
