// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/whole_in_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Of those triangles or lines of a piece that lie in a part's tetrahedra, in the piece's order.
template <class T>
std::vector<T> those_in_part(const PartNumbers& numbers, const TetMesh& cells,
                             const std::vector<Index>& tets, std::span<const T> values) {
  if (values.size() != tets.size())
    throw std::invalid_argument("components: one of each triangle or line of the piece belongs here");
  std::vector<std::int64_t> ids;
  for (const auto& [whole, part] : numbers.tets) ids.push_back(whole);
  std::sort(ids.begin(), ids.end());
  std::vector<T> result;
  for (std::size_t i = 0; i < tets.size(); ++i)
    if (std::binary_search(ids.begin(), ids.end(), cells.cell_ids[as_size(tets[i])]))
      result.push_back(values[i]);
  return result;
}

/// The positions of tetrahedra's triangles in the order of the tetrahedra, then of the triangles.
template <class Ids>
std::vector<std::size_t> by_tetrahedra(std::size_t count, const Ids& id) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return id(i) < id(j); });
  return order;
}

void add_arrays(CertificateSubject& subject, const std::vector<ArrayHash>& hashes) {
  for (const ArrayHash& array : hashes)
    subject.arrays.push_back({array.of, array.name, array.components, array.sha256});
  std::sort(subject.arrays.begin(), subject.arrays.end(), [](const auto& a, const auto& b) {
    return std::tie(a.of, a.name) < std::tie(b.of, b.name);
  });
}

/// @param whole_component  of the triangles of a part; else empty
std::string surface_certificate(const MergedSurface& merged, const ModeValue& mode,
                                CertificateSubject subject,
                                const std::vector<Index>& whole_component) {
  const CertifiedLevel level = certify(merged, mode);
  SurfaceMesh surface = extraction_of(merged).surface;
  subject.tetrahedra = static_cast<std::size_t>(merged.whole_tets);
  subject.vertices = surface.points.size();
  subject.cells = surface.triangles.size();
  subject.output_sha256 = surface_sha256(surface, merged.cells);
  std::vector<CellArray> more;
  if (!whole_component.empty()) {
    // Normals of the whole are no claims about a part.
    const auto normal = std::exchange(surface.normal, {});
    std::vector<double> numbers;
    for (const auto& n : normal) numbers.insert(numbers.end(), {n.x, n.y, n.z});
    subject.arrays.push_back({"points", "whole_normal", 3, numbers_sha256(numbers)});
    more.push_back({"whole_component", whole_component, {}, false});
  }
  add_arrays(subject, array_hashes(surface, more));
  return certificate_bytes(subject, std::span(&level, 1), merged.cells, CertificateEncoding::json);
}

/// @param whole_component  of the lines of a part; else empty
std::string curve_certificate(const MergedCurves& merged, CertificateSubject subject,
                              const std::vector<Index>& whole_component) {
  const CertifiedCurves claims = certify(merged);
  const CurveMesh curves = curves_in_cells(merged);
  subject.tetrahedra = static_cast<std::size_t>(merged.whole_tets);
  subject.vertices = curves.points.size();
  subject.cells = curves.lines.size();
  subject.output_sha256 = curves_sha256(curves, merged.cells);
  std::vector<CellArray> more;
  if (!whole_component.empty())
    more.push_back({"whole_component", {}, whole_component, false});
  add_arrays(subject, array_hashes(curves, more));
  return certificate_bytes(subject, std::span(&claims, 1), merged.cells, CertificateEncoding::json);
}

}  // namespace

SurfacePart part_of(const PieceSurface& piece, const PartNumbers& numbers,
                    std::span<const SurfaceMesh::Index> components) {
  const PieceSurface part = restrict_piece(piece, numbers);
  const auto own = those_in_part(numbers, piece.cells, piece.surface.tet, components);
  SurfacePart result{merge_pieces(std::span(&part, 1)), {}};
  // Triangles of one tetrahedron are in the same order before and after.
  const auto before = by_tetrahedra(own.size(), [&](std::size_t i) {
    return part.cells.cell_ids[as_size(part.surface.tet[i])];
  });
  const auto after =
      by_tetrahedra(own.size(), [&](std::size_t i) { return result.surface.cell_ids[i]; });
  result.whole_component.resize(own.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    result.whole_component[after[i]] = own[before[i]];
  return result;
}

CurvePart part_of(const PieceCurves& piece, const PartNumbers& numbers,
                  std::span<const CurveMesh::Index> components) {
  const PieceCurves part = restrict_piece(piece, numbers);
  const auto own = those_in_part(numbers, piece.cells, piece.curves.tet, components);
  CurvePart result{merge_curve_pieces(std::span(&part, 1)), {}};
  // Components of a part are numbered alike before and after.
  std::vector<Index> number(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) number[as_size(part.curves.component[i])] = own[i];
  for (const Index component : result.curves.curves.component)
    result.whole_component.push_back(number[as_size(component)]);
  return result;
}

std::string certificate_bytes(const MergedSurface& merged, const ModeValue& mode,
                              CertificateSubject field) {
  return surface_certificate(merged, mode, std::move(field), {});
}

std::string certificate_bytes(const MergedCurves& merged, CertificateSubject field) {
  return curve_certificate(merged, std::move(field), {});
}

std::string certificate_bytes(const SurfacePart& part, const ModeValue& mode,
                              CertificateSubject field) {
  return surface_certificate(part.surface, mode, std::move(field), part.whole_component);
}

std::string certificate_bytes(const CurvePart& part, CertificateSubject field) {
  return curve_certificate(part.curves, std::move(field), part.whole_component);
}

}  // namespace tensortopo
