// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Files that would exhaust or mislead a reader, and what readers of other programs write.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "files/component_names.hpp"
#include "files/files.hpp"
#include "files/parse_document.hpp"
#include "files/word_number.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "support/folder.hpp"

namespace tensortopo::test {
namespace {

using certificate::Malformed;
using certificate::parse_cbor;
using certificate::parse_json;
using certificate::Spelling;
using Json = nlohmann::json;

TEST(HostileDocuments, AreRefusedInOneLine) {
  const std::string deep(100000, '[');
  for (const std::string& text :
       {deep, std::string(50000, '{'), std::string("{\"a\":1,\"a\":1}"), std::string("1.5"),
        std::string("1e3"), std::string("01"), std::string("[1,]"), std::string("[1]x"),
        std::string("\"\xff\""), std::string("\"\\ud800\""), std::string("18446744073709551616"),
        std::string("-9223372036854775809"), std::string("\"a\nb\""), std::string("tru"),
        std::string("\"\xed\xa0\x80\""), std::string("-"), std::string()})
    EXPECT_THROW(parse_json(text), Malformed) << text.substr(0, 40);
  for (const std::string& bytes :
       {std::string(50000, '\x7f'), std::string(50000, '\x5f'), std::string(50000, '\x9f'),
        std::string(50000, '\xbf'), std::string(50000, '\x81'),
        std::string("\xfb\0\0\0\0\0\0\0\0", 9), std::string("\x9b\xff\xff\xff\xff\xff\xff\xff\xff"),
        std::string("\x62\xff\xff"), std::string("\xc0\x01"), std::string("\x01\x01"),
        std::string("\x3b\xff\xff\xff\xff\xff\xff\xff\xff"),
        std::string("\xa2\x61\x61\x01\x61\x61\x01"), std::string("\xa1\x01\x01"), std::string()})
    EXPECT_THROW(parse_cbor(bytes), Malformed);
}

TEST(HostileDocuments, DoNotTakeMuchMoreMemoryThanTheyHave) {
  // A million empty arrays, of one byte each.
  const std::size_t count = 1U << 20;
  std::string bytes("\x9a\0\x10\0\0", 5);
  EXPECT_NO_THROW(parse_cbor(bytes + std::string(count, '\x01')));
  EXPECT_THROW(parse_cbor(bytes + std::string(count, '\x80')), Malformed);
  EXPECT_THROW(parse_cbor(bytes + std::string(count, '\xa0')), Malformed);
}

TEST(HostileDocuments, WhatIsWellFormedIsReadAsOthersReadIt) {
  const Json document{{"a", {1, -2, "x\u00e9\"\\", true, false, nullptr, Json::object()}},
                      {"b", {UINT64_MAX, INT64_MIN, Json::array()}},
                      {"c", "\xf0\x9f\x98\x80"}};
  EXPECT_EQ(parse_json(document.dump()), document);
  EXPECT_EQ(parse_json(document.dump(2, ' ', true)), document);
  const auto bytes = Json::to_cbor(document);
  EXPECT_EQ(parse_cbor(std::string(bytes.begin(), bytes.end())), document);
}

// As where two arguments changed places.
TEST(HostileDocuments, OtherFilesAreNamedAsSuch) {
  const Folder folder;
  const std::string file = folder / "s.vtp";
  for (const char* bytes :
       {"<?xml version=\"1.0\"?><VTKFile/>", "<VTKFile/>", "# vtk DataFile Version 3.0\n"}) {
    std::ofstream(file) << bytes;
    try {
      certificate::check_certificate(file, file, file);
      ADD_FAILURE() << bytes;
    } catch (const Malformed& error) {
      EXPECT_NE(error.problem().find("FIELD SURFACE CERTIFICATE"), std::string::npos)
          << error.what();
    }
  }
}

TEST(HostileFiles, PipesAndDevicesAreNotRead) {
  const std::string pipe = testing::TempDir() + "/pipe_" + std::to_string(getpid());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& file : {pipe, std::string("/dev/zero"), std::string("/dev/null")})
    EXPECT_THROW(certificate::check_certificate(file, file, file), Malformed);
  unlink(pipe.c_str());
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

/// Whatever other readers would find somewhere else.
TEST(HostileFiles, HaveOneReading) {
  Court court("one_reading");
  const Exhibit& e = honest_exhibits()[0];
  const std::string field = e.field_text(), surface = e.surface_text(), cert = e.certificate.dump();
  ASSERT_EQ(court.verdict(field, surface, cert), "certified") << court.report();
  const std::string polys = surface.substr(surface.find("<Polys>"),
                                           surface.find("</Polys>") + 8 - surface.find("<Polys>"));
  const std::vector<std::string> surfaces{
      replaced(surface, "</Piece>", polys + "</Piece>"),
      replaced(surface, "</Piece>", "<Other/></Piece>"),
      replaced(surface, "</PolyData>", "<Piece/></PolyData>"),
      replaced(surface, "</PolyData>", "</PolyData><PolyData/>"),
      replaced(surface, "</VTKFile>", "</VTKFile><VTKFile/>"),
      replaced(surface, "<Piece ", "<Piece NumberOfPolys=\"0\" "),
      replaced(surface, "Name=\"offsets\"", "Name=\"offsets\" offset=\"0\""),
      replaced(surface, "format=\"ascii\"", "format=\"text\""),
      replaced(surface, "format=\"ascii\"", ""),
      replaced(surface, "<Polys>",  // a line that is not counted
               "<Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1"
               "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">2"
               "</DataArray></Lines><Polys>"),
      replaced(surface, "<Polys>",
               "<Polys><DataArray type=\"Int64\" Name=\"more\" format=\"ascii\">"
               "</DataArray>"),
      replaced(surface, "<Points>",
               "<Points><DataArray type=\"Float64\" Name=\"p\" "
               "NumberOfComponents=\"3\" format=\"ascii\"></DataArray>"),
      replaced(surface, "<PolyData>", "<!DOCTYPE a><PolyData>"),
      replaced(surface, "<Polys>", "<Polys><![CDATA[1]]>"),
      replaced(surface, "</DataArray>", "<!-- --> 1</DataArray>"),
      replaced(surface, "<CellData>", "<CellData>1"),
      // Text outside of the element, and comments in arrays, which VTK refuses.
      surface + "1",
      "<?xml version=\"1.0\"?>1" + surface,
      surface + "<!-- --> 1",
      replaced(surface, "</DataArray>", "<!-- --></DataArray>"),
      // Numbers that not all readers take alike.
      replaced(surface, "NumberOfPoints=\"", "NumberOfPoints=\"0x"),
      replaced(surface, "NumberOfPoints=\"", "NumberOfPoints=\" "),
      replaced(surface, "NumberOfComponents=\"3\"", "NumberOfComponents=\"3x\""),
      replaced(surface, "NumberOfComponents=\"3\"", "NumberOfComponents=\"0x3\""),
      replaced(surface, "</DataArray>", "&#32;</DataArray>"),
      replaced(surface, "<PolyData>", "<PolyData>&#32;"),
      replaced(surface, "<Polys>", "<!-- <AppendedData>_ --><Polys>"),
      replaced(surface, "<Polys>", "<?a <AppendedData>_?><Polys>"),
      // Bytes that others decode otherwise.
      "\xef\xbb\xbf" + surface,
      "\xff\xfe" + surface,
      "<?xml version=\"1.0\" encoding=\"UTF-16\"?>" + surface,
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + surface,
      "<?xml version=\"1.0\" NumberOfTuples=\"3\"?>" + surface,
      "<?xml encoding=\"UTF-8\"?>" + surface,
      replaced(surface, "<Polys>", "<Polys>\xe9"),
      replaced(surface, "<Polys>", "<Polys>\x01"),
      // What others obey, or take for the end of a tag, or leave out.
      replaced(surface, "<PolyData>", "<PolyData TimeValues=\"0 1\">"),
      replaced(surface, "NumberOfComponents=\"3\"", "NumberOfComponents=\"3\" TimeStep=\"1\""),
      replaced(surface, "NumberOfComponents=\"3\"",
               "NumberOfComponents=\"3\" RangeMin=\"> 1 2 3\""),
      replaced(surface, "<CellData>",
               "<CellData><DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"ascii\">"
               "</DataArray>"),
  };
  for (const std::string& forged : surfaces)
    EXPECT_EQ(court.verdict(field, forged, cert), "malformed") << court.report();
  // A comment is none.
  EXPECT_EQ(court.verdict(field, replaced(surface, "<Polys>", "<!-- Polys> --><Polys>"), cert),
            "certified")
      << court.report();
  // Nor does an array of ids, of the type that ids have, say anything else.
  EXPECT_EQ(court.verdict(replaced(field, "<PointData>",
                                   "<PointData><DataArray type=\"Int64\" IdType=\"1\" Name=\"ids\" "
                                   "format=\"ascii\">1 2</DataArray>"),
                          surface, cert),
            "certified")
      << court.report();
  for (const std::string& forged :
       {replaced(field, "</Piece>", "<Points/></Piece>"),
        std::string(field).replace(field.find("ascii\">") + 7, 1, "0x"),
        field + "1", "<?xml version=\"1.0\"?>1" + field,
        replaced(field, "</DataArray>", "<!-- --></DataArray>"),
        replaced(field, ">10 10", ">1e1 10"), replaced(field, ">10 10", ">266 10"),
        replaced(field, "NumberOfComponents=\"6\"", "NumberOfComponents=\"+6\""),
        replaced(field, "Name=\"stress\"", "Name=\"stress\" Name=\"other\""),
        replaced(field, "Name=\"stress\"", "Name=\"stress\" TimeStep=\"1\""),
        replaced(field, "Name=\"stress\"", "Name=\"stress\" IdType=\"1\""),
        replaced(field, "Name=\"stress\"", "Name=\"stress\" RangeMax=\"> 1 2\""),
        replaced(field, "<PointData>",
                 "<PointData><Array type=\"String\" Name=\"stress\" format=\"ascii\">1</Array>"),
        replaced(field, "<PointData>",
                 "<PointData><DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"ascii\">"
                 "</DataArray>")})
    EXPECT_NE(court.verdict(forged, surface, cert), "certified") << court.report();
  // An array of no name is none, though it be the only one.
  Json of_none = e.certificate;
  of_none["input"]["tensor"] = "";
  EXPECT_EQ(court.verdict(field, surface, of_none.dump()), "malformed") << court.report();
}

/// Regions of volume are no faces: that they are left out is counted.
TEST(HostileFiles, SkippedCellsAreCounted) {
  const Folder folder;
  const std::string name = folder / "field.vtu";
  const Exhibit& e = honest_exhibits()[0];
  const std::string field = e.field_text(), end = "\" Name=\"types\" format=\"ascii\">";
  ASSERT_NE(field.find(">10"), std::string::npos);
  for (const char* type : {"55", "56", "12", "42", "71"}) {
    std::ofstream(name) << replaced(field, ">10", std::string(">") + type);
    const auto input = certificate::read_input(certificate::read_file(name), "stress", "vtk");
    EXPECT_EQ(input.other_cells, 1u) << type;
    EXPECT_EQ(input.flat_cells, 0u) << type;
  }
  for (const char* type : {"5", "22", "69", "77"}) {
    std::ofstream(name) << replaced(field, ">10", std::string(">") + type);
    const auto input = certificate::read_input(certificate::read_file(name), "stress", "vtk");
    EXPECT_EQ(input.other_cells, 0u) << type;
    EXPECT_EQ(input.flat_cells, 1u) << type;
  }
}

TEST(Printable, ShowsNothingThatIsNotSeen) {
  for (const char* text : {"a\u00a0b", "a\u00adb", "a\u034fb", "a\u061cb", "a\u180eb", "a\u200bb",
                           "a\u202eb", "a\u3164b", "a\ufe00b", "a\ufeffb", "a\ufff9b", "a\U000e0041b",
                           "a\tb", "a\x7f" "b", "a\xff" "b", "a\xc3" "b"})
    EXPECT_EQ(certificate::printable(text), "a?b");
  for (const char* text : {"stress (MPa)", "\u03c3_xx", "\u5fdc\u529b", "\U0001d70e", ""})
    EXPECT_EQ(certificate::printable(text), text);
}

TEST(Formats, ByteOrderIsNeededForBinaryNumbersOnly) {
  Court court("byte_order");
  const Exhibit& e = honest_exhibits()[0];
  const std::string none = replaced(e.field_text(), "byte_order=\"LittleEndian\"", "");
  EXPECT_EQ(court.verdict(none, e.surface_text(), e.certificate.dump()), "certified");
  const std::string binary = replaced(none, "format=\"ascii\"", "format=\"binary\"");
  EXPECT_EQ(court.verdict(binary, e.surface_text(), e.certificate.dump()), "malformed");
  for (const char* type : {"UInt64", "UInt32", "Int32", "UInt16", "Int16"}) {
    const std::string field =
        replaced(e.field_text(), "type=\"Int64\"", std::string("type=\"") + type + '"');
    EXPECT_EQ(court.verdict(field, e.surface_text(), e.certificate.dump()), "certified") << type;
  }
}

TEST(Formats, NamesOfComponentsAreObeyedOrRefused) {
  Court court("names");
  const Exhibit& e = honest_exhibits()[0];
  const auto named = [&](const std::vector<std::string>& names) {
    std::string attributes = "Name=\"stress\"";
    for (std::size_t i = 0; i < names.size(); ++i)
      attributes += " ComponentName" + std::to_string(i) + "=\"" + names[i] + '"';
    return court.verdict(replaced(e.field_text(), "Name=\"stress\"", attributes), e.surface_text(),
                         e.certificate.dump());
  };
  for (const auto& names : std::vector<std::vector<std::string>>{
           {"XX", "YY", "ZZ", "XY", "YZ", "XZ"},
           {"S11", "S22", "S33", "S12", "S23", "S13"},
           {"stress_xx (MPa)", "stress_yy (MPa)", "stress_zz (MPa)", "stress_yx (MPa)",
            "stress_zy (MPa)", "stress_zx (MPa)"},
           {"x", "y", "z", "xy", "yz", "xz"}})
    EXPECT_EQ(named(names), "certified") << court.report();
  for (const auto& names :
       std::vector<std::vector<std::string>>{{"S11", "S22", "S33", "S12", "S13", "S23"},
                                             {"SXX", "SYY", "SZZ", "SXY", "SXZ", "SYZ"},
                                             {"00", "01", "02", "11", "12", "22"}})
    EXPECT_EQ(named(names), "malformed") << names[4];
}

// Nothing could derive what components are called, in which unit numbers are, or which array others
// shall take for normals.
TEST(HostileFiles, SurfacesSayNothingBesideNumbers) {
  Court court("beside_numbers");
  const Exhibit& e = honest_exhibits()[0];
  const std::string field = e.field_text(), cert = e.certificate.dump();
  const auto verdict_of = [&](const std::string& attributes, const std::string& key) {
    std::string surface = replaced(e.surface_text(), "<CellData>", "<CellData" + attributes + ">");
    if (!key.empty())
      surface = replaced(
          surface, "</DataArray>",
          "<InformationKey name=\"" + key + "\" location=\"a\">MPa</InformationKey></DataArray>");
    return court.verdict(field, surface, cert);
  };
  for (const char* harmless : {"", " Scalars=\"tet\"", " Normals=\"normal\""})
    EXPECT_EQ(verdict_of(harmless, "L2_NORM_RANGE"), "certified") << harmless << court.report();
  for (const char* lie :
       {" Normals=\"medium_eigenvector\"", " GlobalIds=\"tet\"", " TCoords=\"mode\""})
    EXPECT_EQ(verdict_of(lie, ""), "malformed") << lie;
  EXPECT_EQ(verdict_of("", "UNITS_LABEL"), "malformed");
  EXPECT_EQ(
      court.verdict(
          field, replaced(e.surface_text(), "Name=\"tet\"", "Name=\"tet\" ComponentName0=\"-1\""),
          cert),
      "malformed");
}

TEST(HostileFiles, IntegersArePlainDoubles) {
  EXPECT_EQ(certificate::number_of_word<std::int64_t>("9007199254740992"), 0x1p53);
  EXPECT_EQ(certificate::number_of_word<std::int64_t>("-9007199254740992"), -0x1p53);
  EXPECT_EQ(certificate::number_of_word<std::uint64_t>("9007199254740993"), HUGE_VAL);
  EXPECT_EQ(certificate::number_of_word<std::int64_t>("9007199254740993"), HUGE_VAL);
  EXPECT_EQ(certificate::number_of_word<std::int64_t>("-9007199254740993"), HUGE_VAL);
}

TEST(Formats, SpellingsOfAllOrders) {
  using certificate::spelling_of;
  EXPECT_EQ(spelling_of({"a", "b", "c", "d", "e", "f"}, {0, 1, 2, 3, 4, 5}), Spelling::silent);
  EXPECT_EQ(spelling_of({"", "", "", "", "", ""}, {0, 1, 2, 3, 4, 5}), Spelling::silent);
  EXPECT_EQ(spelling_of({"xx", "xx", "zz", "xy", "yz", "xz"}, {0, 1, 2, 3, 4, 5}),
            Spelling::differs);
  EXPECT_EQ(spelling_of({"11", "12", "13", "21", "22", "23", "31", "32", "33"}, {0, 4, 8, 1, 5, 2}),
            Spelling::agrees);
  EXPECT_EQ(spelling_of({"11", "21", "31", "12", "22", "32", "13", "23", "33"}, {0, 4, 8, 1, 5, 2}),
            Spelling::agrees);
  EXPECT_EQ(spelling_of({"xx", "xy", "yy", "xz", "yz", "zz"}, {0, 2, 5, 1, 4, 3}),
            Spelling::agrees);
  // Names of which not all are understood, in Voigt's order.
  using Names = std::vector<std::string>;
  for (const Names& names :
       {Names{"sigma_x", "sigma_y", "sigma_z", "tau_yz", "tau_xz", "tau_xy"},
        Names{"exx", "eyy", "ezz", "gyz", "gxz", "gxy"}, Names{"E11", "E22", "E33", "G23", "G13", "G12"},
        Names{"e00", "e11", "e22", "g12", "g02", "g01"}, Names{"", "", "", "YZ", "XZ", "XY"},
        Names{"a", "b", "c", "d_zy", "e", "f"}}) {
    EXPECT_EQ(spelling_of(names, {0, 1, 2, 3, 4, 5}), Spelling::differs) << names[3];
    EXPECT_EQ(spelling_of(names, {0, 1, 2, 5, 3, 4}), Spelling::silent) << names[3];
  }
  EXPECT_EQ(spelling_of({"max", "mid", "min", "u1", "u2", "u123"}, {0, 1, 2, 3, 4, 5}),
            Spelling::silent);
}

}  // namespace
}  // namespace tensortopo::test
