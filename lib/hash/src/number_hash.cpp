// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/hash/number_hash.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "tensortopo/hash/sha256.hpp"

namespace tensortopo {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are hashed as they lie");

/// Collects numbers and hashes them in large pieces.
class NumberHash {
 public:
  void add(double x) { append(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vector3<double>& p) { add(p.x), add(p.y), add(p.z); }
  /// Their number, then each.
  void add_points(const std::vector<Vector3<double>>& points) {
    add_count(points.size());
    for (const auto& p : points) add(p);
  }
  /// The numbers that the file gives these tetrahedra.
  void add_cells(const std::vector<TetMesh::Index>& tets, const TetMesh& mesh) {
    for (const auto t : tets) add_id(mesh.cell_ids[static_cast<std::size_t>(t)]);
  }
  void add_count(std::size_t n) { append(n); }
  void add_id(std::int64_t i) { append(static_cast<std::uint64_t>(i)); }
  std::string hex() {
    flush();
    return sum_.hex();
  }

 private:
  void append(std::uint64_t bits) {
    buffer_.append(reinterpret_cast<const char*>(&bits), sizeof bits);
    if (buffer_.size() >= 1u << 16) flush();
  }
  void flush() {
    sum_.add(buffer_);
    buffer_.clear();
  }
  Sha256 sum_;
  std::string buffer_;
};

template <class Values>
void add_array(std::vector<ArrayHash>& list, const char* of, const char* name,
               std::size_t components, const Values& values) {
  if (values.empty()) return;  // nor is it written
  NumberHash hash;
  for (const auto& x : values)
    if constexpr (std::is_integral_v<typename Values::value_type>)
      hash.add(static_cast<double>(x));
    else
      hash.add(x);
  list.push_back({of, name, components, hash.hex()});
}

void sort(std::vector<ArrayHash>& list) {
  std::sort(list.begin(), list.end(), [](const ArrayHash& a, const ArrayHash& b) {
    return std::tie(a.of, a.name) < std::tie(b.of, b.name);
  });
}

}  // namespace

std::string numbers_sha256(std::span<const double> numbers) {
  NumberHash hash;
  for (const double x : numbers) hash.add(x);
  return hash.hex();
}

struct FieldHash::State {
  NumberHash hash;
  std::size_t tets = 0;
  bool has_tets = false;

  void begin_tets() {
    if (!std::exchange(has_tets, true)) hash.add_count(tets);
  }
};

FieldHash::FieldHash(std::size_t points, std::size_t tets) : state_(std::make_unique<State>()) {
  state_->tets = tets;
  state_->hash.add_count(points);
}
FieldHash::~FieldHash() = default;

void FieldHash::add(const Vector3<double>& point) { state_->hash.add(point); }
void FieldHash::add(const SymmetricTensor<double>& t) {
  for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) state_->hash.add(x);
}
void FieldHash::add(std::array<std::int64_t, 4> tet) {
  state_->begin_tets();
  std::sort(tet.begin(), tet.end());
  for (const std::int64_t v : tet) state_->hash.add_id(v);
}
std::string FieldHash::hex() {
  state_->begin_tets();
  return state_->hash.hex();
}

std::string field_sha256(const TetMesh& mesh) {
  FieldHash hash(mesh.points.size(), mesh.tets.size());
  for (const auto& p : mesh.points) hash.add(p);
  for (const auto& t : mesh.tensors) hash.add(t);
  for (const auto& [a, b, c, d] : mesh.tets) hash.add(std::array<std::int64_t, 4>{a, b, c, d});
  return hash.hex();
}

std::string surface_sha256(const SurfaceMesh& surface, const TetMesh& mesh) {
  NumberHash hash;
  hash.add_points(surface.points);
  hash.add_count(surface.triangles.size());
  for (const auto& triangle : surface.triangles)
    for (const auto v : triangle) hash.add_id(v);
  hash.add_cells(surface.tet, mesh);
  return hash.hex();
}

std::string curves_sha256(const CurveMesh& curves, const TetMesh& mesh) {
  NumberHash hash;
  hash.add_points(curves.points);
  hash.add_count(curves.lines.size());
  for (const auto& line : curves.lines) {
    hash.add_count(line.size());
    for (const auto v : line) hash.add_id(v);
  }
  hash.add_cells(curves.tet, mesh);
  return hash.hex();
}

std::vector<ArrayHash> array_hashes(const CurveMesh& curves, std::span<const CellArray> more) {
  std::vector<ArrayHash> list;
  add_array(list, "lines", "component", 1, curves.component);
  for (const CellArray& array : more)
    add_array(list, array.of_points ? "points" : "lines", array.name.c_str(), 1, array.line_values);
  add_array(list, "points", "dominant_eigenvector", 3, curves.dominant_eigenvector);
  add_array(list, "points", "mode", 1, curves.mode);
  add_array(list, "points", "residual", 1, curves.residual);
  add_array(list, "points", "separation", 1, curves.separation);
  sort(list);
  return list;
}

std::vector<ArrayHash> array_hashes(const SurfaceMesh& surface, std::span<const CellArray> more) {
  std::vector<ArrayHash> list;
  add_array(list, "points", "dominant_eigenvector", 3, surface.dominant_eigenvector);
  add_array(list, "points", "medium_eigenvector", 3, surface.medium_eigenvector);
  add_array(list, "points", "mode", 1, surface.mode);
  add_array(list, "points", "normal", 3, surface.normal);
  add_array(list, "points", "residual", 1, surface.residual);
  add_array(list, "points", "value", 1, surface.value);
  add_array(list, "triangles", "component", 1, surface.component);
  for (const CellArray& array : more)
    add_array(list, array.of_points ? "points" : "triangles", array.name.c_str(), 1, array.values);
  sort(list);
  return list;
}

}  // namespace tensortopo
