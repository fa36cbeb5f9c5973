// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/document.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "files/hexadecimal.hpp"
#include "files/parse_document.hpp"

namespace certificate {
namespace {

/// What may stand where. An array has what is listed up to "*n", and then any number of the
/// item that follows, ascending by their first n entries; numbers by themselves, and objects by
/// their first vertex. If there is another item behind, it is for objects with the key `invariant`.
Json make_shape() {
  Json result = Json::parse(R"({
    "format": "text", "version": "natural",
    "input": {"tensor": "text", "components": "text", "points": "natural",
              "tetrahedra": "natural", "sha256": "text"},
    "surface": {"vertices": "natural", "triangles": "natural", "sha256": "text",
                "arrays or none": ["*2", ["text", "text", "natural", "text"]]},
    "levels": ["*0", {
      "mode": "text", "vertices": ["natural", "natural"], "triangles": ["natural", "natural"],
      "on_level": "natural",
      "undecided": ["*1", ["natural", "text"]],
      "edges": ["*2", ["natural", "natural", ["natural or text", "natural", "natural", "*1", "natural"],
                         "*0", ["natural or text", "natural", "natural", "*1", "natural"]]],
      "faces": ["*3", ["natural", "natural", "natural",
                       ["*2", ["natural", "natural"]], ["*1", "natural"]]],
      "tets": ["*1", ["natural", ["integer", "*0", ["natural", "natural", "*0", "natural"]],
                         "*0", ["integer", "*0", ["natural", "natural", "*0", "natural"]]]],
      "cones": ["*1", ["natural", ["natural", "natural", "*0", "natural"],
                          "*1", ["natural", "natural", "*0", "natural"]]],
      "components": ["*1", {"euler_characteristic": "integer", "boundary_loops": "integer",
                            "orientable": "boolean", "triangles": "natural",
                            "first_vertex": "natural"}],
      "embedded or none": "boolean",
      "isotopic or none": {"except": ["*1", "natural"]},
      "stability or none": {"of": "text", "components": ["*1", "natural"], "radius or none": "text",
                            "array or none": "text", "sha256 or none": "text",
                            "crossings or none": ["*1", "natural"]},
      "distance or null": {"reach": ["*0", "integer"], "bound": "text",
                           "coarse": ["*1", "natural"], "coarse_bound": "text"}}]})");
  Json level = result["levels"][1];
  level.erase("mode");
  level["invariant"] = level["value"] = "text";
  result["levels"].push_back(std::move(level));
  return result;
}

/// The same of degenerate curves.
Json make_curve_shape() {
  Json result = Json::parse(R"({
    "polylines": {"vertices": "natural", "lines": "natural", "sha256": "text",
                  "arrays or none": ["*2", ["text", "text", "natural", "text"]]},
    "levels": ["*0", {
      "mode": "text", "vertices": ["natural", "natural"], "lines": ["natural", "natural"],
      "undecided": ["*1", ["natural", "text"]],
      "faces": ["*3", ["natural", "natural", "natural",
                       "*1", ["natural", "natural", "natural", "natural"]]],
      "tets": ["*1", ["natural", "*2", ["natural", "natural"]]],
      "curves": ["*1", {"closed": "boolean", "lines": "natural", "first_vertex": "natural"}]}]})");
  const Json other = make_shape();
  result["levels"][1]["stability or none"] = other["levels"][1]["stability or none"];
  for (const char* key : {"format", "version", "input"}) result[key] = other[key];
  return result;
}

bool is_natural(const Json& value) { return value.is_number_unsigned(); }
bool is_integer(const Json& value) {
  return value.is_number_integer() &&
         (!is_natural(value) || value.get<std::uint64_t>() <= INT64_MAX);
}

/// Is the first in front of the second, by `count` entries?
bool ascend(const Json& first, const Json& second, std::size_t count) {
  if (first.is_object()) return first["first_vertex"] < second["first_vertex"];
  if (!first.is_array()) return first < second;
  for (std::size_t i = 0; i < count; ++i)
    if (first[i] != second[i]) return first[i] < second[i];
  return count == 0;
}

