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

/// All simplices of V vertices of some tetrahedra, each once.
template <std::size_t V>
Simplices<V> simplices_of(const Input& input, const std::vector<std::size_t>& tets) {
  std::set<std::array<std::uint32_t, V>> all;
  for (const std::size_t t : tets)
    for (unsigned corners = 1; corners < 16; ++corners) {
      std::array<std::uint32_t, V> simplex{};
      std::size_t count = 0;
      for (std::size_t i = 0; i < 4; ++i)
        if (corners >> i & 1U) {
          if (count < V) simplex[count] = input.tets[t][i];
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
template <class OfVertex, class OfSimplex>
Freedom ask_all(const Input& input, const Field& field, const Radius& radius,
                const std::vector<std::size_t>& tets, const ForAll& for_all,
                const OfVertex& vertex_is_fine, const OfSimplex& is_fine) {
  Freedom result;
  ask(simplices_of<1>(input, tets), for_all, "vertex",
      [&](const auto& v) {
        return field.is_zero(v[0]) ? Answer::no : vertex_is_fine(widened(field, v[0], radius));
      },
      result);
  const auto simplex_is_fine = [&]<std::size_t V>(const std::array<std::uint32_t, V>& simplex) {
    std::array<Widened, V> corners;
    for (std::size_t i = 0; i < V; ++i) corners[i] = widened(field, simplex[i], radius);
    return is_fine(corners);
  };
  ask(simplices_of<2>(input, tets), for_all, "edge", simplex_is_fine, result);
  ask(simplices_of<3>(input, tets), for_all, "face", simplex_is_fine, result);
  ask(simplices_of<4>(input, tets), for_all, "tetrahedron", simplex_is_fine, result);
  return result;
}

/// The opposite tensors.
Widened opposite(Widened ball) {
  ball.centre = Ball(-1) * ball.centre;
  return ball;
}

}  // namespace

Freedom are_free(const Input& input, const Field& field, const ModeBall& mode, const Radius& radius,
                 const std::vector<std::size_t>& tets, const ForAll& for_all) {
  return ask_all(
      input, field, radius, tets, for_all,
      [&](const Widened& vertex) { return vertex_is_free(vertex, mode); },
      [&]<std::size_t V>(const std::array<Widened, V>& corners) {
        return simplex_is_free<V>(corners, mode);
      });
}

Freedom are_transverse(const Input& input, const Field& field, bool planar, const Radius& radius,
                       const std::vector<std::size_t>& tets, const ForAll& for_all) {
  const ModeBall one(1, 1);
  return ask_all(
      input, field, radius, tets, for_all,
      [&](const Widened& vertex) {
        return vertex_is_free(planar ? opposite(vertex) : vertex, one);
      },
      [&]<std::size_t V>(std::array<Widened, V> corners) {
        if (planar)
          for (Widened& corner : corners) corner = opposite(corner);
        return simplex_is_transverse<V>(corners);
      });
}

}  // namespace certificate
