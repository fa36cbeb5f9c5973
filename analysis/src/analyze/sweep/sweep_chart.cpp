// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/sweep/sweep_chart.hpp"

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
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "render/charts/chart_item.hpp"
#include "render/charts/context_picture.hpp"

namespace tensortopo {
namespace {

constexpr int kWidth = 1600, kHeight = 1760;
constexpr float kLeft = 230, kRight = 1560, kTop = 1690, kBottom = 110, kGap = 62;
constexpr float kRow = 30, kHistogram = 190;
constexpr std::size_t kBins = 100;

using namespace chart;

/// Modes from one to another, with one value.
struct Step {
  double from, to, value;
};

/// A quantity against the mode.
struct Panel {
  std::string title;
  Rgb colour;
  std::vector<std::vector<Step>> steps;         ///< runs without a gap
  std::vector<std::pair<double, double>> dots;  ///< of what changes all the time, at the samples
  bool whole = true;
};

/// What is constant between critical values, wherever it is known.
template <class Value>
Panel panel(const Sweep& sweep, const std::string& title, Rgb colour, const Value& value) {
  Panel result{title, colour, {{}}, {}};
  std::size_t count = 0, known = 0;
  for (const SweepInterval& interval : sweep.intervals) {
    if (!(interval.low < interval.high)) continue;
    ++count;
    if (const std::optional<long> here = value(interval)) {
      ++known;
      result.steps.back().push_back({interval.low, interval.high, static_cast<double>(*here)});
    } else if (!result.steps.back().empty()) {
      result.steps.emplace_back();
    }
  }
  if (known < count)
    result.title +=
        fmt::format(" (known in {} of {} ranges between critical values)", known, count);
  return result;
}

std::vector<Panel> panels_of(const Sweep& sweep) {
  const auto level = [&](const SweepInterval& interval) -> const SweepLevel* {
    if (!interval.level || sweep.levels[*interval.level].unresolved > 0) return nullptr;
    return &sweep.levels[*interval.level];
  };
  std::vector<Panel> panels{
      panel(sweep, "components", kTeal,
            [&](const SweepInterval& i) -> std::optional<long> {
              if (const SweepLevel* l = level(i)) return static_cast<long>(l->components);
              return std::nullopt;
            }),
      panel(sweep, "Euler characteristic", kBlue,
            [](const SweepInterval& i) { return i.euler_characteristic; }),
      panel(sweep, "boundary loops", kGold, [&](const SweepInterval& i) -> std::optional<long> {
        if (const SweepLevel* l = level(i)) return l->boundary_loops;
        return std::nullopt;
      })};
  Panel area{"area (at the samples)", kViolet, {}, {}, false};
  for (const std::size_t i : sweep.samples)
    area.dots.emplace_back(sweep.levels[i].mode.approx(), sweep.levels[i].area);
  panels.push_back(std::move(area));
  return panels;
}

struct Kind {
  const char* text = nullptr;
  Rgb colour{};
};

/// How the strip shows a change.
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
    sort_points();
  }

  bool Paint(vtkContext2D* painter) override {
    painter_ = painter;
    const auto rows = static_cast<float>(rows_.size()), count = static_cast<float>(panels_.size());
    const float histogram = kBottom + kRow * rows + kGap / 2;
    const float all = kTop - histogram - kHistogram - kGap * count, height = all / count;
    float top = kTop;
    for (const Panel& p : panels_) {
      paint(p, top - height, top);
      top -= height + kGap;
    }
    paint_histogram(histogram, histogram + kHistogram);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      paint_row(rows_[i], kBottom + kRow * (rows - static_cast<float>(i) - 1));
    paint_modes(kBottom);
    return true;
  }

 private:
  /// The critical points of a kind.
  struct Row {
    Kind kind;
    std::vector<double> modes;
  };

  void sort_points() {
    for (const LocalChange change : {LocalChange::birth, LocalChange::death, LocalChange::join,
                                     LocalChange::split, LocalChange::open, LocalChange::other})
      rows_.push_back({kind_of(change), {}});
    for (const SweepEvent& event : sweep_->events)
      for (const MeshCriticalPoint& point : event.points) {
        const std::string_view kind = kind_of(point.effect.change).text;
        for (Row& row : rows_)
          if (row.kind.text == kind)
            row.modes.push_back(std::clamp((point.low + point.high) / 2, from_, to_));
      }
    std::erase_if(rows_, [](const Row& row) { return row.modes.empty(); });
  }

  float x_of(double mode) const {
    return kLeft + static_cast<float>((mode - from_) / (to_ - from_)) * (kRight - kLeft);
  }

  /// Lines across at round values from `low` to `high`; returns what puts values at heights.
  auto paint_scale(double low, double high, bool whole, float bottom, float top) {
    const auto y_of = [=](double v) {
      return bottom + static_cast<float>((v - low) / (high - low)) * (top - bottom);
    };
    for (const double v : axis_ticks(low, high, 4, whole)) {
      pen(kPale, 1.5F);
      painter_->DrawLine(kLeft, y_of(v), kRight, y_of(v));
      words(kLeft - 12, y_of(v), fmt::format("{:g}", v + 0.0), 22, false, VTK_TEXT_RIGHT);
    }
    return y_of;
  }

