// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <nlohmann/json.hpp>

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"
#include "files/utf8.hpp"

namespace certificate {
namespace {

std::string status_of(std::size_t refuted, std::size_t undecided) {
  return refuted > 0 ? "refuted" : undecided > 0 ? "undecided" : "certified";
}

/// "1 component", "2 components"
std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
}

std::string counted_tets(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " tetrahedron" : " tetrahedra");
}

std::string text_of(const Component& c, bool is_curve) {
  if (is_curve)
    return std::string(c.closed ? "closed" : "not closed") + ", " + counted(c.cells, "line");
  return "Euler characteristic " + std::to_string(c.euler_characteristic) + ", " +
         counted(c.boundary_loops, "boundary loop") + ", " + counted(c.cells, "triangle");
}

constexpr std::size_t kShown = 10;

/// "2 tetrahedra (budget_exhausted: 4 7)"
std::string listed(const std::string& reason, const std::vector<std::uint64_t>& tets) {
  std::string text = counted_tets(tets.size()) + " (" + reason + ": ";
  for (std::size_t i = 0; i < std::min(tets.size(), kShown); ++i)
    text += (i == 0 ? "" : " ") + std::to_string(tets[i]);
  return text + (tets.size() > kShown ? " ...)" : ")");
}

/// A number of few digits that is no smaller, or with `down` no larger, than x, which is none below 0.
std::string bound_text(double x, int digits, bool down = false) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.*g", digits, x);
  const double shown = std::strtod(text, nullptr);
  // A unit of the last digit is at most so large a part.
  const double unit = std::pow(10, 1 - digits);
  if (down ? shown > x : shown < x)
    std::snprintf(text, sizeof(text), "%.*g", digits, x * (down ? 1 - unit : 1 + unit));
  return text;
}

/// Whether a reader sees a character, and what follows it where it is: no controls, no spaces but the
/// usual one, nothing that Unicode lets displays ignore (DerivedCoreProperties,
/// Default_Ignorable_Code_Point) or that turns the direction.
bool is_seen(std::string_view character) {
  static constexpr std::array<std::array<std::uint32_t, 2>, 29> kUnseen{
      {{0, 0x1f},         {0x7f, 0xa0},       {0xad, 0xad},       {0x34f, 0x34f},
       {0x61c, 0x61c},    {0x115f, 0x1160},   {0x1680, 0x1680},   {0x17b4, 0x17b5},
       {0x180b, 0x180f},  {0x2000, 0x200f},   {0x2028, 0x202f},   {0x205f, 0x206f},
       {0x2800, 0x2800},  {0x3000, 0x3000},   {0x3164, 0x3164},   {0xd800, 0xf8ff},
       {0xfe00, 0xfe0f},  {0xfeff, 0xfeff},   {0xffa0, 0xffa0},   {0xfff0, 0xffff},
       {0x13430, 0x1345f}, {0x1bca0, 0x1bca3}, {0x1d159, 0x1d159}, {0x1d173, 0x1d17a},
       {0x1fffe, 0x1ffff}, {0x2fffe, 0x2ffff}, {0xe0000, 0xe0fff}, {0xf0000, 0xfffff},
       {0x100000, 0x10ffff}}};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  std::uint32_t code = byte(0);
  if (character.size() > 1) code &= 0x7fu >> character.size();
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (byte(i) & 0x3fu);
  return std::none_of(kUnseen.begin(), kUnseen.end(),
                      [&](const auto& range) { return range[0] <= code && code <= range[1]; });
}

/// Which components are in all fields within a radius.
std::string stability_text(const LevelReport& level, bool of_curves) {
  return "  " + std::to_string(level.stable_components.size()) + " of the components " +
         "are in every field whose deviators differ by at most " + bound_text(level.radius, 6, true) +
         (level.radius_of_deviator ? " of themselves" : "") + " at the vertices" +
         (level.radius_array.empty() ? ""
                                     : ", at each by at most what '" + printable(level.radius_array) + "' says") +
         "\n" +
         (level.stable_crossings == 0
              ? ""
              : "  " + std::to_string(level.stable_crossings) +
                    (of_curves ? " faces have the same points" : " edges have the same crossings") +
                    " in all these fields\n");
}

