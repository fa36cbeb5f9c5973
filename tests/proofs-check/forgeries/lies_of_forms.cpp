// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "lies.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

template <std::size_t N>
const char* any_of(const std::array<const char*, N>& texts, Pick& pick) {
  return texts[pick.below(N)];
}

/// A mark in a document, which the text of it gets a number in place of.
constexpr const char* kMark = "\"@\"";

/// Any integer in a list, however deep.
Json* any_number(Json& list, Pick& pick) {
  if (list.is_number_integer()) return &list;
  if (!list.is_structured() || list.empty()) return nullptr;
  auto at = list.begin();
  std::advance(at, pick.below(list.size()));
  return any_number(*at, pick);
}

/// A number of any list as a text that wraps around to it, or is no integer.
bool write_number_otherwise(Exhibit& e, Pick& pick) {
  constexpr std::array kLists{"vertices", "triangles", "edges",    "faces",     "tets",
                              "cones",    "undecided", "on_level", "components"};
  Json* const number = any_number(any_level(e, pick)[any_of(kLists, pick)], pick);
  if (number == nullptr) return false;
  const auto n = number->get<std::int64_t>();
  const std::string text = std::to_string(n);
  const auto wrapped = [&](__uint128_t by) {
    __uint128_t sum = by + static_cast<__uint128_t>(n);
    std::string digits;
    for (; sum > 0; sum /= 10) digits.insert(digits.begin(), static_cast<char>('0' + sum % 10));
    return digits;
  };
  constexpr __uint128_t kOne = 1;
  *number = "@";
  const std::array<std::string, 9> forms{
      wrapped(kOne << 32), wrapped(kOne << 64), wrapped(kOne << 63), text + ".0", text + "e0",
      '"' + text + '"',    "[" + text + "]",    "-" + text + ".5",   "null"};
  e.in_certificate.push_back({kMark, forms[pick.below(forms.size())], true});
  return true;
}

/// The same value, or one that is none, as no certificate spells it.
bool spell_level_otherwise(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  Json& text = level.contains("mode") ? level["mode"] : level["value"];
  const auto value = text.get<std::string>();
  const std::size_t slash = value.find('/');
  const auto twice = [](const std::string& n) { return std::to_string(2 * std::stol(n)); };
  const std::string unreduced = slash == std::string::npos ? value + "/1"
                                                           : twice(value.substr(0, slash)) + '/' +
                                                                 twice(value.substr(slash + 1));
  const std::array<std::string, 9> forms{'+' + value, ' ' + value,  value + ' ',
                                         '0' + value, unreduced,    value + ".0",
                                         "-0",        value + "/2", "1/0"};
  return text = forms[pick.below(forms.size())], true;
}

/// Values of which the square is the claimed one's, or that no level has.
bool leave_range_of_value(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level.contains("mode")) {
    level["mode"] = any_of(std::array{"1", "-1", "3/2", "-4"}, pick);
  } else if (level["invariant"] == "anisotropy" && pick.coin()) {
    level["value"] = any_of(std::array{"1", "5/4"}, pick);
  } else {
    level["value"] = '-' + level["value"].get<std::string>();
  }
  return true;
}

/// No lie of tensors that are their deviators.
bool exchange_invariants(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level.contains("mode") || level["edges"].empty()) return false;
  if (std::all_of(e.mesh.tensors.begin(), e.mesh.tensors.end(),
                  [](const auto& t) { return trace(t) == 0; }))
    return false;
  const char* const other = level["invariant"] == "magnitude" ? "deviator-magnitude" : "magnitude";
  return level["invariant"] = other, true;
}

bool spell_interval_otherwise(Exhibit& e, Pick& pick) {
  Json& edges = any_level(e, pick)["edges"];
  if (edges.empty()) return false;
  Json& crossing = edges[pick.below(edges.size())][2];
  if (crossing[0].is_string()) return false;
  const auto i = crossing[0].get<std::int64_t>();
  switch (pick.below(5)) {
    case 0:
      return crossing[0] = std::to_string(i), true;  // a text is for larger ones
    case 1:
      return crossing[1] = 2049, crossing[0] = std::to_string(i), true;
    case 2:
      return crossing[0] = -i - 1, true;
    case 3:
      return crossing[0] = std::int64_t{1} << crossing[1].get<int>(), true;
    default:
      return crossing[1] = -crossing[1].get<int>() - 1, true;
  }
}

