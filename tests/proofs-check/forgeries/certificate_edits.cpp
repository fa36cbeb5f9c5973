// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "certificate_edits.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

void find_values(const Json& value, const Json::json_pointer& at,
                 std::vector<Json::json_pointer>& found) {
  if (!at.empty()) found.push_back(at);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) find_values(value[i], at / i, found);
  if (value.is_object())
    for (const auto& [key, item] : value.items()) find_values(item, at / key, found);
}

/// Has one of the intervals [i, k, v] all of the other? (Then both hold the same crossing, if the
/// wider one holds no more.)
bool are_nested(const Json& a, const Json& b) {
  const auto ends = [](const Json& x) {
    const mpz_class i(x[0].is_string() ? x[0].get<std::string>() : x[0].dump());
    const mpz_class one = mpz_class(1) << x[1].get<unsigned>();
    return std::array{mpq_class(i, one), mpq_class(i + 1, one)};
  };
  if (a.size() != b.size() || !std::equal(a.begin() + 2, a.end(), b.begin() + 2)) return false;
  const auto p = ends(a), q = ends(b);
  return (p[0] <= q[0] && q[1] <= p[1]) || (q[0] <= p[0] && p[1] <= q[1]);
}

bool is_crossing(const Json& x) { return x.is_array() && x.size() >= 3; }

/// Does the second level say no more about isotopy than the first?
bool excepts_more(const Json& honest, const Json& altered) {
  if (!honest.contains("isotopic") || !altered.contains("isotopic"))
    return honest.contains("isotopic");
  const Json &a = honest["isotopic"]["except"], &b = altered["isotopic"]["except"];
  return std::includes(b.begin(), b.end(), a.begin(), a.end());
}

}  // namespace

std::vector<Json::json_pointer> places_in(const Json& document) {
  std::vector<Json::json_pointer> places;
  find_values(document, Json::json_pointer(), places);
  return places;
}

void edit_document(Json& document, const std::vector<Json::json_pointer>& places,
                   std::mt19937_64& random) {
  const Json::json_pointer& place = places[random() % places.size()];
  if (!document.contains(place)) return;  // an edit before took it away
  Json& value = document[place];
  const Json::json_pointer& other = places[random() % places.size()];
  switch (random() % 6) {
    case 0:
      if (document.contains(other)) value = Json(document[other]);
      return;
    case 1:
      if (value.is_array() && !value.empty()) value.erase(random() % value.size());
      return;
    case 2:
      if (value.is_array() && !value.empty()) value.push_back(Json(value[random() % value.size()]));
      return;
    case 3:
      if (value.is_array() && value.size() > 1)
        std::swap(value[random() % value.size()], value[random() % value.size()]);
      return;
    default:
      if (value.is_boolean()) {
        value = !value.get<bool>();
      } else if (value.is_number_integer()) {
        constexpr std::array<std::int64_t, 8> steps{-100, -2, -1, 1, 2, 3, 1000, 1LL << 40};
        value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value.get<std::int64_t>()) +
                                          static_cast<std::uint64_t>(steps[random() % 8]));
      } else if (value.is_string() && !value.get_ref<std::string&>().empty()) {
        std::string& text = value.get_ref<std::string&>();
        text[random() % text.size()] = "0123456789abcdef-/xp+."[random() % 22];
      }
  }
}

bool may_be_true(const Json& honest, const Json& altered) {
  Json a = honest, b = altered;
  for (std::size_t l = 0; l < a["levels"].size(); ++l) {
    a["levels"][l].erase("distance"), b["levels"][l].erase("distance");
    if (excepts_more(a["levels"][l], b["levels"][l]))
      a["levels"][l].erase("isotopic"), b["levels"][l].erase("isotopic");
    if (a["levels"][l]["edges"].empty())
      a["levels"][l].erase("value"), b["levels"][l].erase("value");
    Json &edges = a["levels"][l]["edges"], &others = b["levels"][l]["edges"];
    if (edges.size() != others.size()) return false;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].size() != others[e].size()) return false;
      for (std::size_t k = 2; k < edges[e].size(); ++k)
        if (is_crossing(others[e][k]) && are_nested(edges[e][k], others[e][k]))
          others[e][k] = edges[e][k];
    }
  }
  return a == b;
}

bool may_be_true_of_curves(const Json& honest, const Json& altered) {
  Json b = altered;
  for (std::size_t l = 0; l < honest["levels"].size(); ++l) {
    const Json& faces = honest["levels"][l]["faces"];
    Json& others = b["levels"][l]["faces"];
    if (faces.size() != others.size()) return false;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (faces[f].size() != others[f].size()) return false;
      for (std::size_t n = 3; n < faces[f].size(); ++n) {
        const Json &box = faces[f][n], &other = others[f][n];
        const auto middle = [](const Json& x, std::size_t k) {
          return std::ldexp(x[k].get<double>(), -x[3].get<int>());
        };
        const double reach =
            std::ldexp(1.0, -box[3].get<int>()) + std::ldexp(1.0, -other[3].get<int>());
        if (box[0] == other[0] && std::abs(middle(box, 1) - middle(other, 1)) <= reach &&
            std::abs(middle(box, 2) - middle(other, 2)) <= reach)
          others[f][n] = box;
      }
    }
  }
  return honest == b;
}

}  // namespace tensortopo::test
