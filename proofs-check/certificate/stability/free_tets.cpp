// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "free_tets.hpp"

#include <cfloat>
#include <set>

#include "transverse_simplex.hpp"

namespace certificate {
namespace {

template <std::size_t V>
using Simplices = std::vector<std::array<std::uint32_t, V>>;

/// The vertices of some tetrahedra.
Simplices<4> tets_of(const Input& input, const std::vector<std::size_t>& tets) {
  Simplices<4> result;
  for (const std::size_t t : tets) result.push_back(input.tets[t]);
  return result;
}

/// All parts of V vertices of some simplices, each once.
template <std::size_t V, std::size_t N>
Simplices<V> parts_of(const Simplices<N>& simplices) {
  std::set<std::array<std::uint32_t, V>> all;
  for (const auto& whole : simplices)
    for (unsigned corners = 1; corners < 1U << N; ++corners) {
      std::array<std::uint32_t, V> simplex{};
      std::size_t count = 0;
      for (std::size_t i = 0; i < N; ++i)
        if (corners >> i & 1U) {
          if (count < V) simplex[count] = whole[i];
          ++count;
        }
      if (count == V) all.insert(simplex);
    }
  return {all.begin(), all.end()};
}

/// Asks of each simplex; the first that is not free goes into the result, one that is refuted
/// before others.
template <std::size_t V, class Question>
void ask(const Simplices<V>& simplices, const ForAll& for_all, const char* kind,
         const Question& question, Freedom& result) {
  if (result.answer != Answer::yes) return;
  std::vector<Answer> answers(simplices.size());
  for_all(simplices.size(), [&](std::size_t i) { answers[i] = question(simplices[i]); },
          "stability");
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i] == Answer::yes || result.answer == Answer::no) continue;
    if (result.answer == Answer::unsure && answers[i] == Answer::unsure) continue;
    result = {answers[i], kind};
    for (const std::uint32_t v : simplices[i]) result.place += ' ' + std::to_string(v);
  }
}

}  // namespace

Widened widened(const Field& field, std::uint32_t vertex, const Radius& radius) {
  const Tensor<Ball>& ball = *field.corner(vertex, false).ball;
  Widened result;
  for (std::size_t k = 0; k < 6; ++k) result.centre[k] = ball[k];
  if (radius.of_deviator) {
    result.radius = radius.at(vertex) * largest_norm(result.centre) * Ball::kSlack;
  } else {
    const long exponent = -field.scale(vertex);
    result.radius = std::ldexp(3 * radius.at(vertex) * Ball::kSlack,
                               static_cast<int>(exponent > 5000    ? 5000
                                                : exponent < -5000 ? -5000
                                                                   : exponent)) +
                    DBL_TRUE_MIN;
  }
  return result;
}

namespace {

/// @param vertex_is_fine  of a tensor that is not zero
/// @param is_fine  of larger simplices
template <std::size_t N, class OfVertex, class OfSimplex>
Freedom ask_all(const Field& field, const Radius& radius, const Simplices<N>& simplices,
                const ForAll& for_all, const OfVertex& vertex_is_fine, const OfSimplex& is_fine) {
  Freedom result;
  ask(parts_of<1>(simplices), for_all, "vertex",
      [&](const auto& v) {
        return field.is_zero(v[0]) ? Answer::no : vertex_is_fine(widened(field, v[0], radius));
      },
      result);
  const auto simplex_is_fine = [&]<std::size_t V>(const std::array<std::uint32_t, V>& simplex) {
    std::array<Widened, V> corners;
    for (std::size_t i = 0; i < V; ++i) corners[i] = widened(field, simplex[i], radius);
    return is_fine(corners);
  };
  ask(parts_of<2>(simplices), for_all, "edge", simplex_is_fine, result);
  if constexpr (N >= 3) ask(parts_of<3>(simplices), for_all, "face", simplex_is_fine, result);
  if constexpr (N >= 4)
    ask(parts_of<4>(simplices), for_all, "tetrahedron", simplex_is_fine, result);
  return result;
}

/// The opposite tensors.
Widened opposite(Widened ball) {
  ball.centre = Ball(-1) * ball.centre;
  return ball;
}

template <std::size_t N>
Freedom all_free(const Field& field, const ModeBall& mode, const Radius& radius,
                 const Simplices<N>& simplices, const ForAll& for_all) {
  return ask_all(
      field, radius, simplices, for_all,
      [&](const Widened& vertex) { return vertex_is_free(vertex, mode); },
      [&]<std::size_t V>(const std::array<Widened, V>& corners) {
        return simplex_is_free<V>(corners, mode);
      });
}

template <std::size_t N>
Freedom all_transverse(const Field& field, bool planar, const Radius& radius,
                       const Simplices<N>& simplices, const ForAll& for_all) {
  const ModeBall one(1, 1);
  return ask_all(
      field, radius, simplices, for_all,
      [&](const Widened& vertex) {
        return vertex_is_free(planar ? opposite(vertex) : vertex, one);
      },
      [&]<std::size_t V>(std::array<Widened, V> corners) {
        if (planar)
          for (Widened& corner : corners) corner = opposite(corner);
        return simplex_is_transverse<V>(corners);
      });
}

}  // namespace

Freedom are_free(const Input& input, const Field& field, const ModeBall& mode, const Radius& radius,
                 const std::vector<std::size_t>& tets, const ForAll& for_all) {
  return all_free(field, mode, radius, tets_of(input, tets), for_all);
}

Freedom are_free(const Field& field, const ModeBall& mode, const Radius& radius,
                 const std::vector<std::array<std::uint32_t, 2>>& edges, const ForAll& for_all) {
  return all_free(field, mode, radius, edges, for_all);
}

Freedom are_transverse(const Input& input, const Field& field, bool planar, const Radius& radius,
                       const std::vector<std::size_t>& tets, const ForAll& for_all) {
  return all_transverse(field, planar, radius, tets_of(input, tets), for_all);
}

Freedom are_transverse(const Field& field, bool planar, const Radius& radius,
                       const std::vector<std::array<std::uint32_t, 3>>& faces,
                       const ForAll& for_all) {
  return all_transverse(field, planar, radius, faces, for_all);
}

}  // namespace certificate
