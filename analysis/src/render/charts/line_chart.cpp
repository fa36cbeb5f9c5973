// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/line_chart.hpp"

#include <fmt/format.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/charts/chart_item.hpp"
#include "render/charts/context_picture.hpp"

namespace tensortopo {
namespace {

constexpr int kWidth = 1600, kHeight = 1000;
constexpr float kLeft = 170, kRight = 1250, kTop = 900, kBottom = 120;

constexpr std::array<chart::Rgb, 6> kColours{chart::kTeal, chart::kGold,   chart::kBlue,
                                             chart::kRed,  chart::kViolet, chart::Rgb{90, 98, 108}};

/// From values to pixels.
struct Axis {
  bool log = false;
  double low = 0, high = 1;
  float from = 0, to = 1;

  bool holds(double value) const { return std::isfinite(value) && (!log || value > 0); }
  float at(double value) const {
    const double v = log ? std::log10(value) : value;
    return from + static_cast<float>((v - low) / (high - low)) * (to - from);
  }
  void include(double value, bool first) {
    const double v = log ? std::log10(value) : value;
    low = first ? v : std::min(low, v);
    high = first ? v : std::max(high, v);
  }
  void widen() {
    if (log) low = std::floor(low * 3) / 3, high = std::ceil(high * 3) / 3;
    if (!log) low = std::min(low, 0.0);
    if (!(high > low)) high = low + 1;
    if (!log) high += 0.04 * (high - low);
  }
  std::vector<double> ticks() const {
    if (!log) return axis_ticks(low, high, 6, false);
    std::vector<double> values;
    const bool few = high - low < 2.5;
    for (double power = std::floor(low); power <= high; ++power)
      for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor > 1 && !few) continue;
        const double v = power + std::log10(factor);
        if (v >= low - 1e-9 && v <= high + 1e-9) values.push_back(factor * std::pow(10, power));
      }
    return values;
  }
};

class Drawing : public ChartItem {
 public:
  vtkTypeMacro(Drawing, ChartItem) static Drawing* New();

  void show(const LineChart& chart) {
    chart_ = &chart;
    x_ = {chart.log_x, 0, 1, kLeft, kRight};
    y_ = {chart.log_y, 0, 1, kBottom, kTop};
    bool first = true;
    for (const ChartLine& line : chart.lines)
      for (const auto& [x, y] : line.points) {
        if (!x_.holds(x) || !y_.holds(y)) continue;
        x_.include(x, first);
        y_.include(y, first);
        first = false;
      }
    x_.widen();
    y_.widen();
  }

  bool Paint(vtkContext2D* painter) override {
    painter_ = painter;
    paint_axes();
    float top = kTop - 10;
    for (std::size_t i = 0; i < chart_->lines.size(); ++i) {
      const chart::Rgb& colour = kColours[i % kColours.size()];
      paint(chart_->lines[i], colour);
      pen(colour, 10);
      painter_->DrawPoint(kRight + 30, top);
      words(kRight + 48, top, chart_->lines[i].name, 22, false, VTK_TEXT_LEFT, colour);
      top -= 36;
    }
    return true;
  }

 private:
  void paint_axes() {
    for (const double v : y_.ticks()) {
      pen(chart::kPale, 1.5F);
      painter_->DrawLine(kLeft, y_.at(v), kRight, y_.at(v));
      words(kLeft - 12, y_.at(v), fmt::format("{:g}", v + 0.0), 22, false, VTK_TEXT_RIGHT);
    }
    for (const double v : x_.ticks()) {
      pen(chart::kPale, 1.5F);
      painter_->DrawLine(x_.at(v), kBottom, x_.at(v), kTop);
      words(x_.at(v), kBottom - 26, fmt::format("{:g}", v + 0.0), 22, false, VTK_TEXT_CENTERED);
    }
    pen(chart::kInk, 1.5F);
    painter_->DrawLine(kLeft, kBottom, kRight, kBottom);
    painter_->DrawLine(kLeft, kBottom, kLeft, kTop);
    words((kLeft + kRight) / 2, kBottom - 72, chart_->x_title, 24, true, VTK_TEXT_CENTERED);
    words(40, kTop + 28, chart_->y_title, 24, true, VTK_TEXT_LEFT);
    words(kLeft, kTop + 70, chart_->title, 26, true, VTK_TEXT_LEFT);
  }

  void paint(const ChartLine& line, const chart::Rgb& colour) {
    std::vector<float> places;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const auto& [x, y] = line.points[i];
      if (!x_.holds(x) || !y_.holds(y)) continue;
      places.insert(places.end(), {x_.at(x), y_.at(y)});
      which.push_back(i);
    }
    const int count = static_cast<int>(which.size());
    if (count == 0) return;
    pen(colour, 2.5F);
    if (count > 1) painter_->DrawPoly(places.data(), count);
    pen(colour, 10);
    painter_->DrawPoints(places.data(), count);
    if (line.labels.size() != line.points.size()) return;
    for (std::size_t k = 0; k < which.size(); ++k)
      words(places[2 * k] + 9, places[2 * k + 1] + 15, line.labels[which[k]], 17, false,
            VTK_TEXT_LEFT, colour);
  }

  const LineChart* chart_ = nullptr;
  Axis x_, y_;
};

vtkStandardNewMacro(Drawing)

}  // namespace

std::string line_chart(const LineChart& chart) {
  vtkNew<Drawing> drawing;
  drawing->show(chart);
  return picture_of(*drawing, kWidth, kHeight);
}

}  // namespace tensortopo
