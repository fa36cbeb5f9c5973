// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/sweep/sweep.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>

#include "mesh.hpp"
#include "watched.hpp"

namespace tensortopo::python {

namespace {

namespace py = pybind11;
using namespace py::literals;

std::array<int, 2> bounds(const GrowthBounds& b) { return {b.least, b.most}; }

py::dict dict_of(const MeshCriticalPoint& p) {
  const LocalEffect& e = p.effect;
  const bool decided = e.change != LocalChange::undecided;
  py::list vertices;
  for (const auto v : p.vertices)
    if (v >= 0) vertices.append(v);
  return py::dict("low"_a = p.low, "high"_a = p.high, "vertices"_a = vertices,
                  "point"_a = py::make_tuple(p.point.x, p.point.y, p.point.z),
                  "change"_a = std::string(name_of(e.change)),
                  "euler_change"_a = decided ? py::object(py::int_(e.euler_change)) : py::none(),
                  "on_boundary"_a = e.on_boundary,
                  "components"_a = decided ? py::cast(bounds(e.components)) : py::none(),
                  "boundary_loops"_a = decided ? py::cast(bounds(e.boundary_loops)) : py::none());
}

py::dict sweep(const Mesh& self, const std::string& from, const std::string& to,
               std::size_t samples, std::size_t most_levels, const py::object& progress) {
  SweepOptions options;
  options.from = ModeValue::parse(from), options.to = ModeValue::parse(to);
  options.samples = samples, options.most_levels = most_levels;
  const Sweep made = watched(progress, [&](const Progress& report) {
    return sweep_modes(self.mesh, options, report);
  });
  py::list levels, events, intervals;
  for (const SweepLevel& l : made.levels)
    levels.append(py::dict("mode"_a = l.mode.text(), "components"_a = l.components,
                           "euler_characteristic"_a = l.euler_characteristic,
                           "boundary_loops"_a = l.boundary_loops, "area"_a = l.area,
                           "unresolved"_a = l.unresolved));
  for (const SweepEvent& e : made.events) {
    py::list points;
    for (const MeshCriticalPoint& p : e.points) points.append(dict_of(p));
    events.append(py::dict("low"_a = e.low, "high"_a = e.high, "points"_a = points,
                           "euler_change"_a = e.euler_change()));
  }
  for (const SweepInterval& i : made.intervals)
    intervals.append(py::dict("low"_a = i.low, "high"_a = i.high,
                              "euler_characteristic"_a = i.euler_characteristic,
                              "level"_a = i.level));
  return py::dict("levels"_a = levels, "samples"_a = made.samples, "events"_a = events,
                  "intervals"_a = intervals, "contradictions"_a = made.contradictions);
}

}  // namespace

void define_sweep(py::class_<Mesh>& mesh) {
  mesh.def("sweep", &sweep, py::arg("start"), py::arg("stop"), py::arg("samples"),
           py::arg("most_levels"), py::arg("progress"));
}

}  // namespace tensortopo::python