/// How far triangles and level are from each other.
std::string distance_text(const LevelReport& level) {
  if (level.bound.empty()) return "  no distance is claimed\n";
  if (!level.near) return "  the distances that are claimed are not shown\n";
  const auto bound = [](const std::string& text) {
    return "distance at most " + bound_text(std::strtod(text.c_str(), nullptr), 6);
  };
  std::string text;
  if (level.bounded > 0) text = bound(level.bound) + " of " + counted(level.bounded, "triangle");
  if (level.coarse > 0)
    text += (text.empty() ? "" : ", ") + bound(level.coarse_bound) + " in " +
            std::to_string(level.coarse) +
            (level.coarse == 1 ? " coarse tetrahedron" : " coarse tetrahedra");
  return "  " + (text.empty() ? "there is no triangle that a distance is claimed of" : text) + '\n';
}

std::string text_of(const LevelReport& level, bool of_curves) {
  std::string text = level.name + ": " + status_of(level.refuted, level.undecided) + ", " +
                     counted(level.components.size(), "component") +
                     (level.refuted + level.undecided > 0 ? " in the file" : "");
  for (std::size_t i = 0; i < std::min(level.components.size(), kShown); ++i)
    text += (i == 0 ? ": " : "; ") + text_of(level.components[i], of_curves);
  if (level.components.size() > kShown)
    text += "; and " + std::to_string(level.components.size() - kShown) + " more";
  text += "\n  tetrahedra without claims: ";
  if (level.left_out.empty()) text += "none";
  for (const auto& [reason, tets] : level.left_out)
    text += (text.ends_with(' ') ? "" : ", ") + listed(reason, tets);
  text += '\n';
  if (level.claims_stability) text += stability_text(level, of_curves);
  const std::string residual =
      level.residual
          ? "  residual at most " + bound_text(*level.residual, 3) + ", at the vertices as written\n"
          : "";
  if (of_curves)
    return text + residual +
           "  of lines the ends and tetrahedra are claimed, but no distance, and not that they do not cross\n";
  text += level.embedded ? "  embedded: the triangles meet in common vertices and edges only\n"
          : level.claims_embedded
              ? "  that the triangles are embedded is claimed, but not shown\n"
              : "  that the triangles are embedded is not claimed\n";
  text += residual;
  for (const auto& [name, shown] : level.vectors)
    text += "  " + name + " shown at " + std::to_string(shown) + " of " +
            std::to_string(level.vertices) + (level.vertices == 1 ? " vertex" : " vertices") +
            '\n';
  if (level.claims_isotopy) {
    text += "  isotopic to the level in " + counted_tets(level.isotopic) +
            ", with vertices moved by at most " + bound_text(level.moved, 3);
    for (const auto& [reason, tets] : level.not_isotopic)
      text += "; not shown in " + listed(reason, tets);
    text += '\n';
  }
  return text + distance_text(level);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    if (length > 0 && is_seen(text.substr(0, length)))
      result += text.substr(0, length);
    else
      result += '?';
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::size_t LevelReport::left_out_count() const {
  std::size_t count = 0;
  for (const auto& [reason, tets] : left_out) count += tets.size();
  return count;
}

std::string Report::status() const { return status_of(refuted, undecided); }

std::vector<std::string> Report::unmet(const Demands& demands) const {
  std::vector<std::string> result;
  if (!demands.tensor.empty() && demands.tensor != subject.tensor)
    result.push_back("tensor '" + demands.tensor + "': the certificate is about '" +
                     subject.tensor + "'");
  for (const std::string& mode : demands.modes) {
    const auto number = number_of(mode);
    if (!number) throw std::invalid_argument("a mode that is no number: " + mode);
    const std::string name = "mode " + number->get_str();
    const bool is_there = std::any_of(levels.begin(), levels.end(), [&](const LevelReport& level) {
      return level.name == name && level.refuted + level.undecided == 0 && level.certified > 0;
    });
    if (!is_there) result.push_back(name + ": no level that is certified");
  }
  if (demands.complete) {
    if (levels.empty()) result.push_back("complete: no level");
    if (subject.tetrahedra > 0 && subject.isotropic == subject.tetrahedra)
      result.push_back("complete: all tensors are isotropic, so that no mode is defined");
    if (subject.other_cells > 0)
      result.push_back("complete: " + counted(subject.other_cells, "cell") +
                       " of the input that are no tetrahedra");
    for (const LevelReport& level : levels)
      if (level.left_out_count() > 0)
        result.push_back("complete: " + level.name + " leaves out " +
                         counted_tets(level.left_out_count()));
  }
  return result;
}

std::string to_text(const Report& report, const std::vector<std::string>& unmet) {
  const auto counts = [](const auto& of) {
    return std::to_string(of.certified) + " certified, " + std::to_string(of.refuted) +
           " refuted, " + std::to_string(of.undecided) + " undecided\n";
  };
  const Subject& s = report.subject;
  std::string text;
  for (const std::string& demand : unmet) text += "not as demanded: " + demand + '\n';
  text += report.status() + ": " + std::to_string(report.claims()) + " claims, " + counts(report);
  text += "input: " + printable(s.input) + ", tensor '" + printable(s.tensor) + "', components " +
          s.listing + " (" + s.order +
          (s.names_say_order || s.names.empty()
               ? ""
               : ", though the file's names do not say so: " + printable(s.names)) +
          "), " + counted(s.points, "point") + ", " + counted_tets(s.tetrahedra) +
          (s.isotropic > 0 ? " (in " + std::to_string(s.isotropic) +
                                 " all tensors are isotropic: no mode is defined)"
                           : "") +
          (s.symmetrized > 0 ? ", " + counted(s.symmetrized, "tensor") + " symmetrized" : "") +
          (s.other_cells > 0 ? ", " + counted(s.other_cells, "other cell") + " skipped" : "") +
          (s.flat_cells > 0
               ? ", " + counted(s.flat_cells, "cell") + " of two dimensions or fewer skipped"
               : "") +
          (s.doubled_points > 0
               ? ", torn: " + counted(s.doubled_points, "point") + " at the place of another"
               : "") +
          "\noutput: " + printable(s.output) + ", " + std::to_string(s.vertices) + " vertices, " +
          counted(s.cells, s.of_curves ? "line" : "triangle") + '\n';
  for (const LevelReport& level : report.levels) text += text_of(level, s.of_curves);
  if (!s.bound_only.empty()) {
    text += "arrays that are as written, but not derived:";
    for (const std::string& name : s.bound_only) text += " '" + printable(name) + '\'';
    text += '\n';
  }
  for (const Finding& f : report.refutations)
    text += printable("refuted: " + f.entity + ": claimed " + f.claimed + "; derived " + f.derived +
                      (f.witness.empty() ? "" : "; witness: " + f.witness)) +
            '\n';
  for (const Finding& f : report.open)
    text += printable("undecided: " + f.entity + ": " + f.claimed) + '\n';
  for (const Verdicts& kind : report.kinds)
    if (kind.certified + kind.refuted + kind.undecided > 0)
      text += "  " + kind.kind + ": " + counts(kind);
  if (report.by_balls + report.by_integers > 0)
    text += "  decided by doubles with an error bound: " + std::to_string(report.by_balls) +
            ", by integers: " + std::to_string(report.by_integers) + '\n';
  return text;
}

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const LevelReport& level, bool of_curves) {
  OrderedJson json{{"level", level.name},
                   {"status", status_of(level.refuted, level.undecided)},
                   {"certified", level.certified},
                   {"refuted", level.refuted},
                   {"undecided", level.undecided},
                   {"components", OrderedJson::array()},
                   {"left_out", OrderedJson::object()}};
  for (const Component& c : level.components) {
    if (of_curves)
      json["components"].push_back({{"closed", c.closed}, {"lines", c.cells}});
    else
      json["components"].push_back({{"euler_characteristic", c.euler_characteristic},
                                    {"boundary_loops", c.boundary_loops},
                                    {"triangles", c.cells}});
  }
  for (const auto& [reason, tets] : level.left_out) json["left_out"][reason] = tets;
  json["stability"] = nullptr;
  if (level.claims_stability) {
    json["stability"] = {{"radius", level.radius},
                         {"of", !level.radius_array.empty()  ? "array"
                                : level.radius_of_deviator ? "deviator"
                                                           : "tensor"},
                         {"stable_components", level.stable_components.size()},
                         {"stable_crossings", level.stable_crossings}};
    if (!level.radius_array.empty()) json["stability"]["array"] = level.radius_array;
  }
  json["residual"] = nullptr;
  if (level.residual && std::isfinite(*level.residual)) json["residual"] = *level.residual;
  if (of_curves) return json;
  json["embedded"] = level.embedded;
  json["vertices"] = level.vertices;
  json["vectors_shown"] = level.vectors;
  json["isotopic"] = nullptr;
  if (level.claims_isotopy)
    json["isotopic"] = {{"tetrahedra", level.isotopic},
                        {"vertices_moved_at_most", level.moved},
                        {"not_shown", OrderedJson::object()}};
  for (const auto& [reason, tets] : level.not_isotopic)
    json["isotopic"]["not_shown"][reason] = tets;
  json["distance"] = nullptr;
  if (level.near)
    json["distance"] = {{"bound", std::strtod(level.bound.c_str(), nullptr)},
                        {"triangles", level.bounded},
                        {"coarse_tetrahedra", level.coarse},
                        {"coarse_bound", std::strtod(level.coarse_bound.c_str(), nullptr)}};
  return json;
}

}  // namespace