/// A shape, taken apart once.
struct Shape {
  enum class Kind { natural, integer, boolean, natural_or_text, text, object, array };
  /// What belongs to a key of an object.
  struct Member {
    std::string key;
    bool may_miss = false, may_be_null = false;
    std::size_t shape = 0;  ///< among `inner`
  };

  explicit Shape(const Json& shape) {
    if (shape.is_string()) {
      name = shape.get<std::string>();
      kind = name == "natural"           ? Kind::natural
             : name == "integer"         ? Kind::integer
             : name == "boolean"         ? Kind::boolean
             : name == "natural or text" ? Kind::natural_or_text
                                         : Kind::text;
    } else if (shape.is_object()) {
      kind = Kind::object;
      for (const auto& [key, value] : shape.items()) {
        members.push_back({key.substr(0, key.find(' ')), key.ends_with(" or none"),
                           key.ends_with(" or null"), inner.size()});
        inner.emplace_back(value);
      }
    } else {
      kind = Kind::array;
      for (const Json& item : shape) {
        if (!item.is_string() || item.get_ref<const std::string&>()[0] != '*') {
          inner.emplace_back(item);
          continue;
        }
        is_open = true, fixed = inner.size();
        ascending = static_cast<std::size_t>(item.get_ref<const std::string&>()[1] - '0');
      }
      if (!is_open) fixed = inner.size();
    }
  }
  const Shape& at(std::size_t i, const Json& value) const {
    if (i < fixed) return inner[i];
    const bool is_other = fixed + 1 < inner.size() && value.contains("invariant");
    return inner[fixed + (is_other ? 1 : 0)];
  }

  Kind kind;
  std::string name;             ///< of a number or text
  std::vector<Shape> inner;     ///< of members, or of the fixed items and those that follow
  std::vector<Member> members;  ///< of an object
  std::size_t fixed = 0, ascending = 0;
  bool is_open = false;  ///< items may follow the fixed ones
};

bool fits(const Json& value, Shape::Kind kind) {
  switch (kind) {
    case Shape::Kind::natural: return is_natural(value);
    case Shape::Kind::integer: return is_integer(value);
    case Shape::Kind::boolean: return value.is_boolean();
    case Shape::Kind::natural_or_text: return is_natural(value) || value.is_string();
    default: return value.is_string();
  }
}

/// Where a value is not of a shape, and how; or nothing.
std::string misfit(const Json& value, const Shape& shape) {
  if (shape.kind == Shape::Kind::object) {
    if (!value.is_object()) return ": no object";
    std::size_t missing = 0;  // as they may
    for (const Shape::Member& member : shape.members) {
      const auto found = value.find(member.key);
      if (found == value.end() && member.may_miss) {
        ++missing;
        continue;
      }
      if (found == value.end()) return ": no key '" + member.key + "'";
      if (member.may_be_null && found->is_null()) continue;
      if (const std::string wrong = misfit(*found, shape.inner[member.shape]); !wrong.empty())
        return "/" + member.key + wrong;
    }
    return value.size() + missing == shape.members.size() ? "" : ": other keys";
  }
  if (shape.kind != Shape::Kind::array) return fits(value, shape.kind) ? "" : ": no " + shape.name;
  if (!value.is_array()) return ": no array";
  if (value.size() < shape.fixed || (!shape.is_open && value.size() > shape.fixed))
    return ": of another length";
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (const std::string wrong = misfit(value[i], shape.at(i, value[i])); !wrong.empty())
      return "/" + std::to_string(i) + wrong;
    if (i > shape.fixed && shape.ascending > 0 &&
        !ascend(value[i - 1], value[i], shape.ascending))
      return "/" + std::to_string(i) + ": not ascending";
  }
  return {};
}

const std::string& text_of(const Json& value) {
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > 1000) throw Malformed("", "a text that is too long");
  return text;
}

constexpr const char *kOfOne = "tensortopo certificate", *kOfParts = "tensortopo certificate of parts";

void require_shape(const std::string& file, const Json& document, const Shape& shape) {
  if (const std::string wrong = misfit(document, shape); !wrong.empty())
    throw Malformed(file, wrong.starts_with(": ") ? wrong.substr(2) : wrong);
}

