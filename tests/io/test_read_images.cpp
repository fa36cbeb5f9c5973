// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Images: .vti, legacy STRUCTURED_POINTS and NIfTI, cut into tetrahedra.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {

const std::filesystem::path kExamples = std::filesystem::path(TENSORTOPO_EXAMPLES) / "formats";

constexpr std::array<int, 3> kSize{4, 3, 3};
float value(int sample, int component) {
  return std::sin(static_cast<float>(7 * sample + component)) / 3;
}

std::filesystem::path vtk_image(const std::string& name) {
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 2 + kSize[0] - 1, -1, -1 + kSize[1] - 1, 0, kSize[2] - 1);
  image->SetOrigin(1, 2, 3);
  image->SetSpacing(0.5, 1, 2);
  vtkNew<vtkFloatArray> tensors;
  tensors->SetName("D");
  tensors->SetNumberOfComponents(6);
  tensors->SetNumberOfTuples(image->GetNumberOfPoints());
  for (int v = 0; v < image->GetNumberOfPoints(); ++v)
    for (int c = 0; c < 6; ++c) tensors->SetComponent(v, c, value(v, c));
  image->GetPointData()->AddArray(tensors);
  vtkNew<vtkXMLImageDataWriter> writer;
  const auto file = temporary(name);
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  EXPECT_EQ(writer->Write(), 1);
  return file;
}

TEST(ReadVti, ImagesThatVtkWritesAreReadExactly) {
  const auto read = read_mesh(vtk_image("a.vti"));
  ASSERT_EQ(read.mesh.points.size(), 36u);
  EXPECT_EQ(read.mesh.tets.size(), 6u * 3 * 2 * 2);
  for (int v = 0; v < 36; ++v) {
    const auto i = static_cast<std::size_t>(v);
    const auto &p = read.mesh.points[i];
    EXPECT_EQ(p.x, 1 + 0.5 * (2 + v % 4));
    EXPECT_EQ(p.y, 2 + 1. * (-1 + v / 4 % 3));
    EXPECT_EQ(p.z, 3 + 2. * (v / 12));
    const auto& t = read.mesh.tensors[i];
    EXPECT_EQ(t.xx, double{value(v, 0)});
    EXPECT_EQ(t.xz, double{value(v, 5)});
  }
  EXPECT_NEAR(volume_of(read.mesh), 3 * 2 * 2 * 1.0, 1e-12);
}

TEST(ReadVti, VoxelsAreCutAlongTheSameDiagonalWithoutAFlag) {
  const auto read = read_mesh(vtk_image("a.vti"));
  EXPECT_EQ(read.report.split_cells, 12u);
  EXPECT_EQ(read.report.torn_faces.count, 0u);
  for (std::size_t t = 0; t < read.mesh.tets.size(); ++t) {
    // Each tetrahedron has the corners of its voxel with the least and the greatest numbers.
    const auto tet = read.mesh.tets[t];
    const std::set<int> corners(tet.begin(), tet.end());
    EXPECT_EQ(*corners.rbegin() - *corners.begin(), 1 + 4 + 12) << t;
  }
}

TEST(ReadVti, DirectionsTurnTheImage) {
  const auto file = std::filesystem::path(TENSORTOPO_CORPUS) / "vti" / "ascii";
  const auto read = read_mesh(put("a.vti", slurp(file)));
  ASSERT_EQ(read.mesh.points.size(), 12u);
  EXPECT_EQ(read.mesh.points[1].y, 2.5);  // the first axis of the image is y
  EXPECT_EQ(read.mesh.points[1].x, 1);
  EXPECT_EQ(read.report.components.source, ComponentSource::named);
  EXPECT_NEAR(volume_of(read.mesh), 2 * 0.5 * 1 * 2, 1e-12);
}

