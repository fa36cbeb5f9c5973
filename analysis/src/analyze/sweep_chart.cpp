// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/sweep_chart.hpp"

#include <fmt/format.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "render/chart_item.hpp"
#include "render/context_picture.hpp"

namespace tensortopo {
namespace {

constexpr int kWidth = 1600, kHeight = 1500;
constexpr float kLeft = 150, kRight = 1560, kTop = 1430, kBottom = 190, kGap = 62, kStrip = 60;

using namespace chart;

struct Place {
  float x, y;
};

/// A quantity against the mode.
struct Panel {
  std::string title;
  Rgb colour;
  bool steps = false;  ///< known everywhere; else at the dots
  std::vector<std::vector<std::pair<double, double>>> lines;  ///< mode and value
};

template <class Value>
Panel panel(const Sweep& sweep, const std::string& title, Rgb colour, const Value& value) {
  Panel result{title, colour, false, {{}}};
  result.steps = std::all_of(sweep.intervals.begin(), sweep.intervals.end(),
                             [](const SweepInterval& i) { return i.level || i.low == i.high; });
  for (const SweepInterval& interval : sweep.intervals) {
    if (!result.steps || !interval.level) continue;
    const double y = value(sweep.levels[*interval.level]);
    result.lines[0].insert(result.lines[0].end(), {{interval.low, y}, {interval.high, y}});
  }
  if (result.steps) return result;
  for (const std::size_t i : sweep.samples)
    result.lines[0].emplace_back(sweep.levels[i].mode.approx(), value(sweep.levels[i]));
  return result;
}

std::vector<Panel> panels_of(const Sweep& sweep) {
  std::vector<Panel> panels{panel(sweep, "components", kTeal, [](const SweepLevel& l) {
    return static_cast<double>(l.components);
  })};
  Panel euler{"Euler characteristic", kBlue, true, {{}}};
  for (const SweepInterval& interval : sweep.intervals) {
    if (!interval.euler_characteristic) {
      euler.lines.emplace_back();
      continue;
    }
    const auto y = static_cast<double>(*interval.euler_characteristic);
    euler.lines.back().insert(euler.lines.back().end(), {{interval.low, y}, {interval.high, y}});
  }
  panels.push_back(std::move(euler));
  panels.push_back(panel(sweep, "boundary loops", kGold, [](const SweepLevel& l) {
    return static_cast<double>(l.boundary_loops);
  }));
  Panel area{"area", kViolet, false, {{}}};
  for (const std::size_t i : sweep.samples)
    area.lines[0].emplace_back(sweep.levels[i].mode.approx(), sweep.levels[i].area);
  panels.push_back(std::move(area));
  return panels;
}

struct Kind {
  const char* text = nullptr;
  Rgb colour{};
};

/// What the strip tells apart.
Kind kind_of(LocalChange change) {
  switch (change) {
    case LocalChange::birth:
      return {"births", kTeal};
    case LocalChange::death:
      return {"deaths", kRed};
    case LocalChange::join:
      return {"joins", kBlue};
    case LocalChange::split:
      return {"splits", kGold};
    case LocalChange::open:
    case LocalChange::close:
      return {"holes open, close", kViolet};
    default:
      return {"other, undecided", kInk};
  }
}

class Chart : public ChartItem {
 public:
  vtkTypeMacro(Chart, ChartItem) static Chart* New();

  void show(const Sweep& sweep, const SweepOptions& options) {
    sweep_ = &sweep;
    from_ = options.from.approx();
    to_ = options.to.approx();
    panels_ = panels_of(sweep);
  }

  bool Paint(vtkContext2D* painter) override {
    painter_ = painter;
    const float height = (kTop - kBottom - kStrip - kGap * static_cast<float>(panels_.size())) /
                         static_cast<float>(panels_.size());
    float top = kTop;
    for (const Panel& p : panels_) {
      paint(p, top - height, top);
      top -= height + kGap;
    }
    paint_strip(kBottom, kBottom + kStrip);
    return true;
  }

 private:
  float x_of(double mode) const {
    return kLeft + static_cast<float>((mode - from_) / (to_ - from_)) * (kRight - kLeft);
  }

