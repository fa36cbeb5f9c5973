// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;
constexpr Tensor kTensor{11, 22, 33, 12, 23, 13};

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// The value of kTensor at a name such as XY, ZX.
double value_at(std::string name) {
  std::sort(name.begin(), name.end());
  const Tensor& t = kTensor;
  return name == "XX"   ? t.xx
         : name == "YY" ? t.yy
         : name == "ZZ" ? t.zz
         : name == "XY" ? t.xy
         : name == "YZ" ? t.yz
                        : t.xz;
}

/// A field whose components are kTensor's in this order, under these names.
std::filesystem::path field(const std::string& order, const std::vector<std::string>& names,
                            bool legacy = false) {
  std::string numbers, attributes, metadata = "METADATA\nCOMPONENT_NAMES\n";
  const auto places = words(order);
  for (int vertex = 0; vertex < 4; ++vertex)
    for (const auto& place : places) numbers += std::to_string(value_at(place)) + " ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    attributes += "ComponentName" + std::to_string(i) + "=\"" + names[i] + "\" ";
    metadata += names[i] + "\n";
  }
  const auto width = static_cast<int>(places.size());
  if (legacy)
    return put("named.vtk",
               text_legacy("POINT_DATA 4\nFIELD data 1\nstress " + std::to_string(width) +
                           " 4 double\n" + numbers + "\n" + metadata + "\n"));
  TextVtu text;
  text.point_data = TextVtu::array("stress", width, numbers);
  text.point_data.insert(text.point_data.find("format="), attributes);
  return put("named.vtu", text.str());
}

/// The names of an order's components in one way of writing them.
using Spelling = std::string (*)(const std::string&);
std::string digits(std::string name, char first) {
  for (char& c : name) c = static_cast<char>(c - 'X' + first);
  return name;
}
std::string lower(std::string name) {
  for (char& c : name) c = static_cast<char>(c - 'A' + 'a');
  return name;
}
const std::array<Spelling, 12> kSpellings{
    [](const std::string& n) { return n; },
    [](const std::string& n) { return "S" + n; },
    [](const std::string& n) { return "S" + digits(n, '1'); },
    [](const std::string& n) { return "S" + digits(n, '0'); },
    [](const std::string& n) { return "stress_" + lower(n) + " (MPa)"; },
    [](const std::string& n) { return "s." + lower(n); },
    [](const std::string& n) { return digits(n, '1'); },
    [](const std::string& n) { return "T_" + digits(n, '1').insert(1, "_"); },
    [](const std::string& n) { return "S-" + digits(n, '1'); },
    // The other triangle.
    [](const std::string& n) { return "S" + std::string(n.rbegin(), n.rend()); },
    // A diagonal entry by its axis alone.
    [](const std::string& n) { return "sigma_" + (n[0] == n[1] ? lower(n).substr(1) : lower(n)); },
    [](const std::string& n) { return lower(n).insert(1, ","); },
};