/// Fields, surfaces and curves are no documents.
void require_document(const File& file) {
  const std::string_view bytes = file.bytes;
  if (bytes.starts_with('<') || bytes.starts_with("# vtk"))
    throw Malformed(file.name,
                    "is a VTK file, no certificate; the order is FIELD SURFACE CERTIFICATE");
}

bool has_format(const Json& document, const char* format) {
  return document.is_object() && document.contains("format") && document["format"] == format;
}

}  // namespace

Json read_document(const File& source) {
  require_document(source);
  const std::string& file = source.name;
  Json document;
  try {
    document = source.has_extension(".cbor") ? parse_cbor(source.bytes) : parse_json(source.bytes);
  } catch (const Malformed& error) {
    throw Malformed(file, error.problem());
  }
  if (has_format(document, kOfParts))
    throw Malformed(file, "is a certificate of parts; check it with its .pvtu and .pvtp");
  static const Shape surface_shape(make_shape()), curve_shape(make_curve_shape());
  const bool is_of_curves = document.is_object() && document.contains("polylines");
  require_shape(file, document, is_of_curves ? curve_shape : surface_shape);
  if (document["format"] != kOfOne || document["version"] != 1)
    throw Malformed(file, "no certificate of version 1");
  return document;
}

namespace {

/// @param output  "surface" or "polylines"
/// @param whole  numbers of the whole besides those of tetrahedra, vertices and components
Json parts_shape(const char* output, const std::map<std::string, std::string>& whole) {
  Json shape = Json::parse(R"({
    "format": "text", "version": "natural", "mode": "text",
    "parts": ["*0", {"input": {"file": "text", "sha256": "text"},
                     "certificate": {"file": "text", "sha256": "text"}}],
    "whole": {"tetrahedra": "natural", "vertices": "natural", "components": "natural"}})");
  shape["parts"][1][output] = shape["parts"][1]["input"];
  for (const auto& [key, kind] : whole) shape["whole"][key] = kind;
  return shape;
}

}  // namespace

bool is_of_curves(const Json& document) {
  const auto mode = document.find("mode");
  return mode != document.end() && (*mode == "1" || *mode == "-1");
}

Json read_parts_document(const File& source) {
  require_document(source);
  const std::string& file = source.name;
  static const Shape surface_shape(parts_shape("surface", {{"triangles", "natural"},
                                                           {"euler_characteristic", "integer"},
                                                           {"boundary_loops", "natural"}})),
      curve_shape(parts_shape("polylines", {{"lines", "natural"}, {"closed_components", "natural"}}));
  Json document;
  try {
    document = parse_json(source.bytes);
    if (has_format(document, kOfOne))
      throw Malformed(file, "is no certificate of parts; check it with the .vtu and .vtp that it is about");
    const bool of_curves = document.is_object() && is_of_curves(document);
    require_shape(file, document, of_curves ? curve_shape : surface_shape);
    if (document["format"] != kOfParts || document["version"] != 1)
      throw Malformed(file, "no certificate of parts of version 1");
    if (!of_curves) mode_of(document["mode"]);
  } catch (const Malformed& error) {
    throw Malformed(file, error.problem());
  }
  return document;
}

namespace {

mpq_class fraction_of(const Json& value) {
  mpq_class fraction;
  if (fraction.set_str(text_of(value), 10) != 0 || fraction.get_den() == 0)
    throw Malformed("", "a level at what is no fraction");
  fraction.canonicalize();
  if (fraction.get_str() != text_of(value)) throw Malformed("", "a level not in lowest terms");
  return fraction;
}

}  // namespace

std::optional<mpq_class> number_of(const std::string& text) {
  std::string digits = text;
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) {
    digits.erase(point, 1);
    digits += "/1" + std::string(digits.size() - point, '0');
  }
  const bool has_others = digits.find_first_not_of("0123456789/-") != std::string::npos;
  mpq_class result;
  if (digits.empty() || digits.size() > 1000 || has_others || result.set_str(digits, 10) != 0 ||
      result.get_den() == 0)
    return std::nullopt;
  result.canonicalize();
  return result;
}

