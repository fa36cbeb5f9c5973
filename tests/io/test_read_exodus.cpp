// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Exodus II: files in the corpus are written by the NetCDF library; quadratic elements
// are in the order that VTK reads.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "field_files.hpp"
#include "tensortopo/io/field_steps.hpp"

namespace tensortopo::test {
namespace {

std::string exodus(const std::string& name) {
  return slurp(std::filesystem::path(TENSORTOPO_CORPUS) / "exo" / name);
}

TEST(ReadExodus, NamesOfScalarsSpellTheTensor) {
  const auto read = read_mesh(put("a.e", exodus("nodes")));
  EXPECT_EQ(read.report.tensor_name, "stress");
  EXPECT_EQ(read.report.components.source, ComponentSource::named);
  ASSERT_EQ(read.mesh.points.size(), 5u);
  // The last of two steps; the variables are T, xx, yy, zz, xy, xz, yz.
  const auto& t = read.mesh.tensors[3];
  EXPECT_EQ(t.xx, 123);
  EXPECT_EQ(t.yy, 133);
  EXPECT_EQ(t.zz, 143);
  EXPECT_EQ(t.xy, 153);
  EXPECT_EQ(t.xz, 163);
  EXPECT_EQ(t.yz, 173);
  ReadOptions options;
  options.step = 1;
  EXPECT_EQ(read_mesh(put("a.e", exodus("nodes")), options).mesh.tensors[3].xx, 23);
  EXPECT_EQ(field_steps(put("a.e", exodus("nodes"))), (std::vector<std::string>{"time 0", "time 1"}));
}

// VTK's writer names the components of an array in VTK's order (XX, YY, ZZ, XY, YZ, XZ) XX, XY, XZ,
// YY, YZ, ZZ.
TEST(ReadExodus, NamesThatVtkMakesUpAreNotBelieved) {
  const auto formats = std::filesystem::path(TENSORTOPO_EXAMPLES) / "formats";
  expect_error(formats / "plate.e", invalid, {"in which order", "`STRESS`", "--components"});
  ReadOptions options;
  options.components = ComponentOrder::vtk;
  const auto read = read_mesh(formats / "plate.e", options);
  ReadOptions first;
  first.step = 1;
  const auto plate = read_mesh(formats / "plate.frd", first);
  ASSERT_EQ(read.mesh.tensors.size(), plate.mesh.tensors.size());
  EXPECT_GT(read.mesh.tensors.size(), 1000u);
  EXPECT_EQ(read.mesh.tets, plate.mesh.tets);
  for (std::size_t v = 0; v < plate.mesh.tensors.size(); ++v) {
    const auto &a = read.mesh.tensors[v], &b = plate.mesh.tensors[v];
    ASSERT_TRUE(a.xx == b.xx && a.yy == b.yy && a.zz == b.zz && a.xy == b.xy && a.yz == b.yz &&
                a.xz == b.xz)
        << v;
  }
}

TEST(ReadExodus, NineNamesAreAMatrix) {
  ReadOptions options;
  expect_error(put("a.exo", exodus("matrix")), invalid, {"not symmetric", "--symmetrize"}, options);
  options.symmetrize = true;
  options.step = 1;
  const auto read = read_mesh(put("a.exo", exodus("matrix")), options);
  EXPECT_EQ(read.report.tensor_name, "sig");
  EXPECT_EQ(read.mesh.tensors[0].xx, 10);
  EXPECT_EQ(read.mesh.tensors[0].xy, (20 + 40) / 2.);
  EXPECT_EQ(read.mesh.tensors[0].zz, 90);
}

TEST(ReadExodus, BlocksAreMaterialsOfTensorsOfElements) {
  const auto file = put("a.e", exodus("elements"));
  expect_error(file, invalid, {"belong to cells", "--cell-to-point"});
  ReadOptions options;
  options.cell_to_point = true;
  expect_error(file, invalid, {"2 materials", "`ObjectId`"}, options);
  options.materials = "none";
  const auto read = read_mesh(file, options);
  EXPECT_EQ(read.mesh.tensors[0].xx, 111);
  EXPECT_EQ(read.mesh.tensors[1].xx, 111.5);
  EXPECT_EQ(read.mesh.tensors[4].xz, 162);  // S31 is the sixth
}

TEST(ReadExodus, QuadraticElementsHaveStraightEdges) {
  const auto read = read_mesh(put("a.e", exodus("quadratic")));
  EXPECT_EQ(read.report.quadratic_cells, 3u);
  EXPECT_EQ(read.report.curved_edges, 0u);
  EXPECT_EQ(read.report.added_vertices, 7u + 3u);  // of the hexahedron of 20 and the wedge
  EXPECT_NEAR(volume_of(read.mesh), 1. / 6 + 1. / 2 + 1, 1e-12);
  std::size_t compared = 0;
  for (std::size_t v = 0; v + 10 < read.mesh.points.size(); ++v) {
    const auto &p = read.mesh.points[v];
    const auto& t = read.mesh.tensors[v];
    EXPECT_EQ(t.xx, p.x + p.y * p.z);
    EXPECT_EQ(t.xz, p.x * p.x + 5);
    ++compared;
  }
  EXPECT_EQ(compared, 10u + 15 + 20);
}

TEST(ReadExodus, NodesOfFacesAreAtTheirCentres) {
  // As VTK's reader orders them, too.
  const auto read = read_mesh(put("a.e", exodus("hex27")));
  EXPECT_EQ(read.report.curved_edges, 0u);
  EXPECT_EQ(read.report.added_vertices, 0u);
  EXPECT_EQ(read.mesh.points.size(), 27u);
  EXPECT_NEAR(volume_of(read.mesh), 1, 1e-12);
  for (const auto& t : read.mesh.tets) {
    // Each part lies in one of the eight small cubes.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = 1, high = 0;
      for (const auto v : t) {
        const auto& p = read.mesh.points[static_cast<std::size_t>(v)];
        const double x = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        low = std::min(low, x), high = std::max(high, x);
      }
      EXPECT_EQ(high - low, 0.5);
    }
  }
}

TEST(ReadExodusRefuses, WhatIsCutOffOrIsNone) {
  const std::string bytes = exodus("nodes");
  // The NetCDF library takes what is missing for zeros.
  expect_error(put("a.e", bytes.substr(0, bytes.size() - 8)), invalid, {"ends within the values"});
  expect_error(put("b.e", bytes.substr(0, 200)), invalid, {"ends within"});
  expect_error(put("c.e", "\x89HDF\r\n"), invalid, {"NetCDF-4", "nccopy -k cdf5"});
  expect_error(put("d.e", "CDF\x03    "), invalid, {"no NetCDF file of a classic format"});
  expect_error(put("e.e", "hello, world"), invalid, {"no NetCDF file"});
  std::string other = bytes;
  const std::size_t at = other.find("TETRA4");
  ASSERT_NE(at, std::string::npos);
  expect_error(put("f.e", other.replace(at, 6, "NFACED")), invalid, {"NFACED of 4 nodes", "block"});
  ReadOptions options;
  options.step = 3;
  expect_error(put("g.e", bytes), IoError::Kind::inapplicable, {"steps 1 to 2"}, options);
}

}  // namespace
}  // namespace tensortopo::test