  void paint(const Panel& p, float bottom, float top) {
    double low = 0, high = 0;
    bool first = true;
    const auto include = [&](double value) {
      low = first ? value : std::min(low, value);
      high = first ? value : std::max(high, value);
      first = false;
    };
    for (const auto& run : p.steps)
      for (const Step& step : run) include(step.value);
    for (const auto& [mode, value] : p.dots) include(value);
    if (p.whole || low > 0) low = std::min(low, 0.0);
    if (!(high > low)) high = low + 1;
    const auto y_of = paint_scale(low, high, p.whole, bottom, top);
    // Upright between two values, level along each.
    for (const auto& run : p.steps) {
      std::vector<float> places;
      for (const Step& step : run) {
        const float x = x_of(step.from), y = y_of(step.value);
        if (!places.empty()) places.insert(places.end(), {x, places.back()});
        places.insert(places.end(), {x, y, x_of(step.to), y});
      }
      if (places.empty()) continue;
      pen(p.colour, 2);
      painter_->DrawPoly(places.data(), static_cast<int>(places.size() / 2));
      // What is too short to be seen.
      pen(p.colour, 6);
      if (places[places.size() - 2] - places[0] < 6) painter_->DrawPoint(places[0], places[1]);
    }
    std::vector<float> places;
    for (const auto& [mode, value] : p.dots) places.insert(places.end(), {x_of(mode), y_of(value)});
    if (const int count = static_cast<int>(places.size() / 2); count > 0) {
      pen(p.colour, 1.5F, 150);
      if (count > 1) painter_->DrawPoly(places.data(), count);
      pen(p.colour, 7);
      painter_->DrawPoints(places.data(), count);
    }
    words(kLeft, top + 26, p.title, 24, true, VTK_TEXT_LEFT, p.colour);
  }

  /// How many critical points of which kind each hundredth of the range holds.
  void paint_histogram(float bottom, float top) {
    std::vector<std::array<std::size_t, kBins>> counts(rows_.size());
    std::array<std::size_t, kBins> sum{};
    std::size_t points = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (const double mode : rows_[i].modes) {
        const double place = (mode - from_) / (to_ - from_) * static_cast<double>(kBins);
        const std::size_t bin = std::min(static_cast<std::size_t>(place), kBins - 1);
        ++counts[i][bin];
        ++sum[bin];
        ++points;
      }
    const double high = static_cast<double>(*std::max_element(sum.begin(), sum.end()));
    const auto y_of = paint_scale(0, std::max(high, 1.0), true, bottom, top);
    const float width = (kRight - kLeft) / static_cast<float>(kBins);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      std::size_t below = 0;
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (counts[i][bin] == 0) continue;
        const float y = y_of(static_cast<double>(below));
        below += counts[i][bin];
        const Rgb& colour = rows_[i].kind.colour;
        painter_->GetBrush()->SetColor(colour[0], colour[1], colour[2], 255);
        pen(colour, 0, 0);
        painter_->DrawRect(kLeft + static_cast<float>(bin) * width + 0.5F, y, width - 1,
                           y_of(static_cast<double>(below)) - y);
      }
    }
    words(kLeft, top + 26,
          fmt::format("critical points in each {:.4g} of mode ({} points, at {} critical values)",
                      (to_ - from_) / static_cast<double>(kBins), points, sweep_->events.size()),
          24, true, VTK_TEXT_LEFT);
  }

  /// A thin line for each; where they are dense these add up.
  void paint_row(const Row& row, float bottom) {
    const Rgb& colour = row.kind.colour;
    pen(colour, 1, row.modes.size() > 200 ? 90 : row.modes.size() > 50 ? 150 : 230);
    for (const double mode : row.modes)
      painter_->DrawLine(x_of(mode), bottom + 4, x_of(mode), bottom + kRow - 4);
    pen(kPale, 1);
    painter_->DrawLine(kLeft, bottom, kRight, bottom);
    words(kLeft - 12, bottom + kRow / 2, fmt::format("{} {}", row.kind.text, row.modes.size()), 20,
          false, VTK_TEXT_RIGHT, colour);
  }

  void paint_modes(float bottom) {
    pen(kInk, 1.5F);
    painter_->DrawLine(kLeft, bottom, kRight, bottom);
    for (const double v : axis_ticks(from_, to_, 10, false)) {
      painter_->DrawLine(x_of(v), bottom - 8, x_of(v), bottom);
      words(x_of(v), bottom - 26, fmt::format("{:g}", std::abs(v) < 1e-12 ? 0 : v), 22, false,
            VTK_TEXT_CENTERED);
    }
    words((kLeft + kRight) / 2, bottom - 66, "mode", 24, true, VTK_TEXT_CENTERED);
  }

  const Sweep* sweep_ = nullptr;
  double from_ = -1, to_ = 1;
  std::vector<Panel> panels_;
  std::vector<Row> rows_;
};

vtkStandardNewMacro(Chart)

}  // namespace

std::string sweep_chart(const Sweep& sweep, const SweepOptions& options) {
  vtkNew<Chart> chart;
  chart->show(sweep, options);
  return picture_of(*chart, kWidth, kHeight);
}

}  // namespace tensortopo
