// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Pieces of curves as Python has them.
#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo::python {

namespace py = pybind11;

/// Throws ValueError if arrays do not fit each other.
PieceCurves curves_from(const py::dict& d);

/// Ids with reasons.
py::list list_of_cells(const std::vector<OwnedCurveCell>& cells);

}  // namespace tensortopo::python
