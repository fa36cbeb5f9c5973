// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace tensortopo::python {

namespace py = pybind11;

template <class T>
using Input = py::array_t<T, py::array::c_style | py::array::forcecast>;

inline void make_read_only(const py::array& array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
}

/// The rows of an array of two dimensions.
template <class Row, class T>
std::vector<Row> rows_of(const Input<T>& array, const char* name) {
  constexpr auto width = static_cast<py::ssize_t>(sizeof(Row) / sizeof(T));
  if (array.ndim() != 2 || array.shape(1) != width)
    throw py::value_error(std::string(name) + ": expected shape (n, " + std::to_string(width) +
                          ")");
  std::vector<Row> rows(static_cast<std::size_t>(array.shape(0)));
  if (!rows.empty())
    std::memcpy(static_cast<void*>(rows.data()), array.data(), rows.size() * sizeof(Row));
  return rows;
}

/// A view of rows that belong to `owner`: no copy, read-only. One number a row gives one dimension.
template <class T, class Row>
py::array_t<T> view_of(const std::vector<Row>& rows, const py::object& owner) {
  static_assert(sizeof(Row) % sizeof(T) == 0);
  constexpr auto width = static_cast<py::ssize_t>(sizeof(Row) / sizeof(T));
  const auto n = static_cast<py::ssize_t>(rows.size());
  const T* data = reinterpret_cast<const T*>(rows.data());
  py::array_t<T> array = width == 1 ? py::array_t<T>({n}, data, owner)
                                    : py::array_t<T>({n, width}, data, owner);
  make_read_only(array);
  return array;
}

/// An array that owns what was in the vector: no copy, read-only.
template <class T, class Row>
py::array_t<T> array_of(std::vector<Row>&& rows) {
  auto* kept = new std::vector<Row>(std::move(rows));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Row>*>(p); });
  return view_of<T>(*kept, owner);
}

}  // namespace tensortopo::python
