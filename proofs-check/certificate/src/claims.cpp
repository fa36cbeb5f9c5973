// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "file_bytes.hpp"
#include "certificate_check/check_certificate.hpp"
#include "strict_json.hpp"

namespace certificate {
namespace {

using nlohmann::json;

/// A value and where it is, for messages.
class Value {
 public:
  explicit Value(const json& value) : value_(value) {}
  Value(const json& value, const Value& parent, const char* key, std::size_t index = 0)
      : value_(value), parent_(&parent), key_(key), index_(index) {}

  std::string path() const {
    if (parent_ == nullptr) return "";
    return parent_->path() + "/" + (key_ != nullptr ? key_ : std::to_string(index_));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Malformed("", (parent_ == nullptr ? "top level" : path()) + ": " + what);
  }
  void require(bool condition, const char* what) const {
    if (!condition) fail(what);
  }
  /// This object has exactly these keys.
  void has_keys(const std::set<std::string>& keys) const {
    require(value_.is_object(), "not an object");
    for (const auto& [key, unused] : value_.items())
      if (!keys.contains(key)) fail("unknown key '" + key.substr(0, 40) + "'");
    for (const std::string& key : keys)
      if (!value_.contains(key)) fail("no key '" + key + "'");
  }
  Value operator[](const char* key) const { return {value_.at(key), *this, key}; }
  std::size_t size() const {
    require(value_.is_array(), "not an array");
    return value_.size();
  }
  Value operator[](std::size_t i) const {
    require(i < size(), "too short");
    return {value_[i], *this, nullptr, i};
  }
  bool is_null() const { return value_.is_null(); }
  Number number() const {
    require(value_.is_number_unsigned() ||
                (value_.is_number_integer() && value_.get<std::int64_t>() >= 0),
            "not a natural number");
    return value_.get<Number>();
  }
  std::int64_t integer() const {
    require(value_.is_number_integer() &&
                (!value_.is_number_unsigned() || value_.get<Number>() <= INT64_MAX),
            "not an integer");
    return value_.get<std::int64_t>();
  }
  bool boolean() const {
    require(value_.is_boolean(), "neither true nor false");
    return value_.get<bool>();
  }
  std::string text() const {
    require(value_.is_string(), "not a string");
    return value_.get<std::string>();
  }

