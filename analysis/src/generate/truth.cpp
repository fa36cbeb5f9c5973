// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "generate/truth.hpp"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_text.hpp"

namespace tensortopo {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "tensortopo truth";
constexpr int kVersion = 1;

Json json_of(const LevelTruth& level) {
  Json json;
  json["mode"] = level.mode.text();
  json["components"] = Json::array();
  for (const auto& c : level.components) {
    json["components"].push_back({{"euler_characteristic", c.euler_characteristic},
                                  {"boundary_loops", c.boundary_loops},
                                  {"orientable", c.orientable},
                                  {"closed", c.closed()}});
    if (c.member >= 0) json["components"].back()["member"] = c.member;
  }
  if (level.detailed) {
    json["edges"] = Json::array();
    for (const auto& e : level.edges)
      json["edges"].push_back({e.vertices[0], e.vertices[1], e.crossings});
    json["faces"] = Json::array();
    for (const auto& f : level.faces)
      json["faces"].push_back(
          {f.vertices[0], f.vertices[1], f.vertices[2], f.arcs, f.closed_curves});
    json["tetrahedra"] = Json::array();
    for (const auto& t : level.tets) json["tetrahedra"].push_back({t.tet, t.sheets});
  }
  json["undecided"] = Json::array();
  for (const auto& cell : level.undecided) json["undecided"].push_back({cell.tet, cell.reason});
  if (level.reference) {
    const auto& r = *level.reference;
    json["reference"] = {{"surface", r.surface},
                         {"points", r.points},
                         {"vertices", r.vertices},
                         {"triangles", r.triangles},
                         {"distance", r.distance},
                         {"coarse_cells", r.coarse_cells},
                         {"coarse_distance", r.coarse_distance},
                         {"point_bound", r.point_bound},
                         {"unproved_points", r.unproved_points}};
  }
  return json;
}

/// An integer that T holds: the library would round or wrap any number.
template <class T>
T whole(const Json& json) {
  if (json.is_number_unsigned() && std::in_range<T>(json.get<std::uint64_t>()))
    return static_cast<T>(json.get<std::uint64_t>());
  if (json.is_number_integer() && !json.is_number_unsigned() &&
      std::in_range<T>(json.get<std::int64_t>()))
    return static_cast<T>(json.get<std::int64_t>());
  throw std::invalid_argument("a value is no integer, or too large");
}

LevelTruth level_of(const Json& json) {
  LevelTruth level;
  level.mode = ModeValue::parse(json.at("mode").get<std::string>());
  for (const auto& c : json.at("components"))
    level.components.push_back({whole<std::int64_t>(c.at("euler_characteristic")),
                                whole<std::size_t>(c.at("boundary_loops")),
                                c.at("orientable").get<bool>(),
                                c.contains("member") ? whole<int>(c.at("member")) : -1});
  std::sort(level.components.begin(), level.components.end());
  level.detailed = json.contains("edges");
  if (level.detailed) {
    using Index = TetMesh::Index;
    for (const auto& e : json.at("edges"))
      level.edges.push_back({{whole<Index>(e.at(0)), whole<Index>(e.at(1))}, whole<int>(e.at(2))});
    for (const auto& f : json.at("faces"))
      level.faces.push_back({{whole<Index>(f.at(0)), whole<Index>(f.at(1)), whole<Index>(f.at(2))},
                             whole<int>(f.at(3)),
                             whole<int>(f.at(4))});
    for (const auto& t : json.at("tetrahedra")) {
      level.tets.push_back({whole<Index>(t.at(0)), {}});
      for (const auto& sheet : t.at(1))
        level.tets.back().sheets.push_back({whole<int>(sheet.at(0)), whole<int>(sheet.at(1))});
    }
  }
  for (const auto& cell : json.at("undecided"))
    level.undecided.push_back({whole<TetMesh::Index>(cell.at(0)), cell.at(1).get<std::string>()});
  return level;
}

}  // namespace

