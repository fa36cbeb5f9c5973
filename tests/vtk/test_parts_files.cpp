// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Files of parts: what VTK reads of them, and where they may be.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "parts/parts_folder.hpp"
#include "parts/xml_piece.hpp"
#include "tensortopo/io/temporary_folder.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {
namespace {

namespace fs = std::filesystem;
using filters::NewFolder;
using filters::PartsFiles;

/// Arrays below, at and above the size of a block, and empty ones.
TEST(PartsFiles, VtkReadsTheirArrays) {
  TemporaryFolder folder;
  constexpr std::size_t block = std::size_t{1} << 17;  // doubles
  for (const std::size_t count : {std::size_t{0}, std::size_t{5}, block, 2 * block + 7}) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(1 / (1.0 + static_cast<double>(i)));
    const std::vector<Vector3<double>> points(count, {1, 2, 3});
    std::vector<std::array<std::int32_t, 3>> triangles;
    if (count > 3) triangles = {{0, 1, 2}, {2, 1, 3}};
    filters::XmlPiece out("PolyData", {{"NumberOfPoints", std::to_string(count)},
                                       {"NumberOfPolys", std::to_string(triangles.size())}});
    out.begin("PointData", {{"Scalars", "a<b"}});
    out.array("a<b", numbers);
    out.end();
    out.begin("CellData");
    out.array("n", std::vector<std::int32_t>(triangles.size(), -4));
    out.end();
    out.begin("Points");
    out.array("Points", points);
    out.end();
    out.begin("Polys");
    out.cells(triangles);
    out.end();
    const fs::path file = folder.file(std::to_string(count) + ".vtp");
    write_text(file, out.finish());
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* read = reader->GetOutput();
    ASSERT_EQ(read->GetNumberOfPoints(), static_cast<vtkIdType>(count));
    ASSERT_EQ(read->GetNumberOfPolys(), static_cast<vtkIdType>(triangles.size()));
    vtkDataArray* array = read->GetPointData()->GetScalars();
    ASSERT_NE(array, nullptr);
    ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(count));
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(array->GetComponent(static_cast<vtkIdType>(i), 0), numbers[i]);
    if (triangles.empty()) continue;
    EXPECT_EQ(read->GetCellData()->GetArray("n")->GetComponent(1, 0), -4);
    EXPECT_EQ(read->GetCell(1)->GetPointId(2), 3);
  }
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A folder of our own, with all that is made in it.
class Place {
 public:
  explicit Place(const std::string& name) : path(folder_.file(name)) { fs::create_directory(path); }
  ~Place() { fs::remove_all(path); }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {}));
  }

 private:
  TemporaryFolder folder_;

 public:
  const fs::path path;
};

std::string refusal(const PartsFiles& files) {
  try {
    files.require_place();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PartsFiles, TakeTheirPlaceTogetherOrNotAtAll) {
  const Place place("together");
  const PartsFiles files(place.path / "a.json");
  EXPECT_EQ(refusal(files), "");
  const auto put = [&](const std::string& text) {
    NewFolder made(files.folder);
    filters::write_bytes(made.path() / files.output_of(0), text, files.folder);
    made.put_in_place({{files.output, text}, {files.certificate, text}});
  };
  put("first");
  put("second");
  EXPECT_EQ(text_of(files.folder / "a_0.vtp"), "second");
  EXPECT_EQ(text_of(files.certificate), "second");
  EXPECT_EQ(place.entries(), 3u);
  // A folder is where a file should be.
  fs::remove(files.certificate);
  fs::create_directories(files.certificate / "mine");
  EXPECT_THROW(put("third"), std::runtime_error);
  EXPECT_EQ(text_of(files.folder / "a_0.vtp"), "second");
  EXPECT_EQ(place.entries(), 3u);
  { const NewFolder unused(files.folder); }
  EXPECT_EQ(place.entries(), 3u);
}

TEST(PartsFiles, RefuseWhatIsNoCertificateOfParts) {
  const Place place("refused");
  const PartsFiles files(place.path / "a.json");
  const auto with = [&](const fs::path& file, const std::string& text) {
    write_text(file, text);
    const std::string said = refusal(files);
    fs::remove(file);
    return said;
  };
  EXPECT_THROW(PartsFiles("a.cbor"), std::runtime_error);
  EXPECT_NE(with(files.folder, "a file").find("in the place of the folder"), std::string::npos);
  EXPECT_NE(with(files.field, "Source=\"p_0.vtu\"").find("is another field"), std::string::npos);
  EXPECT_EQ(with(files.field, "Source=\"a/a_field_0.vtu\""), "");
  fs::create_directory(files.folder);
  for (const char* name : {"a_0.vtp", "a_17.json", "a_field_3.vtu"})
    EXPECT_EQ(with(files.folder / name, ""), "") << name;
  for (const char* name : {"a_0.vtu", "b_0.vtp", "a_.json", "a_x.vtp", "a_field_.vtu", "a_0.vtp~"})
    EXPECT_NE(with(files.folder / name, "").find("which is no part"), std::string::npos) << name;
  fs::create_directory(files.output);
  EXPECT_NE(refusal(files).find("is a folder"), std::string::npos);
  EXPECT_NE(refusal(PartsFiles(place.path / "none" / "a.json")).find("cannot be written"),
            std::string::npos);
}

}  // namespace
}  // namespace tensortopo