TEST(ReadVtiRefuses, WhatDoesNotFit) {
  const std::string text = slurp(std::filesystem::path(TENSORTOPO_CORPUS) / "vti" / "ascii");
  const auto refused = [&](const std::string& what, const std::string& by,
                           const std::vector<std::string>& parts) {
    std::string altered = text;
    const std::size_t at = altered.rfind(what);
    ASSERT_NE(at, std::string::npos) << what;
    expect_error(put("a.vti", altered.replace(at, what.size(), by)), invalid, parts);
  };
  refused("Extent=\"0 2 0 1 0 1\"", "Extent=\"0 2 0 1 0 0\"", {"1 samples along an axis"});
  refused("Extent=\"0 2 0 1 0 1\"", "Extent=\"0 2 0 1 0 2\"", {"numbers"});
  refused("Extent=\"0 2 0 1 0 1\"", "Extent=\"2 0 0 1 0 1\"", {"empty Extent"});
  refused("Extent=\"0 2 0 1 0 1\"", "Extent=\"0 900000 0 900000 0 900000\"", {"too many samples"});
  refused("Extent=\"0 2 0 1 0 1\"", "Extent=\"0 100 0 100 0 100\"", {"numbers"});
  refused("Spacing=\"0.5 1 2\"", "Spacing=\"0.5 0 2\"", {"one plane"});
  refused("Origin=\"1 2 3\"", "Origin=\"1 2\"", {});
}

TEST(ReadStructuredPoints, AreImages) {
  const auto file = std::filesystem::path(TENSORTOPO_CORPUS) / "vtk" / "structured_points";
  const std::string text = slurp(file);
  const auto read = read_mesh(put("a.vtk", text));
  EXPECT_EQ(read.mesh.points.size(), 12u);
  EXPECT_NEAR(volume_of(read.mesh), 2 * 0.5 * 2, 1e-12);
  const auto without = [&](const std::string& key) {
    std::string altered = text;
    const std::size_t at = altered.find(key);
    return altered.erase(at, altered.find('\n', at) + 1 - at);
  };
  expect_error(put("c.vtk", without("SPACING")), invalid, {"DIMENSIONS, ORIGIN and SPACING"});
  expect_error(put("d.vtk", without("DIMENSIONS")), invalid, {"no DIMENSIONS"});
}

/// A NIfTI-1 file of float32 in this machine's byte order.
struct Nifti {
  std::array<std::int16_t, 8> dim{4, 3, 2, 2, 6, 1, 1, 1};
  std::int16_t intent = 1005, type = 16, sform = 1;
  float slope = 0;
  std::size_t values = 3 * 2 * 2 * 6;