 private:
  const json& value_;
  const Value* parent_ = nullptr;
  const char* key_ = nullptr;
  std::size_t index_ = 0;
};

template <class Item, class Read>
std::vector<Item> list(const Value& array, const Read& read, std::size_t first = 0) {
  std::vector<Item> items;
  for (std::size_t i = first; i < array.size(); ++i) items.push_back(read(array[i]));
  return items;
}

template <class Items, class Key>
void require_ascending(const Value& where, const Items& items, const Key& key) {
  for (std::size_t i = 1; i < items.size(); ++i)
    if (!(key(items[i - 1]) < key(items[i]))) where.fail("not ascending at " + std::to_string(i));
}
constexpr auto kItself = [](const auto& item) { return item; };

template <std::size_t Count>
std::array<Number, Count> ascending_numbers(const Value& array) {
  std::array<Number, Count> numbers{};
  for (std::size_t i = 0; i < Count; ++i) numbers[i] = array[i].number();
  require_ascending(array, numbers, kItself);
  return numbers;
}

std::string digest(const Value& value) {
  const std::string text = value.text();
  value.require(text.size() == 64 &&
                    text.find_first_not_of("0123456789abcdef") == std::string::npos,
                "not 64 hexadecimal digits");
  return text;
}

/// An integer, or decimal digits that hold it.
mpz_class natural(const Value& value, bool is_text) {
  if (!is_text) return mpz_class(std::to_string(value.number()));
  const std::string text = value.text();
  value.require(!text.empty() && text.size() <= 700 && (text[0] != '0' || text.size() == 1) &&
                    text.find_first_not_of("0123456789") == std::string::npos,
                "not a natural number in decimal");
  return mpz_class(text);
}

CrossingClaim crossing(const Value& value) {
  value.require(value.size() == 3, "not [i, k, v]");
  CrossingClaim claim;
  constexpr Number kMaxK = 2048;
  value.require(value[1].number() <= kMaxK, "k is too large");
  claim.k = static_cast<unsigned>(value[1].number());
  claim.i = natural(value[std::size_t{0}], claim.k > 53);
  value.require(claim.i < mpz_class(1) << claim.k, "the interval leaves the edge");
  claim.vertex = value[2].number();
  return claim;
}

EdgeClaim edge(const Value& value) {
  EdgeClaim claim{ascending_numbers<2>(value), list<CrossingClaim>(value, crossing, 2)};
  value.require(!claim.crossings.empty(), "no crossing");
  return claim;
}

FaceClaim face(const Value& value) {
  value.require(value.size() == 5, "not [a, b, c, arcs, loops]");
  FaceClaim claim;
  claim.face = ascending_numbers<3>(value);
  claim.arcs = list<std::array<Number, 2>>(value[3], [](const Value& arc) {
    arc.require(arc.size() == 2, "not [v, w]");
    return ascending_numbers<2>(arc);
  });
  claim.loops = list<Number>(value[4], [](const Value& v) { return v.number(); });
  require_ascending(value[3], claim.arcs, kItself);
  require_ascending(value[4], claim.loops, kItself);
  value.require(!claim.arcs.empty() || !claim.loops.empty(), "no curve");
  return claim;
}

SheetClaim sheet(const Value& value) {
  SheetClaim claim;
  claim.euler_characteristic = value[std::size_t{0}].integer();
  claim.loops = list<std::vector<Number>>(value, [](const Value& loop) {
    auto numbers = list<Number>(loop, [](const Value& v) { return v.number(); });
    loop.require(!numbers.empty() && numbers.size() % 2 == 0, "not pairs of crossing and face");
    return numbers;
  }, 1);
  require_ascending(value, claim.loops, [](const auto& loop) { return loop[0]; });
  value.require(!claim.loops.empty(), "no loop");
  return claim;
}

TetClaim tet(const Value& value) {
  TetClaim claim{value[std::size_t{0}].number(), list<SheetClaim>(value, sheet, 1)};
  value.require(!claim.sheets.empty(), "no sheet");
  require_ascending(value, claim.sheets, [](const SheetClaim& s) { return s.loops[0][0]; });
  return claim;
}

ComponentClaim component(const Value& value) {
  value.has_keys({"euler_characteristic", "boundary_loops", "orientable", "triangles",
                  "first_vertex"});
  return {value["euler_characteristic"].integer(), value["boundary_loops"].integer(),
          value["orientable"].boolean(), value["triangles"].number(),
          value["first_vertex"].number()};
}

double length(const Value& value) {
  const std::string text = value.text();
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  value.require(text.starts_with("0x") && *end == 0 && result >= 0 && result <= 0x1p1000,
                "not a hexadecimal double");
  return result;
}

DistanceClaim distance(const Value& value) {
  value.has_keys({"reach", "bound", "coarse", "coarse_bound"});
  DistanceClaim claim;
  claim.reach = list<std::int64_t>(value["reach"], [](const Value& n) { return n.integer(); });
  claim.bound = length(value["bound"]);
  claim.coarse = list<Number>(value["coarse"], [](const Value& t) { return t.number(); });
  require_ascending(value["coarse"], claim.coarse, kItself);
  claim.coarse_bound = length(value["coarse_bound"]);
  return claim;
}

void read_mode(const Value& value, LevelClaims& level) {
  level.mode = value.text();
  const std::size_t slash = level.mode.find('/');
  const std::string top = level.mode.substr(0, slash);
  const std::string bottom = slash == std::string::npos ? "1" : level.mode.substr(slash + 1);
  const auto is_natural = [](const std::string& s) {
    return !s.empty() && s.size() <= 400 && s.find_first_not_of("0123456789") == std::string::npos;
  };
  value.require(is_natural(top.substr(top.starts_with('-') ? 1 : 0)) && is_natural(bottom),
                "not a fraction");
  level.numerator = mpz_class(top, 10), level.denominator = mpz_class(bottom, 10);
  value.require(abs(level.numerator) < level.denominator, "not between -1 and 1");
  mpq_class lowest(level.numerator, level.denominator);
  lowest.canonicalize();
  value.require(lowest.get_str() == level.mode, "not in lowest terms");
}

std::array<Number, 2> range(const Value& value) {
  value.require(value.size() == 2, "not [first, count]");
  return {value[std::size_t{0}].number(), value[1].number()};
}

std::pair<Number, std::string> undecided(const Value& value) {
  static const std::set<std::string> reasons{
      "zero_deviator_vertex",   "zero_deviator_inside",   "level_constant_in_cell",
      "level_constant_on_face", "level_constant_on_edge", "critical_value_in_cell",
      "critical_value_on_face", "critical_value_on_edge", "budget_exhausted",
      "inconsistent_samples"};
  value.require(value.size() == 2, "not [t, reason]");
  value[1].require(reasons.contains(value[1].text()), "no such reason");
  return {value[std::size_t{0}].number(), value[1].text()};
}

LevelClaims level(const Value& value) {
  value.has_keys({"mode", "vertices", "triangles", "on_level", "undecided", "edges", "faces",
                  "tets", "components", "distance"});
  LevelClaims claims;
  read_mode(value["mode"], claims);
  claims.vertices = range(value["vertices"]);
  claims.triangles = range(value["triangles"]);
  claims.on_level = value["on_level"].number();
  claims.undecided = list<std::pair<Number, std::string>>(value["undecided"], undecided);
  claims.edges = list<EdgeClaim>(value["edges"], edge);
  claims.faces = list<FaceClaim>(value["faces"], face);
  claims.tets = list<TetClaim>(value["tets"], tet);
  claims.components = list<ComponentClaim>(value["components"], component);
  require_ascending(value["undecided"], claims.undecided, [](const auto& u) { return u.first; });
  require_ascending(value["edges"], claims.edges, [](const auto& e) { return e.edge; });
  require_ascending(value["faces"], claims.faces, [](const auto& f) { return f.face; });
  require_ascending(value["tets"], claims.tets, [](const auto& t) { return t.tet; });
  require_ascending(value["components"], claims.components,
                    [](const auto& c) { return c.first_vertex; });
  if (!value["distance"].is_null()) claims.distance = distance(value["distance"]);
  return claims;
}

}  // namespace

Claims read_claims(const std::string& file) {
  const std::string bytes = file_bytes(file);
  try {
    const json document = parse_strictly(bytes, file.ends_with(".cbor"));
    const Value top(document);
    top.has_keys({"format", "version", "input", "surface", "levels"});
    top.require(top["format"].text() == "tensortopo certificate", "not a certificate");
    top.require(top["version"].number() == 1, "not version 1");
    const Value input = top["input"], surface = top["surface"];
    input.has_keys({"tensor", "components", "points", "tetrahedra", "sha256"});
    surface.has_keys({"vertices", "triangles", "sha256"});
    Claims claims;
    claims.tensor = input["tensor"].text();
    claims.components = input["components"].text();
    claims.points = input["points"].number();
    claims.tetrahedra = input["tetrahedra"].number();
    claims.input_sha256 = digest(input["sha256"]);
    claims.vertices = surface["vertices"].number();
    claims.triangles = surface["triangles"].number();
    claims.surface_sha256 = digest(surface["sha256"]);
    claims.levels = list<LevelClaims>(top["levels"], level);
    return claims;
  } catch (const Malformed& error) {
    throw Malformed(file, error.problem());
  } catch (const json::exception& error) {
    throw Malformed(file, error.what());
  }
}

}  // namespace certificate
