// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Surfaces that are extracted, said to be no surfaces for the eye, and refused with --strict.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/program/expect_line.hpp"
#include "analysis/run_program.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo::test {
namespace {

TEST(ExtractFailures, SurfacesThatTouchAtIsotropicVerticesAreSaid) {
  const Folder folder;
  const std::string file = folder / "isotropic.vtk";
  std::ofstream(file) << R"(# vtk DataFile Version 3.0
a tetrahedron with an isotropic vertex, at which two sheets meet
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 double
0 0 0  1 0 0  0 1 0  0 0 1
CELLS 1 5
4 0 1 2 3
CELL_TYPES 1
10
POINT_DATA 4
FIELD f 1
stress 6 4 double
200 200 200 0 0 0
-160 660 -500 -380 -480 140
-160 360 -200 -180 400 300
476 -876 400 -532 20 140
)";
  std::vector<std::string> words{"extract", file, "-o", folder / "s.vtp", "--mode", "4/5"};
  const Outcome plain = run_program(words);
  EXPECT_EQ(plain.status, 0) << plain.err;
  std::filesystem::remove(folder / "s.vtp");
  words.push_back("--strict");
  const Outcome strict = run_program(words);
  EXPECT_EQ(strict.status, 1);
  EXPECT_NE(strict.err.find("parts touch at isotropic vertices"), std::string::npos) << strict.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "s.vtp"));
}

// Two tetrahedra through each other: each surface is right, together they intersect.
TEST(ExtractFailures, StrictRefusesSurfacesOfAMeshThatOverlapsItself) {
  const Folder folder;
  const std::string file = folder / "overlap.vtk";
  std::ofstream(file) << R"(# vtk DataFile Version 3.0
two tetrahedra
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
0 0 0  1 0 0  0 1 0  0 0 1  -0.3 0.05 0.02  0.7 0.05 0.02  -0.3 1.05 0.02  -0.3 0.05 1.02
CELLS 2 10
4 0 1 2 3
4 4 5 6 7
CELL_TYPES 2
10 10
POINT_DATA 8
TENSORS s double
2 0 0 0 -1 0 0 0 -1
1 0 0 0 1 0 0 0 -2
1 0 0 0 1 0 0 0 -2
1 0 0 0 1 0 0 0 -2
1 0 0 0 1 0 0 0 -2
2 0 0 0 -1 0 0 0 -1
1 0 0 0 1 0 0 0 -2
1 0 0 0 1 0 0 0 -2
)";
  std::vector<std::string> words{"extract", file, "-o", folder / "s.vtp", "--mode", "0"};
  const Outcome plain = run_program(words);
  EXPECT_EQ(plain.status, 0) << plain.err;
  words.insert(words.end(), {"--certify", folder / "c.json"});
  const Outcome certified = run_program(words);
  EXPECT_EQ(certified.status, 0) << certified.err;
  EXPECT_NE((certified.out + certified.err).find("the mesh overlaps itself"), std::string::npos)
      << certified.out << certified.err;
  std::filesystem::remove(folder / "s.vtp");
  std::filesystem::remove(folder / "c.json");
  words.push_back("--strict");
  const Outcome strict = run_program(words);
  EXPECT_EQ(strict.status, 1);
  EXPECT_NE(strict.err.find("the mesh overlaps itself"), std::string::npos) << strict.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"overlap.vtk"});
}

/// A cube beside two tetrahedra that cut its side along the other diagonal.
std::string torn_mesh(const Folder& folder) {
  const std::string file = folder / "torn.vtk";
  std::ofstream(file) << R"(# vtk DataFile Version 3.0
a side with two diagonals
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 9 double
0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1  2 0.5 0.5
CELLS 3 19
8 0 1 2 3 4 5 6 7
4 1 2 5 8
4 2 6 5 8
CELL_TYPES 3
12 10 10
POINT_DATA 9
TENSORS6 stress double
1 0 -1 0 0 0
1 0.5 -1 0 0.3 0
1 0.9 -1 0 0 0.2
1 0.2 -1 0.1 0 0
1 -0.7 -1 0 0 0
1 -0.2 -1 0.4 0 0
1 -0.4 -1 0 0.1 0
1 0.1 -1 0 0.2 0.1
1 0.3 -1 0.2 0 0
)";
  return file;
}

TEST(ExtractFailures, ATornMeshIsSaidToBeSoAndRefusedIfStrict) {
  for (const std::string level : {"--mode", "--invariant"}) {
    const Folder folder;
    std::vector<std::string> words{"extract",        torn_mesh(folder),  "-o",
                                   folder / "s.vtp", "--tetrahedralize", level};
    words.push_back(level == "--mode" ? "0.1" : "magnitude");
    if (level != "--mode") words.insert(words.end(), {"--value", "3/2"});
    const std::string about =
        "4 faces lie on others without being shared (vertices 1 2 5 of cell 1, "
        "on 1 2 6 of cell 0)";
    const Outcome text = run_program(words);
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.err.find(about), std::string::npos) << text.err;
    EXPECT_NE(text.out.find(about), std::string::npos) << text.out;
    words.push_back("--json");
    const auto torn = nlohmann::json::parse(run_program(words).out)["input"]["torn_faces"];
    EXPECT_EQ(torn, nlohmann::json::parse(
                        R"({"count": 4, "vertices": [[1, 2, 5], [1, 2, 6]], "cells": [1, 0]})"));
    words.back() = "--strict";
    std::filesystem::remove(folder / "s.vtp");
    const Outcome strict = run_program(words);
    EXPECT_EQ(strict.status, 3);
    expect_error_line(strict, about);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"torn.vtk"});
  }
}

