// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/compare_places.hpp"

#include <algorithm>

#include "claims/containment.hpp"
#include "claims/half_edges.hpp"
#include "run/parallel.hpp"

namespace certificate {
namespace {

std::string text_of(const Point3& p) { return Json(p).dump(); }

}  // namespace

void compare_places(const LevelCase& c, const PlacedSurface& placed, Ledger& ledger) {
  struct Place {
    Number vertex;
    Carrier carrier;
    const Json* crossing = nullptr;
  };
  std::vector<Place> all;
  for (const Json& edge : c.claims["edges"]) {
    // Others are refuted already.
    const EdgeTopology* known = c.topology.edge({edge[0].get<Vertex>(), edge[1].get<Vertex>()});
    for (std::size_t n = 2; known != nullptr && n < edge.size(); ++n)
      for (std::size_t i = 2; i < edge[n].size(); ++i)
        if (const Number v = edge[n][i].get<Number>(); v - c.vertices.first < c.vertices.count)
          all.push_back({v, {{known->vertices[0], known->vertices[1]}, 2}, &edge[n]});
  }
  for (const auto& [vertex, carrier] : placed.places) all.push_back({vertex, carrier});
  std::vector<char> is_there(all.size());
  parallel_for(all.size(), [&](std::size_t i) {
    const auto& [vertex, carrier, crossing] = all[i];
    std::array<Point3, 4> corners;
    for (std::size_t k = 0; k < carrier.count; ++k) corners[k] = c.input.points[carrier.corners[k]];
    const Point3& x = c.surface.points[vertex];
    if (crossing == nullptr) {
      is_there[i] = lies_in(x, std::span(corners.data(), carrier.count));
    } else {
      const Interval interval = interval_of(*crossing);  // compare_edges has seen that it is one
      is_there[i] = lies_between(x, corners[0], corners[1], interval.end(0), interval.end(1));
    }
  });
  const auto missing = std::find(is_there.begin(), is_there.end(), 0);
  if (missing == is_there.end()) return ledger.certify();
  const Place& place = all[static_cast<std::size_t>(missing - is_there.begin())];
  Json corners = Json::array();
  for (std::size_t k = 0; k < place.carrier.count; ++k) corners.push_back(place.carrier.corners[k]);
  ledger.refute("place of vertex " + std::to_string(place.vertex),
                text_of(c.surface.points[place.vertex]),
                place.crossing != nullptr
                    ? "not in the interval " + place.crossing->dump() + " of edge " + corners.dump()
                    : "not in the simplex of the vertices " + corners.dump());
}

}  // namespace certificate
