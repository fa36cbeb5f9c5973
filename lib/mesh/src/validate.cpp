// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/validate.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <utility>

#include "orientation.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {
namespace {

using Index = TetMesh::Index;
using Kind = MeshDefect::Kind;

constexpr std::size_t most_defects = 1000;

/// Corners of the face opposite to each corner, seen from outside a positive tetrahedron.
constexpr std::array<std::array<std::size_t, 3>, 4> faces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

bool is_finite(const Vector3<double>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool is_finite(const SymmetricTensor<double>& t) {
  return std::isfinite(t.xx) && std::isfinite(t.yy) && std::isfinite(t.zz) && std::isfinite(t.xy) &&
         std::isfinite(t.yz) && std::isfinite(t.xz);
}

/// Products of three lengths stay doubles, as volumes are.
constexpr double kLargest = 1e100, kSmallest = 1e-100;

bool is_in_range(const std::array<Index, 4>& tet, std::size_t points) {
  return std::all_of(tet.begin(), tet.end(),
                     [&](Index v) { return v >= 0 && static_cast<std::size_t>(v) < points; });
}

bool repeats_vertex(const std::array<Index, 4>& t) {
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
         t[2] == t[3];
}

int orientation(const TetMesh& mesh, const std::array<Index, 4>& tet) {
  const auto point = [&](std::size_t corner) -> const Vector3<double>& {
    return mesh.points[static_cast<std::size_t>(tet[corner])];
  };
  return detail::orientation(point(0), point(1), point(2), point(3));
}

/// One face of one tetrahedron, of those that have the same smallest vertex.
struct Face {
  Index middle, largest;  // the other two vertices
  Index tet;
  std::int8_t corner;  // opposite to the face
  std::int8_t side;    // +1 if the outward order of the vertices is an even permutation of sorted
};

/// Sorts three vertices; returns the sign of the permutation.
std::int8_t sort_three(std::array<Index, 3>& v) {
  std::int8_t sign = 1;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (v[i] > v[j]) {
      std::swap(v[i], v[j]);
      sign = static_cast<std::int8_t>(-sign);
    }
  };
  order(0, 1), order(1, 2), order(0, 1);
  return sign;
}

/// What is found in a part of the mesh.
struct Findings {
  std::vector<MeshDefect> defects;  ///< at most `most_defects`
  std::vector<OuterFace> outer;

  void add(Kind kind, std::int64_t where, std::string text) {
    if (defects.size() < most_defects) defects.push_back({kind, where, std::move(text)});
  }
};

constexpr std::size_t kPart = 4096;  ///< that one thread takes at a time

std::size_t parts_in(std::size_t count) { return (count + kPart - 1) / kPart; }

/// Calls the body for each of 0 to count - 1 with the number of its part; parts in parallel, with
/// the rounding that predicates need.
template <class Body>
void for_each_in_parts(std::size_t count, const Body& body) {
  tbb::parallel_for(std::size_t{0}, parts_in(count), [&](std::size_t part) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = part * kPart; i < std::min(count, (part + 1) * kPart); ++i) body(i, part);
  });
}

class Validator {
 public:
  Validator(const TetMesh& mesh, std::vector<OuterFace>* outer) : mesh_(mesh), outer_(outer) {}

  std::vector<MeshDefect> run() {
    if (check_lengths()) {
      check_points();
      check_cells();
      check_faces();
    }
    return std::move(found_.defects);
  }

 private:
  /// Calls the body for each of 0 to count - 1, parts of these in parallel; what is found is in the
  /// order of one thread.
  template <class Body>
  void in_parts(std::size_t count, const Body& body) {
    std::vector<Findings> parts(parts_in(count));
    for_each_in_parts(count, [&](std::size_t i, std::size_t part) { body(i, parts[part]); });
    for (Findings& part : parts) {
      const std::size_t room = most_defects - found_.defects.size();
      std::move(
          part.defects.begin(),
          part.defects.begin() + static_cast<std::ptrdiff_t>(std::min(room, part.defects.size())),
          std::back_inserter(found_.defects));
      if (outer_ != nullptr) outer_->insert(outer_->end(), part.outer.begin(), part.outer.end());
    }
  }

  std::int64_t id(std::size_t tet) const { return mesh_.cell_ids[tet]; }
  std::string name(std::size_t tet) const { return "cell " + std::to_string(id(tet)); }

  bool check_lengths() {
    const auto differ = [&](const char* what, std::size_t is, std::size_t should) {
      if (is != should)
        found_.add(
            Kind::wrong_length, static_cast<std::int64_t>(is),
            std::to_string(is) + " " + what + " where " + std::to_string(should) + " belong");
    };
    differ("tensors", mesh_.tensors.size(), mesh_.points.size());
    differ("cell ids", mesh_.cell_ids.size(), mesh_.tets.size());
    return found_.defects.empty();
  }

