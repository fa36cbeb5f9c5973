// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "witness_fields.hpp"

namespace tensortopo::test {

namespace {

using Triangle = std::array<std::array<double, 2>, 3>;
constexpr auto minimum = CriticalKind::minimum, maximum = CriticalKind::maximum,
               saddle = CriticalKind::saddle;

std::vector<PlanarWitness> make_planar_witnesses() {
  std::vector<PlanarWitness> all;
  const SymmetricTensor<double> xy{0, 0, 0, 1, 0, 0}, yz{0, 0, 0, 0, 1, 0}, xz{0, 0, 0, 0, 0, 1};
  const Triangle wide{{{-16, -8}, {16, -8}, {0, 20}}};

  all.push_back(
      {"offdiag",
       "[[0,1,x],[1,0,y],[x,y,0]], mode 3 sqrt(3) xy / (1+x^2+y^2)^(3/2): four "
       "degenerate points in one triangle, loops that touch no edge; at 4/5 the loop around "
       "(-1,-1) touches the edge y = -2.",
       xy,
       xz,
       yz,
       {{{-4, -2}, {4, -2}, {0, 5}}},
       {{{99, 100}, 2, 0}, {{9, 10}, 2, 0}, {{-9, 10}, 2, 0}, {{8, 10}, 1, 1, true}},
       {{maximum, 1, 1, 1},
        {maximum, 1, -1, -1},
        {minimum, -1, 1, -1},
        {minimum, -1, -1, 1},
        {saddle, 0, 0, 0}}});
  all.push_back({"offdiag_shifted",
                 "The same with the degenerate point (1,1) moved to the origin, where it is the "
                 "first tensor of the span itself.",
                 xy + yz + xz,
                 xz,
                 yz,
                 {{{-0.75, -0.75}, {1.5, -0.75}, {-0.75, 1.5}}},
                 {{{99, 100}, 1, 0}},
                 {{maximum, 1, 0, 0}}});
  all.push_back(
      {"ring",
       "[[1+x,y,0],[y,1-x,0],[0,0,-2]], mode a function of the radius: degenerate along "
       "the circle of radius 3, nested loops around one isolated minimum.",
       {1, 1, -2, 0, 0, 0},
       {1, -1, 0, 0, 0, 0},
       xy,
       wide,
       {{{-9, 10}, 1, 0}, {{-5, 10}, 1, 0}, {{0, 1}, 1, 0}, {{7, 10}, 2, 0}, {{9, 10}, 2, 0}},
       {{minimum, -1, 0, 0}}});
  all.push_back({"ring_threefold_weak",
                 "Ten times the ring plus a perturbation with threefold symmetry: two nested "
                 "loops below the saddle value, three separate loops above.",
                 {10, 10, -20, 0, 0, 0},
                 {10, -10, 0, 0, 0, 1},
                 {0, 0, 0, 10, -1, 0},
                 wide,
                 {{{-9, 10}, 1, 0},
                  {{0, 1}, 1, 0},
                  {{7, 10}, 2, 0},
                  {{9, 10}, 2, 0},
                  {{97, 100}, 3, 0},
                  {{99, 100}, 3, 0}},
                 {{minimum, -1, 0, 0},
                  {maximum, 1, 600.0 / 199, 0},
                  {saddle, 0.9666877288012319, -300.0 / 101, 0}}});
  all.push_back({"ring_onefold_weak",
                 "Ten times the ring, perturbed so that one maximum and one saddle remain on it.",
                 {10, 10, -20, 0, 0, 0},
                 {10, -10, 0, 0, 0, 1},
                 {0, 0, 0, 10, 1, 0},
                 wide,
                 {{{8, 10}, 2, 0}, {{99, 100}, 1, 0}},
                 {{minimum, -1, 0, 0},
                  {maximum, 1, 600.0 / 199, 0},
                  {saddle, 0.9666877288012319, -300.0 / 101, 0}}});
  all.push_back({"ring_threefold",
                 "Four times the ring plus a stronger threefold perturbation.",
                 {4, 4, -8, 0, 0, 0},
                 {4, -4, 0, 0, 0, 1},
                 {0, 0, 0, 4, -1, 0},
                 wide,
                 {{{-9, 10}, 1, 0},
                  {{0, 1}, 1, 0},
                  {{7, 10}, 2, 0},
                  {{8, 10}, 2, 0},
                  {{97, 100}, 3, 0},
                  {{99, 100}, 3, 0}},
                 {{minimum, -1, 0, 0},
                  {maximum, 1, 96.0 / 31, 0},
                  {saddle, 0.8051584150184266, -48.0 / 17, 0}}});
  all.push_back({"ring_onefold",
                 "Four times the ring plus a stronger onefold perturbation.",
                 {4, 4, -8, 0, 0, 0},
                 {4, -4, 0, 0, 0, 1},
                 {0, 0, 0, 4, 1, 0},
                 wide,
                 {{{8, 10}, 2, 0}, {{99, 100}, 1, 0}},
                 {{minimum, -1, 0, 0},
                  {maximum, 1, 96.0 / 31, 0},
                  {saddle, 0.8051584150184266, -48.0 / 17, 0}}});
  const SymmetricTensor<double> s{-1, 2, -1, 0, 1, 1}, sx{0, 1, -1, 2, 0, 1},
      sy{1, 0, -1, -1, 1, 2};
  all.push_back({"three_extrema",
                 "Three extrema, of which one is not degenerate: levels just below its mode close "
                 "up around it.",
                 s,
                 sx,
                 sy,
                 {{{-3, -3}, {3, -3}, {0, 4}}},
                 {{{84, 100}, 1, 0}, {{8, 10}, 1, 0}, {{-9, 10}, 2, 0}, {{-99, 100}, 2, 0}},
                 {{maximum, 0.8477197816983983, 0.1259440775081444, -0.3861687766788142},
                  {minimum, -1, -0.14090819612840755, 1.3991737578206975},
                  {minimum, -1, -0.5749414529468352, -1.0486793523733526},
                  {saddle, -0.39044225964418305, -8.017202251294071, 6.224345050203285},
                  {saddle, -0.415906599019654, -2.8318853013402445, -0.8951337356729927}}});
  all.push_back({"three_extrema_near_one",
                 "Ten times the same tensors on ten times the coordinates, around the extremum "
                 "that is not degenerate: its loop touches no edge.",
                 10.0 * s,
                 sx,
                 sy,
                 {{{-4, -9}, {8, -9}, {2, 3}}},
                 {{{84, 100}, 1, 0}},
                 {{maximum, 0.8477197816983983, 1.259440775081444, -3.861687766788142}}});
  all.push_back({"extremum_on_edge",
                 "Field offdiag, triangle with a degenerate point on an edge.",
                 xy,
                 xz,
                 yz,
                 {{{0, 0}, {2, 2}, {3, 0}}},
                 {{{95, 100}, 0, 1}},
                 {{maximum, 1, 1, 1}}});
  all.push_back({"tangent_edge",
                 "Field offdiag; the loop of mode 4/5 around (1,1) touches the first edge, y = 2, "
                 "at x = sqrt(5/2), a double root: no crossings above that level, two below.",
                 xy,
                 xz,
                 yz,
                 {{{-1, 2}, {6, 2}, {2, -4}}},
                 {{{81, 100}, 1, 0}, {{79, 100}, 0, 1}},
                 {{maximum, 1, 1, 1}}});
  return all;
}

}  // namespace

const std::vector<PlanarWitness>& planar_witnesses() {
  static const std::vector<PlanarWitness> all = make_planar_witnesses();
  return all;
}

}  // namespace tensortopo::test