TEST(ComponentNames, AreObeyedInEveryOrderAndSpelling) {
  std::size_t compared = 0;
  for (const auto order : {ComponentOrder::vtk, ComponentOrder::voigt, ComponentOrder::abaqus,
                           ComponentOrder::nifti, ComponentOrder::fsl}) {
    for (const Spelling& spelling : kSpellings) {
      const std::string listing(listing_of(order));
      std::vector<std::string> names;
      for (const auto& word : words(listing)) names.push_back(spelling(word));
      for (const bool legacy : {false, true}) {
        if (legacy && names[0].find_first_of(" ,") != std::string::npos) continue;
        const ReadResult read = read_mesh(field(listing, names, legacy));
        EXPECT_EQ(read.mesh.tensors[2], kTensor) << listing << " as " << names[3];
        EXPECT_EQ(read.report.components.order, order);
        EXPECT_EQ(read.report.components.source, ComponentSource::named);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 110u);
}

TEST(ComponentNames, OfNineAreRowByRowOrColumnByColumn) {
  for (const char* order : {"XX XY XZ YX YY YZ ZX ZY ZZ", "XX YX ZX XY YY ZY XZ YZ ZZ"})
    EXPECT_EQ(read_mesh(field(order, words(order))).mesh.tensors[0], kTensor);
  expect_error(field("XX YY ZZ XY YZ XZ YX ZY ZX", words("XX YY ZZ XY YZ XZ YX ZY ZX")), invalid,
               {"`stress`", "XX YY ZZ XY YZ XZ YX ZY ZX", "not supported"});
  expect_error(field("XX XY XZ YX YY YZ ZX ZY ZZ", words("a b c d e f g h i")), invalid,
               {"`stress`", "says no order", "XX XY XZ YX"});
}

TEST(ComponentNames, ThatAreNotUnderstoodAreRefused) {
  const std::string order = "XX YY ZZ XY XZ YZ";
  for (const char* names :
       {"a b c d e f", "S11 S22 S33 E12 E13 E23", "x y z a b c",
        "XX YY ZZ XY XZ YW", "1 2 3 4 5 6", "xx yy zz 12 13 23", "XX YY ZZ XY XZ YZZ",
        "e11 e22 e33 g12 g13 g23", "max mid min max mid min"}) {
    const auto file = field(order, words(names));
    expect_error(file, invalid, {"`stress`", "says no order", "--components"});
    ReadOptions options;  // the caller knows
    options.components = ComponentOrder::abaqus;
    const ReadResult read = read_mesh(file, options);
    EXPECT_EQ(read.mesh.tensors[0], kTensor);
    EXPECT_EQ(read.report.components.source, ComponentSource::given);
  }
  // Not all are understood, but some contradict what the caller says.
  for (const char* names :
       {"sigma_x sigma_y sigma_z tau_yz tau_xz tau_xy", "exx eyy ezz gyz gxz gxy",
        "E11 E22 E33 G23 G13 G12", "e00 e11 e22 g12 g02 g01", "a b c d_zy e f"}) {
    ReadOptions options;
    options.components = ComponentOrder::voigt;
    EXPECT_EQ(read_mesh(field("XX YY ZZ YZ XZ XY", words(names)), options).mesh.tensors[0], kTensor);
    options.components = ComponentOrder::vtk;
    expect_error(field("XX YY ZZ YZ XZ XY", words(names)), IoError::Kind::inapplicable,
                 {"`stress`", "--components vtk", "contradicts"}, options);
  }
  // Two alike: something is wrong, whatever the caller knows.
  for (const char* names : {"S11 S22 S33 S12 S13 S12", "XX YY ZZ XY XZ ZX"}) {
    ReadOptions options;
    expect_error(field(order, words(names)), invalid, {"`stress`", "alike"});
    options.components = ComponentOrder::abaqus;
    expect_error(field(order, words(names)), invalid, {"`stress`", "alike"}, options);
  }
  // Some of them missing.
  expect_error(field(order, {"XX", "YY", "ZZ", "XY", "", "YZ"}), invalid, {"says no order"});
  expect_error(field(order, {"XX", "", "", "", "", ""}), invalid, {"says no order"});
  // Understood, but in an order that nobody uses.
  expect_error(field(order, words("YY XX ZZ XY XZ YZ")), invalid, {"not supported"});
  ReadOptions options;
  options.components = ComponentOrder::abaqus;
  expect_error(field(order, words("YY XX ZZ XY XZ YZ")), invalid, {"not supported"}, options);
}

TEST(ComponentNames, AreNotContradicted) {
  std::size_t refused = 0;
  for (const auto spelled : {ComponentOrder::vtk, ComponentOrder::voigt, ComponentOrder::abaqus,
                             ComponentOrder::nifti, ComponentOrder::fsl}) {
    const std::string listing(listing_of(spelled));
    const auto file = field(listing, words(listing));
    for (const auto given : {ComponentOrder::vtk, ComponentOrder::voigt, ComponentOrder::abaqus,
                             ComponentOrder::nifti, ComponentOrder::fsl}) {
      ReadOptions options;
      options.components = given;
      if (given == spelled) {
        EXPECT_EQ(read_mesh(file, options).mesh.tensors[0], kTensor);
        continue;
      }
      expect_error(file, IoError::Kind::inapplicable,
                   {"--components " + std::string(name_of(given)), "contradicts", "`stress`",
                    std::string(name_of(spelled))},
                   options);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 20u);
}

TEST(ComponentNames, WhatIsTakenIsNoted) {
  const auto note_of = [](const std::filesystem::path& file) {
    const auto notes = read_mesh(file).report.all_notes();
    return notes.empty() ? std::string() : notes.front();
  };
  EXPECT_EQ(note_of(field("XX YY ZZ XY XZ YZ", words("S11 S22 S33 S12 S13 S23"))),
            "components of `stress`: XX YY ZZ XY XZ YZ (abaqus, named in the file)");
  EXPECT_EQ(note_of(field("XX YY ZZ XY YZ XZ", {})),
            "components of `stress`: XX YY ZZ XY YZ XZ (vtk, assumed)");
  EXPECT_EQ(note_of(field("XX YY ZZ XY YZ XZ", words("XX YY ZZ XY YZ XZ"))), "");
}

TEST(ComponentNames, OrdersHaveNames) {
  for (const std::string_view name : component_order_names()) {
    const auto order = component_order(name);
    ASSERT_TRUE(order);
    EXPECT_EQ(component_order(name_of(*order)), order);
  }
  EXPECT_EQ(component_order("mrtrix"), ComponentOrder::abaqus);
  EXPECT_EQ(component_order("dipy"), ComponentOrder::nifti);
  EXPECT_FALSE(component_order("full"));
  EXPECT_FALSE(component_order(""));
}

}  // namespace
}  // namespace tensortopo::test
