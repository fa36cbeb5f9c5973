// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/extract_options.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tensortopo {

namespace {

bool is_usable(double density) { return density > 0 && std::isfinite(density); }

void require_length(const char* option, std::size_t is, std::size_t tets) {
  if (is != 0 && is != tets)
    throw std::invalid_argument(std::string("options: ") + option + " has " + std::to_string(is) +
                                " entries, and the mesh " + std::to_string(tets) + " tetrahedra");
}

}  // namespace

void require_fitting(const ExtractOptions& options, std::size_t tets) {
  if (!is_usable(options.sampling.resolution))
    throw std::invalid_argument("options: resolution must be positive and finite, not " +
                                std::to_string(options.sampling.resolution));
  require_length("density", options.density.size(), tets);
  require_length("part", options.part.size(), tets);
  const auto wrong = std::find_if_not(options.density.begin(), options.density.end(),
                                      [](float density) { return is_usable(density); });
  if (wrong != options.density.end())
    throw std::invalid_argument("options: density must be positive and finite, not " +
                                std::to_string(*wrong) + " (tetrahedron " +
                                std::to_string(wrong - options.density.begin()) + ")");
}

}  // namespace tensortopo
