// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "extract/curves/curve_assembly.hpp"

namespace tensortopo {

/// The links at each place, and the curves that they make up.
class CurveGraph {
 public:
  CurveGraph(const std::vector<CurveLink>& links, std::size_t places);

  /// The links that end at a place, ascending; one that ends there twice is listed twice.
  std::span<const std::size_t> at(std::size_t place) const {
    return std::span(link_at_).subspan(first_at_[place], first_at_[place + 1] - first_at_[place]);
  }

  /// The connected components, in the order of their first links. Each begins at the lowest of its
  /// places that do not end two links, or if there is none at the lowest of all; it runs from one
  /// such place to the next, and begins anew at the lowest one left.
  std::vector<std::vector<CurveStep>> components() const;

 private:
  std::size_t place_of(const CurveStep& step) const { return links_[step.link].ends[step.from]; }
  void walk(CurveStep step, std::vector<char>& used, std::vector<CurveStep>& steps) const;
  std::vector<CurveStep> component_of(std::size_t link, std::vector<char>& used) const;

  const std::vector<CurveLink>& links_;
  std::vector<std::size_t> first_at_, link_at_;
};

}  // namespace tensortopo