  void paint(const Panel& p, float bottom, float top) {
    double low = 0, high = 0;
    bool first = true;
    for (const auto& line : p.lines)
      for (const auto& [mode, value] : line) {
        low = first ? value : std::min(low, value);
        high = first ? value : std::max(high, value);
        first = false;
      }
    const bool whole = p.title != "area";
    if (whole || low > 0) low = std::min(low, 0.0);
    if (!(high > low)) high = low + 1;
    const auto y_of = [&](double v) {
      return bottom + static_cast<float>((v - low) / (high - low)) * (top - bottom);
    };
    for (const double v : axis_ticks(low, high, 4, whole)) {
      pen(kPale, 1.5F);
      painter_->DrawLine(kLeft, y_of(v), kRight, y_of(v));
      words(kLeft - 12, y_of(v), fmt::format("{:g}", v + 0.0), 22, false, VTK_TEXT_RIGHT);
    }
    for (const auto& line : p.lines) {
      std::vector<float> places;
      for (const auto& [mode, value] : line) places.insert(places.end(), {x_of(mode), y_of(value)});
      const int count = static_cast<int>(places.size() / 2);
      if (count == 0) continue;
      pen(p.colour, p.steps ? 2.5F : 1.5F, p.steps ? 255 : 150);
      if (count > 1) painter_->DrawPoly(places.data(), count);
      if (p.steps) continue;
      pen(p.colour, 8);
      painter_->DrawPoints(places.data(), count);
    }
    words(kLeft, top + 26, p.title + (p.steps ? "" : " (at the samples)"), 24, true, VTK_TEXT_LEFT,
          p.colour);
  }

  void paint_strip(float bottom, float top) {
    std::vector<std::pair<Kind, std::size_t>> kinds;
    for (const LocalChange change : {LocalChange::birth, LocalChange::death, LocalChange::join,
                                     LocalChange::split, LocalChange::open, LocalChange::other})
      kinds.emplace_back(kind_of(change), 0);
    for (const SweepEvent& event : sweep_->events)
      for (const MeshCriticalPoint& point : event.points) {
        const Kind kind = kind_of(point.effect.change);
        for (auto& [known, count] : kinds) count += std::string_view(known.text) == kind.text;
        const float x = x_of(std::clamp((point.low + point.high) / 2, from_, to_));
        pen(kind.colour, 1.2F, sweep_->events.size() > 300 ? 110 : 220);
        painter_->DrawLine(x, bottom, x, top);
      }
    pen(kInk, 1.5F);
    painter_->DrawLine(kLeft, bottom, kRight, bottom);
    for (const double v : axis_ticks(from_, to_, 10, false)) {
      painter_->DrawLine(x_of(v), bottom - 8, x_of(v), bottom);
      words(x_of(v), bottom - 26, fmt::format("{:g}", std::abs(v) < 1e-12 ? 0 : v), 22, false,
            VTK_TEXT_CENTERED);
    }
    words((kLeft + kRight) / 2, bottom - 66, "mode", 24, true, VTK_TEXT_CENTERED);
    words(kLeft, top + 22, fmt::format("{} critical values", sweep_->events.size()), 24, true,
          VTK_TEXT_LEFT);
    float x = kLeft;
    for (const auto& [kind, count] : kinds) {
      if (count == 0) continue;
      painter_->GetBrush()->SetColor(kind.colour[0], kind.colour[1], kind.colour[2], 255);
      pen(kind.colour, 1);
      painter_->DrawRect(x, bottom - 130, 22, 22);
      const std::string text = fmt::format("{}: {}", kind.text, count);
      words(x + 32, bottom - 119, text, 22, false, VTK_TEXT_LEFT);
      x += 70 + 12.5F * static_cast<float>(text.size());
    }
  }

  const Sweep* sweep_ = nullptr;
  double from_ = -1, to_ = 1;
  std::vector<Panel> panels_;
};

vtkStandardNewMacro(Chart)

}  // namespace

std::string sweep_chart(const Sweep& sweep, const SweepOptions& options) {
  vtkNew<Chart> chart;
  chart->show(sweep, options);
  return picture_of(*chart, kWidth, kHeight);
}

}  // namespace tensortopo