std::string to_json(const Report& report, const std::vector<std::string>& unmet) {
  const Subject& s = report.subject;
  OrderedJson json{{"status", report.status()},
                   {"claims", report.claims()},
                   {"certified", report.certified},
                   {"refuted", report.refuted},
                   {"undecided", report.undecided},
                   {"unmet_demands", unmet},
                   {"input",
                    {{"path", s.input},
                     {"tensor", s.tensor},
                     {"components", s.listing},
                     {"order", s.order},
                     {"component_names", s.names},
                     {"names_say_order", s.names_say_order},
                     {"points", s.points},
                     {"tetrahedra", s.tetrahedra},
                     {"isotropic_tetrahedra", s.isotropic},
                     {"other_cells", s.other_cells},
                     {"flat_cells", s.flat_cells},
                     {"symmetrized_tensors", s.symmetrized},
                     {"doubled_points", s.doubled_points},
                     {"sha256", s.sha256}}},
                   {"output",
                    {{"path", s.output},
                     {"vertices", s.vertices},
                     {s.of_curves ? "lines" : "triangles", s.cells},
                     {"arrays_not_derived", s.bound_only}}},
                   {"levels", OrderedJson::array()}};
  for (const LevelReport& level : report.levels)
    json["levels"].push_back(json_of(level, s.of_curves));
  for (const Verdicts& kind : report.kinds)
    json["kinds"][kind.kind] = {{"certified", kind.certified},
                                {"refuted", kind.refuted},
                                {"undecided", kind.undecided}};
  json["decided"] = {{"by_balls", report.by_balls}, {"by_integers", report.by_integers}};
  auto& refutations = json["witnesses"] = OrderedJson::array();
  for (const Finding& f : report.refutations)
    refutations.push_back({{"entity", f.entity},
                           {"claimed", f.claimed},
                           {"derived", f.derived},
                           {"witness", f.witness}});
  auto& open = json["open"] = OrderedJson::array();
  for (const Finding& f : report.open)
    open.push_back({{"entity", f.entity}, {"reason", f.claimed}});
  return json.dump(-1, ' ', true, OrderedJson::error_handler_t::replace);
}

}  // namespace certificate