LevelTruth level_truth(const CertifiedLevel& level, bool detailed,
                       const std::function<int(const ComponentClaim&)>& member_of) {
  LevelTruth truth;
  truth.mode = std::get<ModeValue>(level.value);
  truth.detailed = detailed;
  truth.undecided = level.undecided;
  for (const auto& c : level.components)
    truth.components.push_back(
        {c.euler_characteristic, c.boundary_loops, c.orientable, member_of ? member_of(c) : -1});
  std::sort(truth.components.begin(), truth.components.end());
  if (!detailed) return truth;
  for (const auto& e : level.topology.edges)
    truth.edges.push_back({e.vertices, static_cast<int>(e.crossings.size())});
  for (const auto& f : level.topology.faces)
    truth.faces.push_back(
        {f.vertices, static_cast<int>(f.arcs.size()), static_cast<int>(f.loops.size())});
  for (const auto& t : level.topology.tets) {
    LevelTruth::TetFact fact{t.tet, {}};
    for (const auto& sheet : t.sheets)
      fact.sheets.push_back({sheet.euler_characteristic, static_cast<int>(sheet.loops.size())});
    std::sort(fact.sheets.begin(), fact.sheets.end());
    truth.tets.push_back(std::move(fact));
  }
  for (const auto& cone : level.topology.cones) {
    const std::array<int, 2> disc{1, 1};
    truth.tets.push_back({cone.tet, {cone.sheets.size(), disc}});
  }
  std::sort(truth.tets.begin(), truth.tets.end(),
            [](const auto& p, const auto& q) { return p.tet < q.tet; });
  return truth;
}

std::string to_json(const FieldTruth& truth) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["kind"] = truth.kind;
  json["note"] = truth.note;
  if (!truth.notes.empty()) json["notes"] = truth.notes;
  json["seed"] = truth.seed;
  json["member"] = truth.member;
  json["members"] = truth.members;
  json["field"] = {
      {"sha256", truth.field_sha256}, {"points", truth.points}, {"tetrahedra", truth.tetrahedra}};
  // One line for each level keeps long lists of small entries readable enough, and short.
  std::string text = json.dump(1);
  text.resize(text.size() - 2);  // "\n}"
  text += ",\n \"levels\": [";
  for (std::size_t i = 0; i < truth.levels.size(); ++i)
    text += (i ? ",\n  " : "\n  ") + json_of(truth.levels[i]).dump();
  return text + "\n ]\n}\n";
}

FieldTruth read_truth(const std::filesystem::path& file) {
  return parse_truth(read_text(file), file);
}

FieldTruth parse_truth(const std::string& text, const std::filesystem::path& file) {
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat || json.at("version") != kVersion)
      throw IoError(IoError::Kind::invalid, file, "no truth file of version 1");
    FieldTruth truth;
    truth.kind = json.at("kind").get<std::string>();
    truth.note = json.at("note").get<std::string>();
    truth.notes = json.value("notes", std::vector<std::string>{});
    truth.seed = whole<std::uint64_t>(json.at("seed"));
    truth.member = whole<int>(json.at("member"));
    truth.members = whole<int>(json.at("members"));
    truth.field_sha256 = json.at("field").at("sha256").get<std::string>();
    truth.points = whole<std::size_t>(json.at("field").at("points"));
    truth.tetrahedra = whole<std::size_t>(json.at("field").at("tetrahedra"));
    for (const auto& level : json.at("levels")) truth.levels.push_back(level_of(level));
    return truth;
  } catch (const nlohmann::json::parse_error& problem) {
    throw IoError(IoError::Kind::invalid, file,
                  "no truth file: no JSON at byte " + std::to_string(problem.byte));
  } catch (const nlohmann::json::exception&) {
    throw IoError(IoError::Kind::invalid, file,
                  "no truth file: a key is missing or its value of another kind");
  } catch (const std::invalid_argument& problem) {
    throw IoError(IoError::Kind::invalid, file, std::string("no truth file: ") + problem.what());
  }
}

}  // namespace tensortopo