mpq_class mode_of(const Json& value) {
  const mpq_class mode = fraction_of(value);
  if (abs(mode) >= 1) throw Malformed("", "a mode that is not between -1 and 1");
  return mode;
}

Kind kind_of(const Json& mode) {
  const std::string& text = text_of(mode);
  if (text != "1" && text != "-1") throw Malformed("", "curves of a mode that is not 1 or -1");
  return text == "1" ? Kind::linear : Kind::planar;
}

Invariant invariant_of(const Json& name) {
  static const std::map<std::string, Invariant> names{
      {"magnitude", Invariant::magnitude},
      {"deviator-magnitude", Invariant::deviator_magnitude},
      {"anisotropy", Invariant::anisotropy}};
  const auto found = names.find(text_of(name));
  if (found == names.end()) throw Malformed("", "no such invariant");
  return found->second;
}

mpq_class value_of(const Json& value, Invariant invariant) {
  const mpq_class v = fraction_of(value);
  if (v <= 0 || (invariant == Invariant::anisotropy && v >= 1))
    throw Malformed("", "a value that the invariant has on no surface");
  return v;
}

double length_of(const Json& value) {
  const auto number = hexadecimal(text_of(value));
  // Of a number that is no double, the nearest double would be another claim.
  const double length = number ? number->get_d() : -1;
  if (!(length >= 0 && length <= 0x1p1000) || mpq_class(length) != *number)
    throw Malformed("", "a length that is no hexadecimal double");
  return length;
}

Radius radius_of(const Json& stability) {
  const std::string& of = text_of(stability["of"]);
  if (of != "tensor" && of != "deviator" && of != "array")
    throw Malformed("", "a radius of neither 'tensor' nor 'deviator' nor 'array'");
  const bool of_array = of == "array";
  if (stability.contains("radius") == of_array || stability.contains("array") != of_array ||
      stability.contains("sha256") != of_array)
    throw Malformed("", "radii of '" + of + "' with keys that do not belong to these");
  if (of_array) return {};
  return {of == "deviator", length_of(stability["radius"])};
}

std::string reason_of(const Json& value) {
  static const std::set<std::string> reasons{
      "zero_deviator_inside",   "level_constant_in_cell", "level_constant_on_face",
      "level_constant_on_edge", "critical_value_in_cell", "critical_value_on_face",
      "critical_value_on_edge", "budget_exhausted",       "inconsistent_samples",
      "zero_tensor"};
  if (!reasons.contains(text_of(value))) throw Malformed("", "no such reason");
  return text_of(value);
}

std::string curve_reason_of(const Json& value) {
  static const std::set<std::string> reasons{
      "zero_deviator_vertex",      "dependent_tensors_on_face", "degenerate_conic_on_face",
      "coincident_points_on_face", "degenerate_point_on_edge",  "dependent_tensors_in_cell",
      "neutral_characteristic",    "degenerate_on_a_surface",   "degenerate_throughout",
      "no_deviator_in_cell",       "points_not_told_apart"};
  if (!reasons.contains(text_of(value))) throw Malformed("", "no such reason");
  return text_of(value);
}

Interval interval_of(const Json& crossing) {
  Interval result;
  const bool is_text = crossing[0].is_string();
  const auto refuse = [&](const std::string& digits) {
    throw Malformed("", "no interval " + digits);
  };
  const auto k = crossing[1].get<std::uint64_t>();
  if (k > 2048 || is_text != (k > 53)) refuse(crossing[0].dump());
  if (is_text) {
    const std::string& digits = text_of(crossing[0]);
    if (result.i.set_str(digits, 10) != 0 || result.i.get_str() != digits) refuse(digits);
  } else {
    result.i = crossing[0].get<unsigned long>();
  }
  result.k = static_cast<unsigned>(k);
  if (result.i < 0 || mpz_sizeinbase(result.i.get_mpz_t(), 2) > std::max(result.k, 1U) ||
      (result.k == 0 && result.i != 0))
    throw Malformed("", "an interval that leaves the edge");
  return result;
}

}  // namespace certificate
