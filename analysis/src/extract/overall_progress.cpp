// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/overall_progress.hpp"

#include <algorithm>
#include <utility>

namespace tensortopo {
namespace {

/// Reading and writing have a twentieth each.
constexpr double kOutside = 0.05;

/// Where a stage ends in its extraction.
double end_of(std::string_view stage, double reached) {
  constexpr std::pair<std::string_view, double> kEnds[]{
      {"vertices", 0.05}, {"screen", 0.1},     {"edges", 0.2},       {"faces", 0.35},
      {"tetrahedra", 0.9}, {"stitch", 0.95}, {"certificate", 1.0}};
  for (const auto& [name, end] : kEnds)
    if (name == stage && end > reached) return end;
  return std::min(1.0, reached + 0.5 * (1 - reached));
}

}  // namespace

void OverallProgress::begin(std::string label) {
  if (std::exchange(begun_, true)) ++done_;
  label_ = std::move(label);
  stage_.clear();
  from_ = to_ = reached_ = last_ = 0;
}

void OverallProgress::operator()(std::string_view stage, double fraction) {
  if (!progress_) return;
  fraction = std::clamp(fraction, 0.0, 1.0);
  const bool is_new = stage_ != stage;
  if (is_new || fraction < last_ - 0.5) {
    from_ = reached_;
    const double end = end_of(stage, reached_);
    // The first pass of several: leave the other half.
    to_ = from_ + (stage == "tetrahedra" ? 0.5 : 1.0) * (end - from_);
    stage_ = stage;
  }
  last_ = fraction;
  reached_ = std::max(reached_, from_ + fraction * (to_ - from_));
  const double all = (static_cast<double>(done_) + reached_) / static_cast<double>(extractions_);
  progress_(label_ + stage_, kOutside + (1 - 2 * kOutside) * std::min(all, 1.0));
}

void OverallProgress::finish(std::string_view stage) const {
  if (progress_) progress_(stage, 1 - kOutside);
}

}  // namespace tensortopo
