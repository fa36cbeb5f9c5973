// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tensortopo {

/// A quantity against another at some places, in order.
struct ChartLine {
  std::string name;
  std::vector<std::pair<double, double>> points;
  std::vector<std::string> labels;  ///< written beside the points; empty or one for each
};

struct LineChart {
  std::string title, x_title, y_title;
  bool log_x = true, log_y = true;  ///< logarithmic: values that are not positive are left out
  std::vector<ChartLine> lines;     ///< distinguished by up to six colours
};

/// Dots joined by lines, with a legend, as the bytes of a PNG of 1600 x 1000 pixels. Throws
/// std::runtime_error if there is no display (see `DisplayServer`).
std::string line_chart(const LineChart& chart);

}  // namespace tensortopo
