// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Whatever format a field is in, its certificate can be checked against the file as it is. The
// files are VTK's own; the checker and the library read them by code of their own.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>

#include "analysis/run_program.hpp"
#include "certificate_check/check_certificate.hpp"
#include "io/field_files.hpp"
#include "support/trials.hpp"
#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo::test {
namespace {

struct Format {
  std::string name, extension;
  std::function<void(const TetMesh&, const std::filesystem::path&)> write;
};

std::vector<Format> formats() {
  std::vector<Format> result;
  using Mode = VtkStyle::Mode;
  using Compressor = VtkStyle::Compressor;
  for (const Mode mode : {Mode::ascii, Mode::binary, Mode::appended_base64, Mode::appended_raw})
    for (const bool compressed : {false, true})
      for (const bool wide : {false, true}) {
        VtkStyle style;
        style.mode = mode;
        style.compressor = compressed ? Compressor::zlib : Compressor::none;
        style.wide_header = wide;
        style.big_endian = true;
        style.block = 64;  // several of an array
        result.push_back(
            {"big-endian .vtu " + std::to_string(result.size()), ".vtu",
             [style](const auto& mesh, const auto& file) { vtk_write_vtu(mesh, file, style); }});
      }
  for (const bool binary : {false, true})
    for (const bool version_5 : {false, true})
      for (const int components : {6, 9})
        result.push_back({std::string("legacy .vtk ") + (binary ? "BINARY " : "ASCII ") +
                              (version_5 ? "5.1 " : "4.2 ") + std::to_string(components),
                          ".vtk", [=](const auto& mesh, const auto& file) {
                            vtk_write_legacy(mesh, file, binary, version_5, components);
                          }});
  return result;
}

/// A field in a file, its surface and certificate.
struct Certified {
  explicit Certified(const Format& format)
      : input(folder / ("m" + format.extension)),
        surface(folder / "s.vtp"),
        certificate(folder / "c.json") {
    format.write(cube_field(1), input);
    const Outcome run =
        run_program({"extract", input, "-o", surface, "--mode", "0.2", "--certify", certificate});
    EXPECT_EQ(run.status, 0) << run.err;
  }

  std::string verdict() const {
    try {
      return certificate::check_certificate(input, surface, certificate).status();
    } catch (const certificate::Malformed& error) {
      return error.what();  // in the failure's text
    }
  }

  Folder folder;
  std::string input, surface, certificate;
};

TEST(CheckedFormats, EachIsCertifiedAsItIs) {
  for (const Format& format : formats()) {
    const Certified c(format);
    EXPECT_EQ(c.verdict(), "certified") << format.name;
  }
}

TEST(CheckedFormats, AnotherFieldInTheSameFormatIsRefuted) {
  for (const Format& format : formats()) {
    const Certified c(format);
    for (const int what : {0, 1, 2}) {
      TetMesh forged = cube_field(1);
      if (what == 0) forged.tensors[5].yz = std::nextafter(forged.tensors[5].yz, 1e9);
      if (what == 1) forged.points[7].z += 0x1p-10;  // texts have few digits
      if (what == 2) std::swap(forged.tets[0], forged.tets[1]);
      format.write(forged, c.input);
      EXPECT_EQ(c.verdict(), "refuted") << format.name << ' ' << what;
    }
  }
}

/// Files with a byte or two altered: what is certified is the same field for the library's reader.
TEST(CheckedFormats, NoAlteredFileIsCertifiedForAnotherField) {
  std::mt19937 random(7);
  std::size_t other = 0;
  for (const Format& format : formats()) {
    const Certified c(format);
    const std::string whole = slurp(c.input), hash = field_sha256(read_mesh(c.input).mesh);
    for (int i = 0; i < trials(40); ++i) {
      std::string bytes = whole;
      bytes[random() % bytes.size()] = "0123456789 -.e\n"[random() % 15];
      if (i % 8 == 0) bytes.resize(random() % bytes.size());
      std::ofstream(c.input, std::ios::binary) << bytes;
      const std::string verdict = c.verdict();
      try {
        if (field_sha256(read_mesh(c.input).mesh) == hash) continue;
      } catch (const IoError&) {
        continue;
      }
      ++other;
      EXPECT_NE(verdict, "certified") << format.name << ", edit " << i;
    }
  }
  EXPECT_GT(other, static_cast<std::size_t>(trials(50)));
}

/// What the checker does not read is refused before anything is extracted.
TEST(CheckedFormats, OthersAreNotCertified) {
  const Folder folder;
  const auto expect_refused = [&](const std::string& name, const std::string& reason) {
    for (const std::string level : {"--mode", "--invariant"}) {
      std::vector<std::string> words{"extract",   folder / name,     "-o", folder / "s.vtp",
                                     "--certify", folder / "c.json", level};
      words.push_back(level == "--mode" ? "0.2" : "magnitude");
      if (level != "--mode") words.insert(words.end(), {"--value", "3"});
      const Outcome run = run_program(words);
      EXPECT_EQ(run.status, 2) << run.err;
      EXPECT_EQ(run.err.find("tensortopo: " + (folder / name) + ": "), 0u) << run.err;
      EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    }
    const Outcome sweep =
        run_program({"analyze", folder / name, "--sweep", "0.1:0.2:2", "--check", "2", "--quiet"});
    EXPECT_EQ(sweep.status, 2) << sweep.err;
    EXPECT_NE(sweep.err.find(reason), std::string::npos) << sweep.err;
    EXPECT_EQ(
        run_program({"extract", folder / name, "-o", folder / "s.vtp", "--mode", "0.2"}).status, 0);
    std::filesystem::remove(folder / "s.vtp");
  };
  VtkStyle style;
  style.compressor = VtkStyle::Compressor::lz4;
  vtk_write_vtu(cube_field(1), folder / "lz4.vtu", style);
  expect_refused("lz4.vtu", "compressed by vtkLZ4DataCompressor");
  style.compressor = VtkStyle::Compressor::lzma;
  vtk_write_vtu(cube_field(1), folder / "lzma.vtu", style);
  expect_refused("lzma.vtu", "compressed by vtkLZMADataCompressor");

  // The same piece twice: points that agree become one, and so do not tear the field.
  TextVtu text;
  text.point_data =
      TextVtu::array("stress", 6, "0 0 0 0 0 1 0 0 0 0 1 0 3 -1 -2 0 0 0 -2 1 1 0 0 0");
  const std::string one = text.str();
  text.coordinates = "0 0 0  1 0 0  0 -1 0  0 0 1";
  const std::string two = text.str();
  const std::string end = "</UnstructuredGrid>";
  const auto begin = two.find("<Piece");
  std::ofstream(folder / "two.vtu") << one.substr(0, one.find(end)) +
                                           two.substr(begin, two.find(end) - begin) +
                                           one.substr(one.find(end));
  expect_refused("two.vtu", "not of one piece");
  std::ofstream(folder / "one.vtu") << one;
  for (const std::string name : {"index.pvtu", "INDEX.PVTU"}) {
    std::ofstream(folder / name) << "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>"
                                    "<Piece Source=\"one.vtu\"/></PUnstructuredGrid></VTKFile>\n";
    expect_refused(name, "neither a .vtu nor a .vtk");
  }
}

}  // namespace
}  // namespace tensortopo::test
