// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "mesh.hpp"
#include "tensortopo/mesh/nodal_average.hpp"
#include "tensortopo/tensor/component_names.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::python {

namespace {

using Tensor = SymmetricTensor<double>;

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

std::size_t rows_of(const Input<double>& tensors) {
  if (tensors.ndim() != 2 || tensors.shape(1) != 6)
    throw py::value_error("tensors: expected shape (n, 6)");
  return static_cast<std::size_t>(tensors.shape(0));
}

Tensor tensor_at(const double* numbers, std::size_t i) {
  const double* t = numbers + 6 * i;
  return {t[0], t[1], t[2], t[3], t[4], t[5]};
}

bool is_finite(const Tensor& t) {
  for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
    if (!std::isfinite(x)) return false;
  return true;
}

/// By so much a tensor must be divided for its deviator, and three times that, not to overflow.
double divisor_of(const Tensor& t) {
  for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
    if (std::abs(x) > 0x1p1000) return 8;
  return 1;
}

/// Exact but for components that are nothing beside the largest one.
Tensor divided(const Tensor& t, double divisor) { return (1 / divisor) * t; }

/// A number for each tensor with a deviator; not a number for the others.
template <class Function>
py::array_t<double> for_each_deviator(const Input<double>& tensors, const Function& function) {
  const std::size_t n = rows_of(tensors);
  py::array_t<double> result(static_cast<py::ssize_t>(n));
  const double* in = tensors.data();
  double* out = result.mutable_data();
  const py::gil_scoped_release unlocked;
  for (std::size_t i = 0; i < n; ++i) {
    const Tensor t = tensor_at(in, i);
    out[i] = kUndefined;
    if (!is_finite(t)) continue;
    const auto d = deviator(divided(t, divisor_of(t)));
    if (d != Deviator<double>{}) out[i] = function(d);
  }
  return result;
}

py::array_t<double> deviators(const Input<double>& tensors) {
  const std::size_t n = rows_of(tensors);
  py::array_t<double> result({static_cast<py::ssize_t>(n), py::ssize_t{6}});
  const double* in = tensors.data();
  double* out = result.mutable_data();
  const py::gil_scoped_release unlocked;
  for (std::size_t i = 0; i < n; ++i) {
    const Tensor t = tensor_at(in, i);
    const double divisor = divisor_of(t);
    const Tensor d = divisor * to_tensor(deviator(divided(t, divisor)));
    const double row[6]{d.xx, d.yy, d.zz, d.xy, d.yz, d.xz};
    for (std::size_t k = 0; k < 6; ++k) out[6 * i + k] = row[k];
  }
  return result;
}

py::tuple eigensystems(const Input<double>& tensors) {
  const std::size_t n = rows_of(tensors);
  const auto rows = static_cast<py::ssize_t>(n);
  py::array_t<double> values({rows, py::ssize_t{3}}), vectors({rows, py::ssize_t{3}, py::ssize_t{3}});
  const double* in = tensors.data();
  double *l = values.mutable_data(), *v = vectors.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for (std::size_t i = 0; i < n; ++i) {
      const Tensor t = tensor_at(in, i);
      Eigensystem<double> e;
      if (is_finite(t))
        e = eigen_decomposition(t);
      else
        e.values.fill(kUndefined), e.vectors.fill({kUndefined, kUndefined, kUndefined});
      for (std::size_t k = 0; k < 3; ++k) {
        l[3 * i + k] = e.values[k];
        const Vector3<double>& x = e.vectors[k];
        v[9 * i + 3 * k] = x.x, v[9 * i + 3 * k + 1] = x.y, v[9 * i + 3 * k + 2] = x.z;
      }
    }
  }
  return py::make_tuple(values, vectors);
}

template <class To, class From>
std::vector<To> list_of(const Input<From>& array) {
  return {array.data(), array.data() + array.size()};
}

py::tuple nodal_averages(std::size_t node_count, const Input<std::int64_t>& nodes,
                         const Input<double>& tensors, std::size_t tensors_per_cell, bool at_nodes,
                         const std::optional<Input<double>>& weights,
                         const std::optional<Input<std::int64_t>>& materials) {
  if (nodes.ndim() != 2) throw py::value_error("nodes: expected two dimensions");
  // Numbers of nodes below `node_count` fit into the library's.
  if (node_count > std::numeric_limits<TetMesh::Index>::max())
    throw py::value_error("points: too many");
  CellTensors cells;
  cells.nodes_per_cell = static_cast<std::size_t>(nodes.shape(1));
  cells.nodes = list_of<TetMesh::Index>(nodes);
  cells.tensors_per_cell = tensors_per_cell;
  cells.tensors = python::rows_of<Tensor>(tensors, "tensors");
  cells.at_nodes = at_nodes;
  NodalAverageOptions options;
  if (weights) options.weights = list_of<double>(*weights);
  if (materials) options.materials = list_of<std::int64_t>(*materials);
  NodalAverage result;
  {
    const py::gil_scoped_release unlocked;
    result = nodal_average(node_count, cells, options);
  }
  const auto wide = [](const std::vector<TetMesh::Index>& numbers) {
    return array_of<std::int64_t>(std::vector<std::int64_t>(numbers.begin(), numbers.end()));
  };
  return py::make_tuple(array_of<double>(std::move(result.tensors)), wide(result.nodes),
                        wide(result.origin));
}

/// The name of the order in which an array lists its components.
std::string decided_order(const std::string& array, const std::vector<std::string>& names,
                          std::size_t count, const std::optional<std::string>& asked) {
  std::optional<ComponentOrder> order;
  if (asked) {
    order = component_order(*asked);
    if (!order) {
      std::string known;
      for (const std::string_view name : component_order_names())
        known += (known.empty() ? "" : ", ") + std::string(name);
      throw py::value_error("components='" + *asked + "': is none of " + known);
    }
  }
  return std::string(name_of(decide_order(names, count, order, {array, "the argument components"}).order));
}

}  // namespace

void define_tensors(py::module_& m) {
  m.def(
      "mode",
      [](const Input<double>& tensors) {
        return for_each_deviator(tensors, [](const auto& d) { return mode(d); });
      },
      py::arg("tensors"));
  m.def(
      "lode_angle",
      [](const Input<double>& tensors) {
        return for_each_deviator(tensors, [](const auto& d) { return lode_angle(d); });
      },
      py::arg("tensors"));
  m.def("deviator", &deviators, py::arg("tensors"));
  m.def("decide_order", &decided_order, py::arg("array"), py::arg("names"), py::arg("count"),
        py::arg("asked"));
  m.def("eigen", &eigensystems, py::arg("tensors"));
  m.def("nodal_average", &nodal_averages, py::arg("node_count"), py::arg("nodes"),
        py::arg("tensors"), py::arg("tensors_per_cell"), py::arg("at_nodes"), py::arg("weights"),
        py::arg("materials"));
}

}  // namespace tensortopo::python