  std::string bytes() const {
    std::string b(352, '\0');
    const auto set = [&](std::size_t at, auto x) { std::memcpy(b.data() + at, &x, sizeof x); };
    set(0, std::int32_t{348});
    for (std::size_t i = 0; i < 8; ++i) set(40 + 2 * i, dim[i]);
    set(68, intent), set(70, type), set(72, std::int16_t{32});
    for (std::size_t i = 0; i < 4; ++i) set(76 + 4 * i, 2.f);
    set(108, 352.f), set(112, slope), set(116, 1.f), set(254, sform);
    set(280, -1.f), set(280 + 12, 10.f), set(296 + 4, 2.f), set(312 + 8, 3.f);
    std::memcpy(b.data() + 344, "n+1", 4);
    for (std::size_t i = 0; i < values; ++i) {
      const float x = value(static_cast<int>(i), 0);
      b.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
    return b;
  }
};

TEST(ReadNifti, ValuesPlacesAndOrderAreThoseOfTheHeader) {
  const auto read = read_mesh(put("a.nii", Nifti().bytes()));
  ASSERT_EQ(read.mesh.points.size(), 12u);
  EXPECT_EQ(read.report.components.order, ComponentOrder::nifti);
  EXPECT_EQ(read.report.components.source, ComponentSource::named);
  EXPECT_EQ(read.mesh.points[1].x, 9);  // mirrored
  EXPECT_NEAR(volume_of(read.mesh), 2 * 1 * 1 * (1. * 2 * 3), 1e-12);
  for (int v = 0; v < 12; ++v) {
    const auto& t = read.mesh.tensors[static_cast<std::size_t>(v)];
    EXPECT_EQ(t.xy, double{value(v + 12, 0)});
    EXPECT_EQ(t.yy, double{value(v + 24, 0)});
    EXPECT_EQ(t.zz, double{value(v + 60, 0)});
  }
}

TEST(ReadNifti, TheFifthDimensionIsTheSame) {
  Nifti five;
  five.dim = {5, 3, 2, 2, 1, 6, 1, 1};
  expect_same_field(read_mesh(put("a.nii", five.bytes())).mesh,
                    read_mesh(put("b.nii", Nifti().bytes())).mesh);
}

TEST(ReadNifti, ScalesAreAppliedAndSaid) {
  Nifti scaled;
  scaled.slope = 2;
  const auto read = read_mesh(put("a.nii", scaled.bytes()));
  EXPECT_EQ(read.mesh.tensors[0].xx, 2 * double{value(0, 0)} + 1);
  EXPECT_NE(read.report.notes.back(), "");
  std::string notes;
  for (const auto& note : read.report.notes) notes += note + "\n";
  EXPECT_NE(notes.find("scaled by 2 and shifted by 1"), std::string::npos) << notes;
}

TEST(ReadNifti, WithoutIntentTheOrderMustBeSaid) {
  Nifti silent;
  silent.intent = 0;
  const auto file = put("a.nii", silent.bytes());
  expect_error(file, invalid, {"--components", "mrtrix"});
  ReadOptions options;
  options.components = ComponentOrder::fsl;
  EXPECT_EQ(read_mesh(file, options).report.components.source, ComponentSource::given);
  expect_error(put("b.nii", Nifti().bytes()), inapplicable, {"contradicts", "nifti"}, options);
}

TEST(ReadNifti, MrtrixFitIsReadWithinItsMask) {
  ReadOptions options;
  options.components = component_order("mrtrix");
  const auto whole = read_mesh(kExamples / "tensor.nii.gz", options);
  EXPECT_EQ(whole.mesh.points.size(), 14u * 12 * 10);
  options.mask = kExamples / "mask.nii.gz";
  const auto masked = read_mesh(kExamples / "tensor.nii.gz", options);
  EXPECT_LT(masked.mesh.points.size(), 2 * whole.mesh.points.size() / 3);
  EXPECT_GT(masked.mesh.tets.size(), 1000u);
  EXPECT_NE(masked.sha256, whole.sha256);
  // Outside its mask MRtrix writes zeros.
  for (const auto& t : masked.mesh.tensors) EXPECT_GT(t.xx + t.yy + t.zz, 0);
}

TEST(ReadNiftiRefuses, WhatDoesNotFit) {
  const auto refused = [](const Nifti& file, const std::vector<std::string>& parts) {
    expect_error(put("a.nii", file.bytes()), invalid, parts);
  };
  Nifti file;
  file.values = 71;
  refused(file, {"ends before its 72 values"});
  (file = {}).dim[4] = 7;
  file.values = 84;
  refused(file, {"dimensions 4 and 5", "7 and 1"});
  (file = {}).dim[3] = 1;
  refused(file, {"1 samples along an axis"});
  (file = {}).dim[1] = -3;
  refused(file, {"-3 voxels"});
  (file = {}).dim = {4, 32767, 32767, 32767, 6, 1, 1, 1};
  refused(file, {"too many samples"});
  (file = {}).type = 128;
  refused(file, {"type 128"});
  const std::string bytes = Nifti().bytes();
  expect_error(put("short.nii", bytes.substr(0, 100)), invalid, {"too short"});
  expect_error(put("text.nii", std::string(400, 'x')), invalid, {"is no NIfTI image"});
  std::string two_files = bytes;
  two_files[345] = 'i';
  expect_error(put("two.nii", two_files), invalid, {"image in two files"});
  expect_error(put("gz.nii.gz", "\x1f\x8b\x08 damaged"), invalid, {"gzip"});
}

TEST(ReadNiftiRefuses, MasksOfOtherImages) {
  const auto field = put("a.nii", Nifti().bytes());
  Nifti mask;
  mask.dim = {3, 3, 2, 2, 1, 1, 1, 1};
  mask.values = 12;
  ReadOptions options;
  options.mask = put("mask.nii", mask.bytes());
  // The first value is 0, so the first of the two cubes is left out.
  EXPECT_EQ(read_mesh(field, options).mesh.points.size(), 8u);
  mask.dim[1] = 2, mask.values = 8;
  options.mask = put("small.nii", mask.bytes());
  EXPECT_NE(std::string(error_of(field, options).what()).find("2 x 2 x 2 voxels"), std::string::npos);
  (mask = {}).dim = {3, 3, 2, 2, 1, 1, 1, 1};
  mask.values = 12, mask.sform = 0;
  options.mask = put("moved.nii", mask.bytes());
  EXPECT_NE(std::string(error_of(field, options).what()).find("elsewhere"), std::string::npos);
  expect_error(put("a.vtu", TextVtu().str()), inapplicable, {"--mask"}, options);
}

}  // namespace
}  // namespace tensortopo::test