  void check_points() {
    in_parts(mesh_.points.size(), [&](std::size_t i, Findings& found) {
      const auto where = static_cast<std::int64_t>(i);
      if (!is_finite(mesh_.points[i]))
        found.add(Kind::non_finite_point, where,
                  "point " + std::to_string(i) + " has a coordinate that is not finite");
      else if (max_norm(mesh_.points[i]) > kLargest)
        found.add(Kind::out_of_range, where,
                  "point " + std::to_string(i) +
                      " has a coordinate beyond 1e100, too large for products");
      if (!is_finite(mesh_.tensors[i]))
        found.add(
            Kind::non_finite_tensor, where,
            "the tensor at point " + std::to_string(i) + " has a component that is not finite");
    });
  }

  void check_cells() {
    sound_.assign(mesh_.tets.size(), 0);
    in_parts(mesh_.tets.size(), [&](std::size_t t, Findings& found) {
      const auto& tet = mesh_.tets[t];
      if (!is_in_range(tet, mesh_.points.size())) {
        found.add(Kind::index_out_of_range, id(t), name(t) + " names a vertex that does not exist");
      } else if (repeats_vertex(tet)) {
        found.add(Kind::repeated_vertex, id(t), name(t) + " names a vertex twice");
      } else if (std::all_of(tet.begin(), tet.end(), [&](Index v) {
                   return is_finite(mesh_.points[static_cast<std::size_t>(v)]);
                 })) {
        const int sign = orientation(mesh_, tet);
        if (sign == 0)
          found.add(Kind::degenerate_cell, id(t), name(t) + " is flat: its volume is zero");
        if (sign < 0) found.add(Kind::inverted_cell, id(t), name(t) + " has negative volume");
        if (sign != 0) check_edges(t, found);
        sound_[t] = static_cast<std::int8_t>(sign);
      }
    });
  }

  void check_edges(std::size_t t, Findings& found) const {
    const auto& tet = mesh_.tets[t];
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (max_norm(mesh_.points[static_cast<std::size_t>(tet[i])] -
                     mesh_.points[static_cast<std::size_t>(tet[j])]) < kSmallest)
          return found.add(Kind::out_of_range, id(t),
                           name(t) + " has points " + std::to_string(tet[j]) + " and " +
                               std::to_string(tet[i]) +
                               " at a distance below 1e-100, too small for products");
  }

  /// Tetrahedra are filed under the two smallest of their vertices, by a counting sort: all faces
  /// whose smallest vertex is v belong to those filed under v.
  void check_faces() {
    std::vector<std::size_t> begin(mesh_.points.size() + 1, 0);
    for_each_smallest([&](Index v, Index) {
      std::atomic_ref(begin[static_cast<std::size_t>(v) + 1])
          .fetch_add(1, std::memory_order_relaxed);
    });
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<Index> files(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each_smallest([&](Index v, Index t) {
      files[std::atomic_ref(next[static_cast<std::size_t>(v)])
                .fetch_add(1, std::memory_order_relaxed)] = t;
    });
    in_parts(mesh_.points.size(), [&](std::size_t v, Findings& found) {
      thread_local std::vector<Face> around;
      around.clear();
      for (std::size_t i = begin[v]; i < begin[v + 1]; ++i)
        visit_faces(static_cast<std::size_t>(files[i]), [&](Index smallest, const Face& face) {
          if (smallest == static_cast<Index>(v)) around.push_back(face);
        });
      check_around(static_cast<Index>(v), around.data(), around.data() + around.size(), found);
    });
  }

  /// Visits the tetrahedra that have a volume with each of their two smallest vertices; in
  /// parallel.
  template <class Visit>
  void for_each_smallest(const Visit& visit) const {
    for_each_in_parts(mesh_.tets.size(), [&](std::size_t t, std::size_t) {
      if (sound_[t] == 0) return;
      const auto& v = mesh_.tets[t];
      const auto [a, b] = std::minmax(v[0], v[1]);
      const auto [c, d] = std::minmax(v[2], v[3]);
      visit(std::min(a, c), static_cast<Index>(t));
      visit(a < c ? std::min(b, c) : std::min(a, d), static_cast<Index>(t));
    });
  }

  /// The faces of a tetrahedron, turned to be positive.
  template <class Visit>
  void visit_faces(std::size_t t, const Visit& visit) const {
    const auto& tet = mesh_.tets[t];
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto& f = faces[corner];
      std::array<Index, 3> v{tet[f[0]], tet[f[1]], tet[f[2]]};
      const auto side = static_cast<std::int8_t>(sort_three(v) * sound_[t]);
      visit(v[0], Face{v[1], v[2], static_cast<Index>(t), static_cast<std::int8_t>(corner), side});
    }
  }

