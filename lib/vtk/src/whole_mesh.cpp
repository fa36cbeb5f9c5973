// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "whole_mesh.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "tensortopo/partition/piece_border.hpp"

namespace tensortopo::filters {

namespace {

void require_expected(const WholeMesh& whole, const Ranks& ranks, std::int64_t expected) {
  if (expected == 0 || whole.tets == expected) return;
  const std::string have = ranks.are_several() ? "the ranks own " : "the field has ";
  const std::string what = whole.tets < expected ? "lost" : "added";
  throw std::runtime_error(have + std::to_string(whole.tets) + " of the " +
                           std::to_string(expected) +
                           " tetrahedra that NumberOfCells says: cells were " + what +
                           " before this filter; look at what comes before it");
}

}  // namespace

WholeMesh require_whole_mesh(const TensorGrid& grid, const Ranks& ranks, std::int64_t expected) {
  const auto& is_owned = grid.piece.is_owned;
  WholeMesh whole;
  if (!ranks.are_several()) {
    whole.tets = static_cast<std::int64_t>(is_owned.size()) -
                 std::count(is_owned.begin(), is_owned.end(), char{0});
    require_expected(whole, ranks, expected);
    return whole;
  }
  std::vector<std::int64_t> numbers;
  ranks.together([&] {
    if (!grid.has_ids && !is_owned.empty())
      throw std::runtime_error(
          "on several ranks points and cells need global ids; apply Generate Global Ids, then "
          "Ghost Cells");
    numbers = numbers_of(border_of(grid.piece));
  });
  std::vector<PieceBorder> borders;
  for (const auto& of_rank : ranks.gather(numbers)) borders.push_back(border_of_numbers(of_rank));
  whole.tets = require_one_mesh(borders);
  require_expected(whole, ranks, expected);
  for (PieceBorder& border : borders) whole.owned_ids.push_back(std::move(border.owned_ids));
  return whole;
}

}  // namespace tensortopo::filters