bool spell_length_otherwise(Exhibit& e, Pick& pick) {
  Json& distance = any_level(e, pick)["distance"];
  if (distance.is_null()) return false;
  // Of the last three the nearest doubles are 2^900, 2^900 and 0.
  constexpr std::array kForms{"inf",
                              "nan",
                              "-0x1p+900",
                              "0x1p+2000",
                              "1",
                              "1e300",
                              "0x",
                              " 0x1p+900",
                              "0x1p+900 ",
                              "0x1p+900,0x1p-900",
                              "infinity",
                              "0x1.ffffffffffffffp+899",
                              "0x1.00000000000001p+900",
                              "0x1p-1076"};
  return distance[pick.coin() ? "bound" : "coarse_bound"] = any_of(kForms, pick), true;
}

bool spell_radius_otherwise(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level["components"].empty() || !level.contains("mode")) return false;
  const Json first = level["components"][0]["first_vertex"];
  // Of the last two the nearest double is 0.
  constexpr std::array kForms{"-0x1p-30", "nan", "-inf", "", "0", "0x1.ep-1076", "0x1p-1075"};
  level["stability"] = {
      {"radius", any_of(kForms, pick)}, {"of", "tensor"}, {"components", Json::array({first})}};
  if (pick.coin()) {  // one named twice
    level["stability"]["radius"] = "0x0p+0";
    level["stability"]["components"].push_back(first);
  }
  return true;
}

bool reach_very_far(Exhibit& e, Pick& pick) {
  Json& distance = any_level(e, pick)["distance"];
  if (distance.is_null() || distance["reach"].empty()) return false;
  distance["bound"] = "0x1p+1000";
  constexpr std::array<std::int64_t, 4> kReaches{INT64_MAX, INT64_MIN, INT64_MAX - 7, 4000};
  const std::int64_t reach = kReaches[pick.below(4)];
  for (Json& n : distance["reach"]) n = reach;
  // Nothing is asked of vertices that are in coarse tetrahedra only.
  return distance["coarse"] = Json::array(), true;
}

bool claim_falsely_embedded(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!level.contains("embedded")) return false;
  constexpr std::array kForms{"false", "null", "1", "\"true\"", "[true]"};
  level["embedded"] = "@";
  e.in_certificate.push_back({kMark, any_of(kForms, pick)});
  return true;
}

bool order_otherwise(Exhibit& e, Pick& pick) {
  constexpr std::array kLists{"edges", "faces", "tets", "cones", "components"};
  Json& list = any_level(e, pick)[any_of(kLists, pick)];
  if (list.size() < 2) return false;
  const std::size_t i = pick.below(list.size() - 1);
  return std::swap(list[i], list[i + 1]), true;
}

bool add_key(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  switch (pick.below(4)) {
    case 0:
      return e.certificate["note"] = "certified", true;
    case 1:
      return level["proved"] = true, true;
    case 2:
      return e.certificate["input"]["Tensor"] = "strain", true;
    default:  // a key twice: which one counts?
      e.in_certificate.push_back({"\"on_level\":", "\"on_level\":7,\"on_level\":", true});
      return true;
  }
}

bool order_arrays_otherwise(Exhibit& e, Pick& pick) {
  Json& surface = e.certificate["surface"];
  if (!surface.contains("arrays") || surface["arrays"].size() < 2) return false;
  Json& arrays = surface["arrays"];
  const std::size_t i = pick.below(arrays.size() - 1);
  if (pick.coin()) return std::swap(arrays[i], arrays[i + 1]), true;
  arrays[i][0] = arrays[i][0] == "points" ? "triangles" : "points";
  return true;
}

/// An edit of a file's text; false if what it is about is not there.
LieRow edit(const char* name, std::vector<Exhibit::Edit> Exhibit::*where,
            const std::vector<Exhibit::Edit>& edits) {
  return {name, [=](Exhibit& e, Pick& pick) {
            const Exhibit::Edit& any = edits[pick.below(edits.size())];
            const std::string text =
                where == &Exhibit::in_field ? e.field_text() : e.surface_text();
            if (text.find(any.from) == std::string::npos) return false;
            return (e.*where).push_back(any), true;
          }};
}

constexpr const char* kTet = "Name=\"tet\" NumberOfComponents=\"1\" format=\"ascii\">";
constexpr const char* kConnectivity =
    "Name=\"connectivity\" NumberOfComponents=\"1\" format=\"ascii\">";
