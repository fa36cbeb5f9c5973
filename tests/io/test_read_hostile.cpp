// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Spoiled files: whatever the bytes, a valid mesh or an IoError.

#include <algorithm>
#include <cctype>
#include <random>

#include <gtest/gtest.h>

#include "field_files.hpp"
#include "support/trials.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

using Mode = VtkStyle::Mode;
using Compressor = VtkStyle::Compressor;

struct Sample {
  std::string extension, bytes;
};

/// A small field in every kind of file.
std::vector<Sample> samples() {
  const TetMesh field = cube_field(1);
  std::vector<Sample> result;
  const auto add_vtu = [&](const VtkStyle& style) {
    const auto file = temporary("sample.vtu");
    vtk_write_vtu(field, file, style);
    result.push_back({".vtu", slurp(file)});
  };
  add_vtu({Mode::ascii, Compressor::none});
  add_vtu({Mode::binary, Compressor::none, false});
  add_vtu({Mode::binary, Compressor::zlib, true, true, 64});
  add_vtu({Mode::appended_base64, Compressor::zlib});
  add_vtu({Mode::appended_raw, Compressor::none, true, true});
  add_vtu({Mode::appended_raw, Compressor::zlib, true, false, 64});
  add_vtu({Mode::appended_raw, Compressor::lz4, false, false, 64});
  add_vtu({Mode::appended_raw, Compressor::lzma, true, false, 128});
  for (const bool binary : {false, true})
    for (const bool version_5 : {false, true}) {
      const auto file = temporary("sample.vtk");
      vtk_write_legacy(field, file, binary, version_5, version_5 ? 6 : 9);
      result.push_back({".vtk", slurp(file)});
    }
  const std::filesystem::path corpus = TENSORTOPO_CORPUS;
  for (const char* name : {"frd/C3D10_binary", "frd/C3D4_text", "vti/ascii", "vti/binary",
                           "nii/four.nii", "nii/five.nii", "nii/scaled.nii", "vtk/structured_points"})
    result.push_back({"." + std::filesystem::path(name).parent_path().string(), slurp(corpus / name)});
  for (const char* name : {"nodes", "quadratic"})
    result.push_back({".e", slurp(corpus / "exo" / name)});
  return result;
}

/// Reads; true if it was read. Anything but an IoError fails the test.
bool survives(const Sample& sample, const std::string& bytes) {
  const auto file = put("spoiled" + sample.extension, bytes);
  ReadOptions options;
  options.tetrahedralize = options.cell_to_point = options.symmetrize = true;
  try {
    const ReadResult result = read_mesh(file, options);
    EXPECT_TRUE(validate(result.mesh).empty());
    EXPECT_FALSE(result.mesh.tets.empty());
    return true;
  } catch (const IoError& error) {
    EXPECT_EQ(error.kind(), invalid) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind(file.string() + ": ", 0), 0u) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return false;
  }
}

TEST(ReadHostile, SamplesAreReadUnspoiled) {
  for (const Sample& sample : samples()) EXPECT_TRUE(survives(sample, sample.bytes));
}

TEST(ReadHostile, FilesCutAtAnyByte) {
  for (const Sample& sample : samples()) {
    // The last bytes are white space, or follow all that is needed.
    const std::size_t needed = sample.bytes.size() * 3 / 4;
    for (std::size_t size = 0; size < sample.bytes.size(); size += 11) {
      const bool read = survives(sample, sample.bytes.substr(0, size));
      EXPECT_TRUE(!read || size >= needed) << sample.extension << " cut at " << size;
    }
  }
}

TEST(ReadHostile, FilesWithBytesChanged) {
  std::mt19937 random(20240229);
  for (const Sample& sample : samples())
    for (int round = 0; round < trials(300); ++round) {
      std::string bytes = sample.bytes;
      const auto somewhere = [&] { return random() % bytes.size(); };
      for (unsigned edits = 1 + random() % 4; edits > 0; --edits) switch (random() % 6) {
          case 0:
            bytes[somewhere()] = static_cast<char>(random());
            break;
          case 1:
            bytes[somewhere()] = "0123456789-.<>\"e \n"[random() % 18];
            break;
          case 2:
            bytes.erase(somewhere(), 1 + random() % 20);
            break;
          case 3:
            bytes.insert(somewhere(), bytes.substr(somewhere(), random() % 40));
            break;
          case 4:
            bytes[somewhere()] ^= static_cast<char>(1 << random() % 8);
            break;
          default:
            bytes[somewhere()] = static_cast<char>(random() % 2 ? 0xff : 0);
            break;
        }
      survives(sample, bytes);
    }
}

