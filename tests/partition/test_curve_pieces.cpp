// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// However a mesh is numbered and cut, the bits of its degenerate curves.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "pieces_of_curves.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/extract/curve_arcs.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

/// By component of the whole.
std::vector<JoinedCurveSeams::Component> counted(const CurveMesh& curves) {
  std::vector<JoinedCurveSeams::Component> result;
  std::vector<int> line_ends(curves.points.size(), 0);
  std::vector<Index> component(curves.points.size(), -1);
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    const auto c = as_size(curves.component[i]);
    if (c >= result.size()) result.resize(c + 1);
    ++result[c].lines;
    for (const Index v : curves.lines[i]) component[as_size(v)] = curves.component[i];
    ++line_ends[as_size(curves.lines[i].front())], ++line_ends[as_size(curves.lines[i].back())];
  }
  for (std::size_t v = 0; v < component.size(); ++v) {
    auto& own = result[as_size(component[v])];
    ++own.vertices;
    own.ends += line_ends[v] == 1, own.junctions += line_ends[v] > 2;
  }
  return result;
}

/// By tetrahedron and component: how many lines there are.
using LineCounts = std::map<std::pair<std::int64_t, Index>, int>;

/// What is wrong with what seams say of whole curves; "" if nothing is.
std::string wrong_in_seams(const std::vector<PieceCurves>& parts, const CurveMesh& whole) {
  const JoinedCurveSeams joined = join_curve_seams(sent_curve_seams(parts));
  const auto expected = counted(whole);
  if (joined.components.size() != expected.size()) return "how many components";
  for (std::size_t c = 0; c < expected.size(); ++c) {
    const auto &a = expected[c], &b = joined.components[c];
    const std::string which = " of component " + std::to_string(c);
    if (a.vertices != b.vertices) return "vertices" + which;
    if (a.lines != b.lines) return "lines" + which;
    if (a.ends != b.ends) return "ends" + which;
    if (a.junctions != b.junctions) return "junctions" + which;
  }
  const CurveInvariants known = curve_invariants(whole);
  if (joined.total().vertices != static_cast<std::int64_t>(known.vertices)) return "all vertices";
  if (joined.closed_components() != static_cast<std::int64_t>(known.closed_components))
    return "closed components";
  LineCounts lines, of_parts;
  for (std::size_t i = 0; i < whole.lines.size(); ++i) ++lines[{whole.tet[i], whole.component[i]}];
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const CurveMesh& curves = parts[p].curves;
    for (std::size_t i = 0; i < curves.lines.size(); ++i)
      ++of_parts[{parts[p].cells.cell_ids[as_size(curves.tet[i])],
                  joined.numbers[p][as_size(curves.component[i])]}];
  }
  return lines == of_parts ? "" : "numbers of components";
}

/// What is compared of a field.
struct CurveCounts {
  std::size_t lines = 0, on_seams = 0, in_faces = 0, in_edges = 0, junctions = 0, several = 0,
              unresolved = 0, told = 0;
};

void count(const std::vector<PieceCurves>& parts, const CurveExtraction& whole,
           CurveCounts& counts) {
  for (const PieceCurves& part : parts) {
    for (const char shared : part.is_shared) counts.on_seams += shared != 0;
    for (const auto& line : part.keys.lines) {
      counts.in_faces += line.cell[2] >= 0 && line.cell[3] < 0;
      counts.in_edges += line.cell[2] < 0;
    }
    counts.told += part.told.size();
  }
  counts.lines += whole.curves.lines.size();
  for (const auto& component : counted(whole.curves))
    counts.junctions += static_cast<std::size_t>(component.junctions);
  counts.several += !whole.curves.component.empty() && whole.curves.component.back() > 0;
  counts.unresolved += whole.unresolved.size();
}

/// @param mesh  renumbered, cut and put together again
void compare(TetMesh mesh, Random& random, const std::string& where, CurveCounts& counts) {
  mesh.cell_ids.resize(mesh.tets.size());
  std::iota(mesh.cell_ids.begin(), mesh.cell_ids.end(), std::int64_t{0});
  const RenumberedMesh other = renumbered_mesh(mesh, random);
  const int pieces = random.integer(2, 16), kind = random.integer(0, 2);
  const auto owner = owners_of_kind(kind, other.mesh, pieces, random);
  for (const Degeneracy degeneracy : kDegeneracies) {
    const std::string which = where + ", " + std::to_string(pieces) + " pieces of kind " +
                              std::to_string(kind) +
                              (degeneracy == Degeneracy::linear ? ", linear" : ", planar");
    const CurveExtraction whole = extract_degenerate_curves(mesh, degeneracy);
    std::vector<PieceCurves> parts;
    for (int p = 0; p < pieces; ++p)
      parts.push_back(extract_curve_piece(piece_of_renumbered(other, owner, p), degeneracy));
    ASSERT_EQ(curve_difference(whole, merge_curve_pieces(parts)), "") << which;
    ASSERT_EQ(wrong_in_seams(parts, whole.curves), "") << which;
    count(parts, whole, counts);
  }
}

