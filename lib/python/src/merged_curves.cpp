// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "curve_arrays.hpp"
#include "curve_pieces.hpp"
#include "mesh.hpp"
#include "tensortopo/partition/whole_in_parts.hpp"

namespace tensortopo::python {

namespace {

using Index = TetMesh::Index;

/// @param certified  what is known of the field; or None
CertificateSubject subject_of(const py::object& certified) {
  CertificateSubject subject;
  if (certified.is_none()) return subject;
  subject.tensor = certified["tensor"].cast<std::string>();
  subject.components = certified["components"].cast<std::string>();
  subject.points = certified["points"].cast<std::size_t>();
  subject.field_sha256 = certified["sha256"].cast<std::string>();
  return subject;
}

py::dict dict_of(MergedCurves&& made) {
  py::dict out;
  put_curves(out, std::move(made.curves));
  out["cell_ids"] = array_of<std::int64_t>(std::move(made.cell_ids));
  out["carrier_ids"] = array_of<std::int64_t>(std::move(made.carrier_ids));
  out["unresolved"] = list_of_cells(made.unresolved);
  out["special"] = list_of_cells(made.special);
  return out;
}

py::dict merge_curves(const std::vector<py::dict>& dicts, const py::object& certified) {
  std::vector<PieceCurves> pieces;
  for (const py::dict& d : dicts) pieces.push_back(curves_from(d));
  const CertificateSubject subject = subject_of(certified);
  const bool certifying = !certified.is_none();
  MergedCurves made;
  std::string certificate;
  {
    const py::gil_scoped_release unlocked;
    made = merge_curve_pieces(pieces);
    if (certifying) certificate = certificate_bytes(made, subject);
  }
  py::dict out = dict_of(std::move(made));
  out["certificate"] = certifying ? py::object(py::bytes(certificate)) : py::none();
  return out;
}

/// The curves of a part, in the numbers of its file.
/// @param components  of each line of the piece, its component in the whole
py::dict curve_part(const py::dict& whole, const Input<std::int64_t>& tets,
                    const Input<std::int64_t>& vertices, const Input<Index>& components,
                    const py::object& certified) {
  const PartNumbers numbers{rows_of<std::array<std::int64_t, 2>>(tets, "cells"),
                            rows_of<std::array<std::int64_t, 2>>(vertices, "vertices")};
  const PieceCurves piece = curves_from(whole);
  CurvePart part =
      part_of(piece, numbers, {components.data(), static_cast<std::size_t>(components.size())});
  const py::object certificate =
      certified.is_none() ? py::object(py::none())
                          : py::bytes(certificate_bytes(part, subject_of(certified)));
  py::dict out = dict_of(std::move(part.curves));
  out["certificate"] = certificate;
  out["whole_component"] = array_of<Index>(std::move(part.whole_component));
  return out;
}

}  // namespace

void define_merged_curves(py::module_& m) {
  m.def("merge_curve_pieces", &merge_curves, py::arg("pieces"), py::arg("certified"));
  m.def("curve_part", &curve_part, py::arg("piece"), py::arg("cells"), py::arg("vertices"),
        py::arg("components"), py::arg("certified"));
}

}  // namespace tensortopo::python