TEST(ReadHostile, EveryNumberOfTheMarkupReplaced) {
  for (const Sample& sample : samples()) {
    const std::size_t markup = std::min(sample.bytes.find("<AppendedData"), sample.bytes.size());
    for (std::size_t i = 0; i < markup; ++i) {
      if (!std::isdigit(static_cast<unsigned char>(sample.bytes[i]))) continue;
      if (i > 0 && std::isdigit(static_cast<unsigned char>(sample.bytes[i - 1]))) continue;
      if (sample.bytes.size() > 6000 && i % 5 != 0) continue;
      std::size_t end = i;
      while (end < markup && std::isdigit(static_cast<unsigned char>(sample.bytes[end]))) ++end;
      for (const char* number : {"-1", "0", "4294967295", "9223372036854775807", "nan", "1e400"})
        survives(sample, sample.bytes.substr(0, i) + number + sample.bytes.substr(end));
    }
  }
}

TEST(ReadHostile, DeepMarkup) {
  std::string deep = "<VTKFile type=\"UnstructuredGrid\">";
  for (int i = 0; i < 200000; ++i) deep += "<a>";
  survives({".vtu", ""}, deep);
  for (int i = 0; i < 200000; ++i) deep += "</a>";
  EXPECT_FALSE(survives({".vtu", ""}, deep + "</VTKFile>"));
}

/// An appended array with a compression header of our choice.
std::string with_compression_header(const std::vector<std::uint64_t>& words,
                                    const std::string& data) {
  std::string bytes;
  for (const std::uint64_t word : words)
    for (int i = 0; i < 8; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xff);
  TextVtu text;
  text.header += " compressor=\"vtkZLibDataCompressor\"";
  text.point_data =
      R"(<DataArray type="Float64" Name="stress" NumberOfComponents="6" format="appended" offset="0"/>)";
  std::string file = text.str();
  return file.insert(file.find("</VTKFile>"),
                     "<AppendedData encoding=\"raw\">_" + bytes + data + "</AppendedData>");
}

TEST(ReadHostile, CompressionHeadersThatLie) {
  const Sample sample{".vtu", ""};
  const std::string data(100, 'x');
  constexpr std::uint64_t huge = UINT64_MAX;
  for (const std::vector<std::uint64_t>& words : {std::vector<std::uint64_t>{1, 192, 0, 100},
                                                  {1, 192, 0, huge},
                                                  {huge, 192, 0, 1},
                                                  {0, 0, 0},
                                                  {2, huge, huge, 1, 1},
                                                  {1, huge, 0, 100},
                                                  {1, 100000000000, 0, 100},
                                                  {192, 1, 0},
                                                  {1, 192, 193, 100},
                                                  {1, 192},
                                                  {},
                                                  {3, 96, huge - 95, 1, 1, 1}})
    EXPECT_FALSE(survives(sample, with_compression_header(words, data)));
}

TEST(ReadHostile, ABombIsRefusedBeforeItGoesOff) {
  // All points promised, and a block that could not hold them.
  TextVtu text;
  text.header += " compressor=\"vtkZLibDataCompressor\"";
  text.points = "50000000";
  std::string file = text.str();
  const auto begin = file.find("<Points>"), end = file.find("</Points>");
  file.replace(
      begin, end - begin,
      R"(<Points><DataArray type="Float64" NumberOfComponents="3" format="appended" offset="0"/>)");
  std::string bytes;
  for (const std::uint64_t word : {1ull, 1200000000ull, 0ull, 100ull})
    for (int i = 0; i < 8; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xff);
  file.insert(file.find("</VTKFile>"), "<AppendedData encoding=\"raw\">_" + bytes +
                                           std::string(100, 'x') + "</AppendedData>");
  expect_error(put("bomb.vtu", file), invalid, {"Points", "promises more numbers"});
}

}  // namespace
}  // namespace tensortopo::test