TEST(CurvePieces, GiveTheBitsOfTheWhole) {
  CurveCounts counts;
  const int fields = trials(24);
  for (int field = 0; field < fields; ++field) {
    Random random(20261128u + static_cast<unsigned>(field));
    compare(field_of_any_kind(random, 1 + field % 4, 6), random, "field " + std::to_string(field),
            counts);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(counts.lines, 10u * as_size(fields));
  EXPECT_GE(counts.on_seams, 10u * as_size(fields));
  EXPECT_GE(counts.several, as_size(fields) / 3);
}

RC_GTEST_PROP(CurvePieces, GiveTheBitsOfAnyWhole, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  CurveCounts counts;
  compare(field_of_any_kind(random, *rc::gen::inRange(1, 4), 6), random, "", counts);
  RC_ASSERT(!testing::Test::HasFailure());
  RC_CLASSIFY(counts.on_seams > 0);
  RC_CLASSIFY(counts.several > 0);
}

/// Ties, low ranks, planes of symmetry, isotropic vertices: lines in faces and along edges.
TEST(CurvePieces, GiveTheBitsOfTheWholeInSpecialPosition) {
  CurveCounts counts;
  const int fields = std::min(trials(3), 40);
  for (int field = 0; field < fields; ++field)
    for (const MeshKind kind : all_mesh_kinds()) {
      Random random(20261130u + static_cast<unsigned>(field));
      compare(special_mesh(kind, random), random, name_of(kind) + " " + std::to_string(field),
              counts);
      if (testing::Test::HasFailure()) return;
    }
  EXPECT_GE(counts.on_seams, 40u * as_size(fields));
  EXPECT_GE(counts.in_faces, 4u * as_size(fields));
  EXPECT_GE(counts.junctions, as_size(fields));
  EXPECT_GE(counts.unresolved, as_size(fields));
  EXPECT_GE(counts.told, as_size(fields));
}

/// The axis runs along edges of the mesh: each line belongs to one of the tetrahedra around.
TEST(CurvePieces, GiveTheLinesOfAnAxisAlongEdges) {
  TetMesh mesh = cube_mesh(2);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    const double x = (p.x - 1) - (p.y - 1) / 2, y = 7 * (p.y - 1) / 8;
    mesh.tensors[v] = {x * x, y * y, 2 + p.z, x * y, 0, 0};
  }
  CurveCounts counts;
  for (unsigned trial = 0; trial < 3; ++trial) {
    Random random(20261128u + trial);
    compare(mesh, random, "trial " + std::to_string(trial), counts);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(counts.in_edges, 6u);
  EXPECT_GE(counts.told, 12u);
}

void expect_same_box(const PlaceBox& a, const PlaceBox& b) {
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
}

/// Transitions between wedges and trisectors are computed from the cells of the merged curves.
TEST(CurvePieces, GiveTheTransitionsOfTheWhole) {
  Compared transitions("transitions", 5);
  for (int field = 0; field < 4; ++field) {
    Random random(20261130u + static_cast<unsigned>(field));
    TetMesh mesh = cube_mesh(3);
    fill_with_normal_tensors(mesh, 20261130u + static_cast<unsigned>(field));
    const CurveExtraction whole = extract_degenerate_curves(mesh, Degeneracy::linear);
    const MergedCurves merged =
        merge_curve_pieces(curve_pieces(mesh, bisected(mesh, 4), 4, Degeneracy::linear));
    const CurveMesh curves = curves_in_cells(merged);
    const CurveSeparation a = curve_separation(CurveArcs(mesh, Degeneracy::linear, whole.curves));
    const CurveSeparation b = curve_separation(CurveArcs(merged.cells, Degeneracy::linear, curves));
    ASSERT_EQ(a.lines.size(), b.lines.size());
    for (std::size_t i = 0; i < a.lines.size(); ++i) {
      EXPECT_EQ(a.lines[i].begin, b.lines[i].begin);
      EXPECT_EQ(a.lines[i].end, b.lines[i].end);
      ASSERT_EQ(a.lines[i].zeros.size(), b.lines[i].zeros.size());
      for (std::size_t k = 0; k < a.lines[i].zeros.size(); ++k, ++transitions)
        expect_same_box(a.lines[i].zeros[k], b.lines[i].zeros[k]);
    }
    ASSERT_EQ(a.jumps.size(), b.jumps.size());
    for (std::size_t i = 0; i < a.jumps.size(); ++i, ++transitions)
      EXPECT_EQ(a.jumps[i].vertex, b.jumps[i].vertex);
  }
}

/// Of curves across slabs the seam does not grow with their length.
TEST(CurveSeams, AreSmall) {
  const auto sizes = [](int cubes) {
    TetMesh mesh = cube_mesh(cubes);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double x = mesh.points[v].y / cubes - 0.37, y = mesh.points[v].z / cubes - 0.41;
      mesh.tensors[v] = {-1 + x, -1 - x, 2, y, 0.03 * mesh.points[v].x / cubes, 0};
    }
    const auto piece = extract_curve_piece(cut_piece(mesh, slabs(mesh, 2), 0), Degeneracy::linear);
    return std::pair(piece.curves.lines.size(), numbers_of(curve_seam_of(piece)).size());
  };
  const auto small = sizes(4), large = sizes(16);
  EXPECT_GE(small.first, 4u);
  EXPECT_GT(large.first, 3 * small.first);
  // Ids of owned tetrahedra are runs of slabs.
  EXPECT_LT(large.second, 16 * small.second);
}

}  // namespace
}  // namespace tensortopo::test
