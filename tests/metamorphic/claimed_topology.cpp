// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claimed_topology.hpp"

#include <algorithm>
#include <sstream>

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = TetMesh::Index;

template <std::size_t Count>
std::ostream& print(std::ostream& out, const std::array<Index, Count>& simplex) {
  for (const Index v : simplex) out << v << ' ';
  return out;
}
std::ostream& print(std::ostream& out, int value) { return out << value; }
std::ostream& print(std::ostream& out, const std::string& value) { return out << value; }
std::ostream& print(std::ostream& out, const std::array<int, 2>& curves) {
  return out << curves[0] << " arcs, " << curves[1] << " closed";
}
std::ostream& print(std::ostream& out, const std::vector<ComponentTopology>& list) {
  for (const auto& c : list) out << c << ' ';
  return out;
}

template <class Map>
void compare(const char* what, const Map& a, const Map& b, std::ostream& out) {
  const auto one_way = [&](const Map& from, const Map& other, const char* whose) {
    for (const auto& [key, value] : from) {
      const auto found = other.find(key);
      if (found != other.end() && found->second == value) continue;
      print(print(out << whose << what << ' ', key) << ": ", value) << '\n';
    }
  };
  one_way(a, b, "first: ");
  one_way(b, a, "second: ");
}

}  // namespace

ClaimedTopology claimed_topology(const Json& level, const TetMesh& mesh,
                                 const std::vector<Index>& to) {
  const auto number = [&](Index v) { return to.empty() ? v : to[static_cast<std::size_t>(v)]; };
  const auto simplex = [&]<std::size_t Count>(std::array<Index, Count> vertices) {
    for (Index& v : vertices) v = number(v);
    std::ranges::sort(vertices);
    return vertices;
  };
  const auto tet = [&](const Json& id) {
    const auto found = std::ranges::find(mesh.cell_ids, id.get<std::int64_t>());
    return simplex(mesh.tets.at(static_cast<std::size_t>(found - mesh.cell_ids.begin())));
  };
  const auto sheets_of = [](const Json& entry) {
    std::vector<ComponentTopology> result;
    for (std::size_t s = 1; s < entry.size(); ++s)
      result.push_back({entry[s][0], static_cast<int>(entry[s].size()) - 1});
    std::ranges::sort(result);
    return result;
  };
  ClaimedTopology result;
  for (const Json& e : level["edges"])
    result.crossings[simplex(std::array<Index, 2>{e[0], e[1]})] = static_cast<int>(e.size()) - 2;
  for (const Json& f : level["faces"])
    result.curves[simplex(std::array<Index, 3>{f[0], f[1], f[2]})] = {
        static_cast<int>(f[3].size()), static_cast<int>(f[4].size())};
  for (const Json& t : level["tets"]) result.sheets[tet(t[0])] = sheets_of(t);
  for (const Json& t : level["cones"]) result.cones[tet(t[0])] = static_cast<int>(t.size()) - 1;
  for (const Json& t : level["undecided"]) result.undecided[tet(t[0])] = t[1];
  for (const Json& c : level["components"])
    result.components.push_back({c["euler_characteristic"], c["boundary_loops"]});
  std::ranges::sort(result.components);
  result.on_level = level["on_level"];
  return result;
}

std::string difference(const ClaimedTopology& a, const ClaimedTopology& b) {
  std::ostringstream out;
  compare("edge", a.crossings, b.crossings, out);
  compare("face", a.curves, b.curves, out);
  compare("tetrahedron", a.sheets, b.sheets, out);
  compare("cones in", a.cones, b.cones, out);
  compare("undecided", a.undecided, b.undecided, out);
  if (a.components != b.components)
    print(print(out << "components ", a.components) << "; ", b.components) << '\n';
  if (a.on_level != b.on_level)
    out << "vertices on the level " << a.on_level << "; " << b.on_level << '\n';
  return out.str();
}

}  // namespace tensortopo::test