constexpr const char* kOffsets = "Name=\"offsets\" NumberOfComponents=\"1\" format=\"ascii\">";

}  // namespace

std::vector<LieRow> lies_of_forms() {
  const auto surface = &Exhibit::in_surface;
  const auto field = &Exhibit::in_field;
  const std::string tet = kTet, connectivity = kConnectivity, offsets = kOffsets;
  return {
      {"numbers: wrapped, or no integers", write_number_otherwise},
      {"mode, value: spelled otherwise", spell_level_otherwise},
      {"mode, value: out of range", leave_range_of_value},
      {"invariant: another", exchange_invariants},
      {"edges: interval spelled otherwise", spell_interval_otherwise},
      {"distance: lengths spelled otherwise", spell_length_otherwise},
      {"distance: reach very far", reach_very_far},
      {"stability: radius spelled otherwise", spell_radius_otherwise},
      {"embedded: not true", claim_falsely_embedded},
      {"lists: order", order_otherwise},
      {"keys: further, twice", add_key},
      {"surface.arrays: order, kind", order_arrays_otherwise},
      edit("surface: tet wrapped, or no integer", surface,
           {{tet, tet + "4294967296 ", true},
            {tet, tet + "0.5 ", true},
            {tet, tet + "-1 ", true},
            {tet, tet + "nan ", true}}),
      edit("surface: tet twice", surface,
           {{"<CellData>",
             "<CellData><DataArray type=\"Int64\" Name=\"tet\" "
             "NumberOfComponents=\"1\" format=\"ascii\">0 </DataArray>",
             true},
            {"</CellData>", "</CellData><CellData></CellData>", true}}),
      edit("surface: corners wrapped, or no integers", surface,
           {{connectivity, connectivity + "4294967296 ", true},
            {connectivity, connectivity + "18446744073709551616 ", true},
            {connectivity, connectivity + "1.5 ", true},
            {connectivity, connectivity + "-1 ", true}}),
      edit("surface: polygons that are no triangles", surface,
           {{offsets, offsets + "0 ", true},
            {offsets + "3 6 ", offsets + "2 6 ", true},
            {offsets + "3 6 ", offsets + "6 3 ", true},
            {offsets + "3 ", offsets + "4 ", true},
            {offsets + "3 ", offsets, true}}),
      edit("surface: counts of the piece", surface,
           {{"NumberOfVerts=\"0\"", "NumberOfVerts=\"1\"", true},
            {"NumberOfPoints=\"", "NumberOfPoints=\"1", true},
            {"NumberOfPolys=\"", "NumberOfPolys=\"1", true},
            {"<Piece ", "<Piece NumberOfPoints=\"0\"/><Piece ", true}}),
      edit("surface: a section more", surface,
           {{"<Polys>",
             "<Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1"
             "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">2"
             "</DataArray></Lines><Polys>",
             true},
            {"<Polys>", "<Polys></Polys><Polys>", true},
            {"<Points>", "<Points></Points><Points>", true},
            {"</Polys>",
             "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2"
             "</DataArray></Polys>",
             true}}),
      edit("surface: width of the points", surface,
           {{"Name=\"Points\" NumberOfComponents=\"3\"", "Name=\"Points\" NumberOfComponents=\"2\"",
             true},
            {"Name=\"Points\" NumberOfComponents=\"3\"", "Name=\"Points\" NumberOfComponents=\"1\"",
             true},
            {"type=\"Float64\" Name=\"Points\"", "type=\"Int8\" Name=\"Points\"", true}}),
      edit("field: the array twice", field,
           {{"<PointData>",
             "<PointData><DataArray type=\"Float64\" Name=\"stress\" "
             "NumberOfComponents=\"6\" format=\"ascii\">0 </DataArray>",
             true},
            {"<PointData>", "<PointData></PointData><PointData>", true}}),
      edit("field: counts, cells", field,
           {{"NumberOfPoints=\"", "NumberOfPoints=\"1", true},
            {"NumberOfCells=\"", "NumberOfCells=\"1", true},
            {offsets + "4 ", offsets + "3 ", true},
            {offsets + "4 ", offsets + "5 ", true},
            {"Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">10 ",
             "Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">5 ", true},
            {"Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">10 ",
             "Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">266 ", true}}),
  };
}

}  // namespace tensortopo::test