/// Two pieces; the face in which they meet is cut in one of them.
/// @param apart  how far one of them is moved
std::string torn_pieces(const Folder& folder, double apart = 0) {
  TetMesh above, below;
  above.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  above.tets = {{0, 1, 2, 3}};
  below.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {0, 0, -1}};
  below.tets = {{0, 3, 1, 4}, {0, 2, 3, 4}};
  for (TetMesh* mesh : {&above, &below})
    for (const auto& p : mesh->points) mesh->tensors.push_back({p.x, p.y, p.z - 1, p.y, p.z, 1});
  for (auto& p : above.points) p.z += apart;
  write_mesh(above, folder / "above.vtu");
  write_mesh(below, folder / "below.vtu");
  const std::string pieces = folder / "torn.pvtu";
  std::ofstream(pieces) << R"(<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>
<Piece Source="above.vtu"/><Piece Source="below.vtu"/></PUnstructuredGrid></VTKFile>)";
  return pieces;
}

TEST(ExtractFailures, PiecesThatDoNotShareFacesAreTornAlsoReadOneByOne) {
  for (const bool is_streamed : {false, true}) {
    const Folder folder;
    std::vector<std::string> words{
        "extract", torn_pieces(folder), "-o", folder / "s.vtp", "--mode", "0.1", "--json"};
    if (is_streamed) words.push_back("--stream");
    const std::string about =
        "3 faces lie on others without being shared (vertices 0 1 2 of cell 0, "
        "on 0 1 4 of cell 1)";
    const Outcome plain = run_program(words);
    EXPECT_EQ(plain.status, 0) << plain.err;
    EXPECT_NE(plain.err.find(about), std::string::npos) << plain.err;
    const auto torn = nlohmann::json::parse(plain.out)["input"]["torn_faces"];
    EXPECT_EQ(torn, nlohmann::json::parse(
                        R"({"count": 3, "vertices": [[0, 1, 2], [0, 1, 4]], "cells": [0, 1]})"));
    std::filesystem::remove(folder / "s.vtp");
    words.push_back("--strict");
    const Outcome strict = run_program(words);
    EXPECT_EQ(strict.status, 3);
    EXPECT_NE(strict.err.find(about), std::string::npos) << strict.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "s.vtp"));
  }
}

TEST(ExtractFailures, PiecesThatDoNotMeetAreSaidAlsoReadOneByOne) {
  const Folder folder;
  const std::string about = "pieces do not meet: no point has the coordinates of another's";
  for (const double apart : {0, 1}) {
    std::vector<std::string> words{
        "extract", torn_pieces(folder, apart), "-o", folder / "s.vtp", "--mode", "0.1"};
    EXPECT_EQ(run_program(words).err.find(about) != std::string::npos, apart != 0);
    words.push_back("--stream");
    EXPECT_EQ(run_program(words).err.find(about) != std::string::npos, apart != 0);
  }
}

/// Tensors that are multiples of the identity.
void write_isotropic(const std::string& file) {
  TetMesh mesh = cube_mesh(1);
  mesh.tensors.resize(mesh.points.size());
  for (std::size_t v = 0; v < mesh.tensors.size(); ++v)
    mesh.tensors[v] = static_cast<double>(v) * SymmetricTensor<double>{1, 1, 1, 0, 0, 0};
  write_mesh(mesh, file);
}

/// Also where the mesh is extracted in pieces, or read so.
TEST(ExtractFailures, StrictRefusesAFieldThatHasNoModeAnywhere) {
  const Folder folder;
  const std::string file = folder / "zero.vtu", pieces = folder / "zero.pvtu";
  write_isotropic(file);
  std::ofstream(pieces) << R"(<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>
<Piece Source="zero.vtu"/></PUnstructuredGrid></VTKFile>)";
  const std::vector<std::vector<std::string>> ways{
      {file}, {file, "--pieces", "2"}, {pieces, "--stream"}};
  for (const auto& way : ways) {
    std::vector<std::string> words{"extract", "-o", folder / "s.vtp", "--mode", "1/3"};
    words.insert(words.end(), way.begin(), way.end());
    const Outcome plain = run_program(words);
    EXPECT_EQ(plain.status, 0) << plain.err;
    EXPECT_NE(plain.err.find("the mode is undefined everywhere"), std::string::npos) << plain.err;
    std::filesystem::remove(folder / "s.vtp");
    words.push_back("--strict");
    const Outcome strict = run_program(words);
    EXPECT_EQ(strict.status, 1) << way.back();
    EXPECT_NE(strict.err.find("the mode is undefined everywhere"), std::string::npos) << strict.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "s.vtp"));
  }
}

TEST(Verify, HasNoRangeWhereThereAreNoCharacteristicTensors) {
  const Folder folder;
  const std::string file = folder / "zero.vtu";
  write_isotropic(file);
  std::vector<std::string> words{"verify",     "--input",  file, "--theorem",
                                 "mode-range", "--fields", "1"};
  EXPECT_EQ(run_program(words).out.find("its modes are"), std::string::npos);
  words.push_back("--json");
  const auto json = nlohmann::json::parse(run_program(words).out);
  EXPECT_EQ(json["input"]["characteristic_mode"], nlohmann::json({nullptr, nullptr})) << json;
}

}  // namespace
}  // namespace tensortopo::test