  /// Checks all faces with the same smallest vertex.
  void check_around(Index smallest, Face* first, Face* last, Findings& found) const {
    std::sort(first, last, [](const Face& f, const Face& g) {
      if (f.middle != g.middle) return f.middle < g.middle;
      if (f.largest != g.largest) return f.largest < g.largest;
      return f.tet < g.tet;
    });
    while (first != last) {
      Face* end = first + 1;
      while (end != last && end->middle == first->middle && end->largest == first->largest) ++end;
      const bool regular = end - first == 2 && first[0].side != first[1].side;
      if (end - first > 1 && !regular) check_shared_face(smallest, first, end, found);
      if (end - first == 1 && outer_ != nullptr) found.outer.push_back(outer_face(*first));
      first = end;
    }
  }

  OuterFace outer_face(const Face& face) const {
    const auto t = static_cast<std::size_t>(face.tet);
    const auto& f = faces[static_cast<std::size_t>(face.corner)];
    std::array<Index, 3> v{mesh_.tets[t][f[0]], mesh_.tets[t][f[1]], mesh_.tets[t][f[2]]};
    if (sound_[t] < 0) std::swap(v[1], v[2]);
    return {v, face.tet};
  }

  Index opposite(const Face& f) const {
    return mesh_.tets[static_cast<std::size_t>(f.tet)][static_cast<std::size_t>(f.corner)];
  }

  void check_shared_face(Index smallest, const Face* first, const Face* last,
                         Findings& found) const {
    const auto face = [&] {
      return " (face " + std::to_string(smallest) + " " + std::to_string(first->middle) + " " +
             std::to_string(first->largest) + ")";
    };
    const auto cell = [&](const Face& f) { return name(static_cast<std::size_t>(f.tet)); };
    const auto where = [&](const Face& f) { return id(static_cast<std::size_t>(f.tet)); };
    // A copy is named once, though all four of its faces meet: at the face that has the three
    // smallest vertices.
    std::vector<Face> by_opposite(first, last);
    std::sort(by_opposite.begin(), by_opposite.end(), [&](const Face& f, const Face& g) {
      return std::pair(opposite(f), f.tet) < std::pair(opposite(g), g.tet);
    });
    bool copies = false;
    for (std::size_t i = 1; i < by_opposite.size(); ++i) {
      const Face &f = by_opposite[i], &g = by_opposite[i - 1];
      if (opposite(f) != opposite(g)) continue;
      copies = true;
      if (opposite(f) > f.largest)
        found.add(Kind::duplicated_cell, where(f),
                  cell(f) + " has the same vertices as " + cell(g));
    }
    if (copies) return;
    if (last - first > 2) {
      found.add(Kind::crowded_face, where(first[2]),
                cell(first[2]) + " shares a face with two others, " + cell(first[0]) + " and " +
                    cell(first[1]) + face());
    } else if (first[0].side == first[1].side) {
      found.add(Kind::overlapping_cells, where(first[1]),
                cell(first[1]) + " and " + cell(first[0]) +
                    " overlap: they lie on the same side of a face" + face());
    }
  }

  const TetMesh& mesh_;
  std::vector<OuterFace>* outer_;
  Findings found_;
  std::vector<std::int8_t> sound_;  // sign of the volume; 0 if flat or not to be judged
};

}  // namespace

std::vector<MeshDefect> validate(const TetMesh& mesh, std::vector<OuterFace>* outer) {
  if (outer != nullptr) outer->clear();
  return Validator(mesh, outer).run();
}

std::size_t repair_orientation(TetMesh& mesh) {
  std::atomic<std::size_t> turned{0};
  for_each_in_parts(mesh.tets.size(), [&](std::size_t t, std::size_t) {
    auto& tet = mesh.tets[t];
    if (!is_in_range(tet, mesh.points.size())) return;
    if (!std::all_of(tet.begin(), tet.end(),
                     [&](Index v) { return is_finite(mesh.points[static_cast<std::size_t>(v)]); }))
      return;
    if (orientation(mesh, tet) >= 0) return;
    std::swap(tet[2], tet[3]);
    turned.fetch_add(1, std::memory_order_relaxed);
  });
  return turned;
}

std::size_t count_unreferenced_points(const TetMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const Index v : tet) used[static_cast<std::size_t>(v)] = 1;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
}

}  // namespace tensortopo
