// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Legacy files that VTK reads otherwise than a reader of words or of lines would.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "files/files.hpp"
#include "support/folder.hpp"

namespace tensortopo::test {
namespace {

const std::string kTitle = "# vtk DataFile Version 5.1\na field\n";
const std::string kGrid =
    "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 4\n"
    "OFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_TYPES 1\n10\n";
const std::string kNumbers = "1 2 3 4 5 6 6 5 4 3 2 1 1 0 0 0 0 1 0 0 1 1 0 0\n";
const std::string kData = "POINT_DATA 4\nTENSORS6 stress double\n" + kNumbers;
const std::string kNames = "XX\nYY\nZZ\nXY\nYZ\nXZ\n";

std::string edited(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

/// The grid, with information on its points.
std::string grid_with(const std::string& information) {
  const std::size_t at = kGrid.find("CELLS");
  return kGrid.substr(0, at) + "METADATA\n" + information + "\n" + kGrid.substr(at);
}

TEST(LegacyGrammar, IsThatOfVtk) {
  const Folder folder;
  const std::string name = folder / "field.vtk";
  const auto is_read = [&](const std::string& text) {
    std::ofstream(name, std::ios::binary) << text;
    try {
      certificate::read_input(certificate::read_file(name), "stress", "vtk");
      return true;
    } catch (const certificate::Malformed&) {
      return false;
    }
  };
  const std::string start = kTitle + kGrid, whole = start + kData;
  const std::string information =
      "INFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 1 2\n";
  for (const std::string& text :
       {whole, whole + "METADATA\nCOMPONENT_NAMES\n" + kNames + "\n",
        whole + "METADATA\ncomponent_names\n" + kNames + information + "\n",
        whole + "METADATA\n" + information + "\n",
        start + "POINT_DATA 4\nSCALARS s float\nLOOKUP_TABLE t\n1 2 3 4\nLOOKUP_TABLE t 1\n0 0 0 1\n"
                "TEXTURE_COORDINATES c 2 float\n0 0 0 1 1 0 1 1\nCOLOR_SCALARS k 1\n0 0.5 1 1\n"
                "TENSORS6 stress double\n" + kNumbers,
        kTitle + grid_with(information) + kData,
        kTitle + edited(kGrid, "OFFSETS vtktypeint64", "OFFSETS vtkIdType") + kData,
        kTitle + edited(edited(kGrid, "OFFSETS vtktypeint64", "OFFSETS int"),
                          "CONNECTIVITY vtktypeint64", "CONNECTIVITY int") + kData,
        start + "POINT_DATA 4\nTENSORS6 other double\n" + kNumbers + "FIELD f 1\nstress 6 4 double\n" + kNumbers,
        start + "POINT_DATA 4\nFIELD f 2\nt 1 4 string\n" + std::string(300, 'a') +
            "\nMETADATA\n\nx\nstress 6 4 double\n" + kNumbers,
        start + "POINT_DATA 4\nFIELD FieldData 3\nNULL_ARRAY\nother 0 4 int\nstress 6 4 double\n" +
            kNumbers + "METADATA\n" + information + "\n",
        start + "CELL_DATA 1\nSCALARS a%20b int\nLOOKUP_TABLE default\n1\nFIELD f 1\nt 1 1 string\na\n" + kData})
    EXPECT_TRUE(is_read(text)) << text;
  std::size_t refused = 0;
  const std::string zero(1, '\0'), scalars = "SCALARS ";
  for (const std::string& text : std::vector<std::string>{
           // Names that end, or are changed, where they are decoded.
           whole + "TENSORS6 stress" + zero + "x double\n" + kNumbers,
           whole + "TENSORS6 stress%00 double\n" + kNumbers,
           whole + "TENSORS6 stress%0Gx double\n" + kNumbers,
           whole + "TENSORS6 stress%+0 double\n" + kNumbers,
           whole + "TENSORS6 stress double\n" + kNumbers,
           start + "CELL_DATA 1\nSCALARS vtkGhostType%00 unsigned_char\nLOOKUP_TABLE default\n1\n" + kData,
           start + "CELL_DATA 1\nSCALARS vtkGhostType unsigned_char\nLOOKUP_TABLE default\n1\n" + kData,
           // Where METADATA ends.
           whole + "METADATA\n" + zero + "\nTENSORS6 other double\n" + kNumbers + "\n",
           whole + "METADATA\n \nTENSORS6 other double\n" + kNumbers + "\n",
           whole + "METADATA\nCOMPONENT_NAMES\nXX\nYY\n\nXY\nYZ\nXZ\n\n",
           whole + "METADATA\nCOMPONENT_NAMES x\n" + kNames + "\n",
           whole + "METADATA\nINFORMATION 2\nNAME a LOCATION b\nDATA 1 2\n\n",
           start + "METADATA\n" + information + "\n" + kData,
           whole + "metadata x\n" + information + "\n",
           whole + " METADATA\n" + information + "\n",
           whole + "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 1\n2\n\n",
           whole + "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 0\n\n",
           // What others take for a keyword, or for a number.
           start + "POINT_DATA 4\nFIELD f 2\nstress 6 4 double\n" + kNumbers +
               "metadatax 1 2 int\n1 2\n",
           start + "POINT_DATA 4\nFIELD f 2\nNULL_ARRAY 1 1 int\n1\nstress 6 4 double\n" + kNumbers,
           start + "POINT_DATA 4\nSCALARS stress double LOOKUP_TABLE\nLOOKUP_TABLE 6\n" + kNumbers,
           start + "POINT_DATA 4\nSCALARS stress double 6x\nLOOKUP_TABLE default\n" + kNumbers,
           start + "POINT_DATA 4\nSCALARS stress double 6 LOOKUP_TABLE\ndefault\n" + kNumbers,
           start + "POINT_DATA 4\n TENSORS6 stress double\n" + kNumbers,
           start + "POINT_DATA 4\nTENSORS6\nstress double\n" + kNumbers,
           start + "POINT_DATA 4\nTENSORS6 stress double\n" + "5 " + kNumbers,
           "# vtk DataFile Version 5\na field\n" + kGrid + kData,
           "# vtk DataFile Version 5.1x\na field\n" + kGrid + kData,
           "# vtk DataFile Version 05.1\na field\n" + kGrid + kData,
           start + "POINT_DATA 4\nTENSORS6 stress double\n" + kNumbers + kGrid.substr(32),
           // Attributes at which others give up, and read what follows as data of points.
           whole + "CELL_DATA 1\nVECTORS v string\na\nb\nc\nFIELD f 1\nother 6 4 double\n" + kNumbers,
           whole + "CELL_DATA 1\nTEXTURE_COORDINATES t 0 double\n",
           whole + "CELL_DATA 1\nTEXTURE_COORDINATES t 9 double\n1 2 3 4 5 6 7 8 9\n",
           whole + "CELL_DATA 1\nEDGE_FLAGS e int\n1\n",
           whole + "CELL_DATA 1\nPEDIGREE_IDS e string\na\n",
           whole + "CELL_DATA 1\nFIELD f 1\nother 6 4 double\n" + kNumbers,
           whole + "CELL_DATA 1\nFIELD f 1\nstress 6 1 double\n1 2 3 4 5 6\n",
           // What others leave out, or crash at.
           kTitle + edited(kGrid, "OFFSETS vtktypeint64", "OFFSETS int") + kData,
           kTitle + edited(kGrid, "CONNECTIVITY vtktypeint64", "CONNECTIVITY int") + kData,
           kTitle + edited(kGrid, "CELL_TYPES 1\n10", "CELL_TYPES 1\n42") + kData,
           start + "POINT_DATA 4\nTENSORS6 other double\n" + kNumbers + "TENSORS6 stress double\n" + kNumbers,
           start + "POINT_DATA 4\nTENSORS o double\n" + kNumbers + "1 2 3 4 5 6 7 8 9 1 2 3\nTENSORS6 stress double\n" + kNumbers,
           start + "POINT_DATA 4\nCOLOR_SCALARS c 1\n0 0 0 0\nSCALARS stress double 6\nLOOKUP_TABLE default\n" + kNumbers,
           // Arrays by another way.
           whole + "COLOR_SCALARS stress 6\n" + kNumbers,
           start + "POINT_DATA 4\nCOLOR_SCALARS stress 6\n" + kNumbers,
           whole + "COLOR_SCALARS %73tress 6\n" + kNumbers,
           whole + "CELL_DATA 1\nCOLOR_SCALARS vtkGhostType 1\n1\n",
           whole + "COLOR_SCALARS other 1\n0 0 1 1\nMETADATA\n" + information + "\n",
           // Types that others wrap around, skip or read otherwise.
           start + "POINT_DATA 4\nTENSORS6 stress char\n186 " + kNumbers.substr(2),
           start + "POINT_DATA 4\nTENSORS6 stress unsigned_int\n-6 " + kNumbers.substr(2),
           start + "POINT_DATA 4\nTENSORS6 stress int\n3454763386 " + kNumbers.substr(2),
           start + "POINT_DATA 4\nTENSORS6 stress bit\n" + kNumbers,
           start + "POINT_DATA 4\nFIELD f 2\nt 1 2 string\nstress 6 4 double\n" + kNumbers,
           start + "POINT_DATA 4\nFIELD f 1\nstress 6 4 string\n" + kNumbers,
           start + "POINT_DATA 4\nFIELD f 2\nt 1 1 double\ninf\nstress 6 4 double\n" + kNumbers,
           start + "POINT_DATA 4\nFIELD f 2\nt 1 1 double\n1e999\nstress 6 4 double\n" + kNumbers,
           start + "POINT_DATA 4\nFIELD f 1\nstress 6 4 double\n" + kNumbers +
               "POINT_DATA 4\nTENSORS6 stress double\n" + kNumbers,
           whole + "METADATA\ncomponent_names\nXX\nYY\nZZ\nYZ\nXZ\nXY\n\n",
           // Numbers of data, and what follows on a line.
           start + "POINT_DATA 3\nTENSORS6 stress double\n" + kNumbers,
           start + "CELL_DATA 2\nSCALARS a int\nLOOKUP_TABLE default\n1 2\n" + kData,
           start + "POINT_DATA 4\nTENSORS6 stress double x\n" + kNumbers,
           // Words and lines that are cut.
           start + "POINT_DATA 4\nTENSORS6 stress double\n" + kNumbers + scalars +
               std::string(255, 'y') + " int\nLOOKUP_TABLE default\n1 2 3 4\n",
           "# vtk DataFile Version 5.1\n" + std::string(300, 'y') + "\n" + kGrid + kData}) {
    EXPECT_FALSE(is_read(text)) << text;
    ++refused;
  }
  EXPECT_EQ(refused, 62u);
}

}  // namespace
}  // namespace tensortopo::test
