// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "curve_arrays.hpp"
#include "mesh.hpp"
#include "surface_arrays.hpp"
#include "watched.hpp"

namespace tensortopo::python {

namespace {

using Index = SurfaceMesh::Index;

py::list list_of(const std::vector<LeftOut>& cells) {
  py::list list;
  for (const LeftOut& cell : cells)
    list.append(py::make_tuple(cell.tet, cell.reason, cell.mode.text()));
  return list;
}

py::dict statistics_of(const ModePart& part) {
  py::dict dict;
  for (const auto& [name, value] : part.statistics) dict[py::str(name)] = value;
  return dict;
}

py::dict dict_of(const SurfaceInvariants::Part& part) {
  using namespace py::literals;
  return py::dict("euler_characteristic"_a = part.euler_characteristic,
                  "boundary_loops"_a = part.boundary_loops, "genus"_a = part.genus,
                  "triangles"_a = part.triangles, "area"_a = part.area,
                  "orientable"_a = part.orientable, "manifold"_a = part.manifold);
}

py::object stability_of(const std::optional<StabilitySummary>& summary) {
  using namespace py::literals;
  if (!summary) return py::none();
  py::dict reasons, crossing_reasons;
  for (const auto& [reason, count] : summary->reasons) reasons[py::str(reason)] = count;
  for (const auto& [reason, count] : summary->crossing_reasons)
    crossing_reasons[py::str(reason)] = count;
  return py::dict("stable_tets"_a = summary->stable_tets,
                  "unstable_tets"_a = summary->unstable_tets,
                  "crossed_stable_tets"_a = summary->crossed_stable_tets,
                  "crossings"_a = summary->crossings,
                  "stable_crossings"_a = summary->stable_crossings,
                  "crossing_reasons"_a = crossing_reasons, "reasons"_a = reasons,
                  "stable_components"_a = summary->components.size());
}

py::dict surface_level(const ModePart& part) {
  using namespace py::literals;
  const SurfaceInvariants& i = part.invariants;
  py::list parts;
  for (const auto& p : i.parts) parts.append(dict_of(p));
  return py::dict("mode"_a = part.mode.text(), "vertices"_a = part.vertices,
                  "triangles"_a = part.cells, "parts"_a = parts,
                  "distance_bound"_a = part.distance_bound, "tets_farther"_a = part.tets_farther,
                  "not_embedded"_a = part.not_embedded,
                  "stability"_a = stability_of(part.stability),
                  "statistics"_a = statistics_of(part));
}

py::dict curve_level(const ModePart& part) {
  using namespace py::literals;
  const CurveInvariants& i = part.curve_invariants;
  return py::dict("mode"_a = part.mode.text(), "vertices"_a = part.vertices,
                  "lines"_a = part.cells, "length"_a = i.length, "components"_a = i.components,
                  "closed_components"_a = i.closed_components,
                  "stability"_a = stability_of(part.stability),
                  "statistics"_a = statistics_of(part));
}

std::vector<ModeValue> modes_of(const std::vector<std::string>& texts) {
  std::vector<ModeValue> modes;
  for (const std::string& text : texts) modes.push_back(parse_surface_mode(text));
  return modes;
}

/// Of a number, a text as the program takes it, or one radius for each vertex.
std::optional<Uncertainty> uncertainty_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  if (py::isinstance<py::str>(given)) return parse_uncertainty(given.cast<std::string>());
  Uncertainty result;
  if (py::isinstance<py::float_>(given)) {
    result.value = given.cast<double>();
  } else {
    result.kind = Uncertainty::Kind::per_vertex;
    result.radii = given.cast<std::vector<double>>();
  }
  return result;
}

py::dict extract_surfaces(const Mesh& self, const std::vector<std::string>& modes, bool generalized,
                          double resolution, bool all_samples, bool improve, bool manifold,
                          double max_error, bool certify, const py::object& uncertainty,
                          const std::string& tensor, const py::object& progress) {
  SurfaceRequest request;
  request.modes = modes_of(modes);
  request.generalized = generalized, request.resolution = resolution;
  request.all_samples = all_samples, request.improve = improve;
  if (manifold) request.meshing = MeshingMethod::manifold;
  request.max_error = max_error, request.certify = certify;
  request.uncertainty = uncertainty_of(uncertainty);
  request.names.tensor = tensor;
  ModeSurfaces made = watched(progress, [&](const Progress& report) {
    request.progress = report;
    return self.extractor->surfaces(request);
  });
  py::dict out;
  SurfaceMesh& s = made.surface;
  put_surface(out, std::move(s));
  out["component"] = array_of<Index>(std::move(s.component));
  for (CellArray& array : made.more)
    out[py::str(array.name)] = array_of<std::int32_t>(std::move(array.values));
  out["unresolved"] = list_of(made.unresolved);
  py::list levels;
  for (const ModePart& part : made.parts) levels.append(surface_level(part));
  out["levels"] = levels;
  out["certificate"] = certify ? py::object(py::bytes(made.certificate)) : py::none();
  out["claims"] = made.claims;
  return out;
}

py::dict extract_curves(const Mesh& self, bool linear, bool planar, double resolution, bool certify,
                        const py::object& uncertainty, const std::string& tensor,
                        const py::object& progress) {
  CurveRequest request;
  request.linear = linear, request.planar = planar;
  request.resolution = resolution, request.certify = certify;
  request.uncertainty = uncertainty_of(uncertainty);
  request.names.tensor = tensor;
  DegenerateCurves made = watched(progress, [&](const Progress& report) {
    request.progress = report;
    return self.extractor->curves(request);
  });
  py::dict out;
  put_curves(out, std::move(made.curves));
  for (CellArray& array : made.more)
    out[py::str(array.name)] = array_of<std::int32_t>(std::move(array.line_values));
  out["unresolved"] = list_of(made.unresolved);
  py::list levels;
  for (const ModePart& part : made.parts) levels.append(curve_level(part));
  out["levels"] = levels;
  out["certificate"] = certify ? py::object(py::bytes(made.certificate)) : py::none();
  out["claims"] = made.claims;
  return out;
}

}  // namespace

void define_extraction(py::class_<Mesh>& mesh) {
  mesh.def("surfaces", &extract_surfaces, py::arg("modes"), py::arg("generalized"),
           py::arg("resolution"), py::arg("all_samples"), py::arg("improve"), py::arg("manifold"),
           py::arg("max_error"), py::arg("certify"), py::arg("uncertainty"), py::arg("tensor"),
           py::arg("progress"));
  mesh.def("curves", &extract_curves, py::arg("linear"), py::arg("planar"), py::arg("resolution"),
           py::arg("certify"), py::arg("uncertainty"), py::arg("tensor"), py::arg("progress"));
}

}  // namespace tensortopo::python
