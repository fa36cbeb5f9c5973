// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "curve_arrays.hpp"
#include "curve_pieces.hpp"
#include "mesh.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/restrict_piece.hpp"

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

/// @param whole_component  of each line of a part, its component in the whole; else empty
std::string curve_certificate(const MergedCurves& merged, CertificateSubject subject,
                              const std::vector<Index>& whole_component) {
  const CertifiedCurves claims = certify(merged);
  const CurveMesh curves = curves_in_cells(merged);
  subject.tetrahedra = static_cast<std::size_t>(merged.whole_tets);
  subject.vertices = curves.points.size();
  subject.cells = curves.lines.size();
  subject.output_sha256 = curves_sha256(curves, merged.cells);
  std::vector<CellArray> more;
  if (!whole_component.empty()) more.push_back({"whole_component", {}, whole_component, false});
  for (const ArrayHash& array : array_hashes(curves, more))
    subject.arrays.push_back({array.of, array.name, array.components, array.sha256});
  return certificate_bytes(subject, std::span(&claims, 1), merged.cells, CertificateEncoding::json);
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
    if (certifying) certificate = curve_certificate(made, subject, {});
  }
  py::dict out = dict_of(std::move(made));
  out["certificate"] = certifying ? py::object(py::bytes(certificate)) : py::none();
  return out;
}

/// Of each line that a part has, in the order of the piece, its component in the whole.
std::vector<Index> numbers_in_part(const PieceCurves& piece, const PartNumbers& numbers,
                                   const Input<Index>& components) {
  if (static_cast<std::size_t>(components.size()) != piece.curves.lines.size())
    throw py::value_error("components: one of each line of the piece belongs here");
  std::vector<std::int64_t> cells;
  for (const auto& [whole, part] : numbers.tets) cells.push_back(whole);
  std::sort(cells.begin(), cells.end());
  std::vector<Index> result;
  for (std::size_t i = 0; i < piece.curves.lines.size(); ++i)
    if (std::binary_search(cells.begin(), cells.end(),
                           piece.cells.cell_ids[as_size(piece.curves.tet[i])]))
      result.push_back(components.data()[i]);
  return result;
}

/// The curves of a part, in the numbers of its file.
/// @param components  of each line of the piece, its component in the whole
py::dict curve_part(const py::dict& whole, const Input<std::int64_t>& tets,
                    const Input<std::int64_t>& vertices, const Input<Index>& components,
                    const py::object& certified) {
  const PartNumbers numbers{rows_of<std::array<std::int64_t, 2>>(tets, "cells"),
                            rows_of<std::array<std::int64_t, 2>>(vertices, "vertices")};
  const PieceCurves piece = curves_from(whole);
  const PieceCurves part = restrict_piece(piece, numbers);
  const std::vector<Index> of_lines = numbers_in_part(piece, numbers, components);
  MergedCurves made = merge_curve_pieces(std::span(&part, 1));
  // Components of a part are numbered alike before and after merging.
  std::vector<Index> number(of_lines.size()), whole_component;
  for (std::size_t i = 0; i < of_lines.size(); ++i)
    number[as_size(part.curves.component[i])] = of_lines[i];
  for (const Index component : made.curves.component)
    whole_component.push_back(number[as_size(component)]);
  const py::object certificate =
      certified.is_none()
          ? py::object(py::none())
          : py::bytes(curve_certificate(made, subject_of(certified), whole_component));
  py::dict out = dict_of(std::move(made));
  out["certificate"] = certificate;
  out["whole_component"] = array_of<Index>(std::move(whole_component));
  return out;
}

}  // namespace

void define_merged_curves(py::module_& m) {
  m.def("merge_curve_pieces", &merge_curves, py::arg("pieces"), py::arg("certified"));
  m.def("curve_part", &curve_part, py::arg("piece"), py::arg("cells"), py::arg("vertices"),
        py::arg("components"), py::arg("certified"));
}

}  // namespace tensortopo::python
