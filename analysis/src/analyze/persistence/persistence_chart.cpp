// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/persistence/persistence_chart.hpp"

#include <fmt/format.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "render/charts/chart_item.hpp"
#include "render/charts/context_picture.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

constexpr int kPictureWidth = 1800, kPictureHeight = 2420;
constexpr std::array<float, 2> kColumnLeft{140, 1040},
    kColumnRight{860, 1760};  // of the two columns
constexpr float kDiagramTop = 2260, kDiagramBottom = 1540;
constexpr float kBarcodeTop = 1400, kBarcodeBottom = 730;
constexpr float kBettiTop = 560, kBettiBottom = 110;
constexpr std::size_t kMostBars = 220;
constexpr std::array kNoiseLines{0.001, 0.01, 0.1};

using namespace chart;

Rgb colour_of(PairKind kind) {
  if (kind == PairKind::superlevel) return kTeal;
  return kind == PairKind::sublevel ? kGold : kInk;
}

/// A scale of values from -most to most.
struct Scale {
  const char* name;
  double most;
  double (*of_mode)(double);
};

double degrees(double mode) { return signed_lode_angle(mode) * 180 / std::numbers::pi; }

constexpr std::array<Scale, 2> kScales{
    {{"mode", 1, [](double m) { return m; }}, {"signed Lode angle (degrees)", 30, degrees}}};

class PairsChart : public ChartItem {
 public:
  vtkTypeMacro(PairsChart, ChartItem) static PairsChart* New();

  void show(const std::vector<PersistencePair>& pairs, const ModeHomology& homology) {
    homology_ = &homology;
    for (const PersistencePair& pair : pairs) {
      if (pair.has_death || pair.is_lasting) pairs_.push_back(&pair);
      ++count_[static_cast<std::size_t>(pair.dimension)];
    }
    all_ = pairs.size();
    std::stable_sort(pairs_.begin(), pairs_.end(), [](const auto* a, const auto* b) {
      return angle_persistence(*a) > angle_persistence(*b);
    });
  }

  bool Paint(vtkContext2D* painter) override {
    painter_ = painter;
    words(kColumnLeft[0], kPictureHeight - 40,
          fmt::format("Persistence of the mode: {} pairs{}", all_,
                      all_ > pairs_.size()
                          ? fmt::format(", {} of them without a known death", all_ - pairs_.size())
                          : ""),
          30, true, VTK_TEXT_LEFT);
    float x = kColumnLeft[0];
    for (const PairKind kind : {PairKind::superlevel, PairKind::sublevel, PairKind::extended}) {
      words(x, kPictureHeight - 80, std::string(name_of(kind)), 24, true, VTK_TEXT_LEFT,
            colour_of(kind));
      x += 180;
    }
    x = kColumnLeft[1];
    for (int dimension = 0; dimension < 3; ++dimension) {
      mark(dimension, kInk, 10, x, kPictureHeight - 80);
      words(x + 20, kPictureHeight - 80,
            fmt::format(
                "{} {}", count_[static_cast<std::size_t>(dimension)],
                std::array{"components", "loops", "voids"}[static_cast<std::size_t>(dimension)]),
            24, false, VTK_TEXT_LEFT);
      x += 260;
    }
    words(kColumnRight[1], kPictureHeight - 40, "large: degenerate curves", 24, false,
          VTK_TEXT_RIGHT);
    for (std::size_t i = 0; i < 2; ++i) {
      paint_diagram(kScales[i], kColumnLeft[i], kColumnRight[i]);
      paint_bars(kScales[i], kColumnLeft[i], kColumnRight[i]);
      paint_betti(i, kColumnLeft[i], kColumnRight[i]);
    }
    return true;
  }

 private:
  static float place(const Scale& scale, double value, float from, float to) {
    return from + static_cast<float>((value + scale.most) / (2 * scale.most)) * (to - from);
  }

  void paint_axis(const Scale& scale, float left, float right, float bottom, float top,
                  const std::string& title) {
    for (const double v : axis_ticks(-scale.most, scale.most, 8, false)) {
      const float x = place(scale, v, left, right);
      pen(kPale, 1.5F);
      painter_->DrawLine(x, bottom, x, top);
      words(x, bottom - 22, fmt::format("{:g}", std::abs(v) < 1e-12 ? 0 : v), 20, false,
            VTK_TEXT_CENTERED);
    }
    words((left + right) / 2, bottom - 58, title, 22, true, VTK_TEXT_CENTERED);
  }

  void paint_diagram(const Scale& scale, float left, float right) {
    const auto x_of = [&](double v) { return place(scale, v, left, right); };
    const auto y_of = [&](double v) { return place(scale, v, kDiagramBottom, kDiagramTop); };
    words(left, kDiagramTop + 28, "diagram", 24, true, VTK_TEXT_LEFT);
    paint_axis(scale, left, right, kDiagramBottom, kDiagramTop,
               std::string("birth: ") + scale.name);
    for (const double v : axis_ticks(-scale.most, scale.most, 8, false)) {
      pen(kPale, 1.5F);
      painter_->DrawLine(left, y_of(v), right, y_of(v));
      words(left - 12, y_of(v), fmt::format("{:g}", std::abs(v) < 1e-12 ? 0 : v), 20, false,
            VTK_TEXT_RIGHT);
    }
    words(left - 12, kDiagramTop + 28, "death", 22, true, VTK_TEXT_RIGHT);
    pen(kInk, 1.5F);
    painter_->DrawLine(left, kDiagramBottom, right, kDiagramTop);
    if (scale.most > 1) paint_noise(scale, left, right);
    // The least persistent ones first: the others lie on top.
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      const PersistencePair& pair = *pairs_[i];
      mark(pair.dimension, colour_of(pair.kind), pair.curve ? 11 : 6,
           x_of(scale.of_mode(pair.birth.middle())), y_of(scale.of_mode(pair.death.middle())));
    }
  }

  /// A dot, cross or square, by dimension.
  void mark(int dimension, Rgb colour, float size, float x, float y) {
    if (dimension == 0) {
      pen(colour, size, 170);
      painter_->DrawPoint(x, y);
      return;
    }
    const float r = size * 0.8F;
    pen(colour, 2, 220);
    if (dimension == 1) {
      painter_->DrawLine(x - r, y - r, x + r, y + r);
      painter_->DrawLine(x - r, y + r, x + r, y - r);
      return;
    }
    for (const float sign : {-1.0F, 1.0F}) {
      painter_->DrawLine(x - r, y + sign * r, x + r, y + sign * r);
      painter_->DrawLine(x + sign * r, y - r, x + sign * r, y + r);
    }
  }

  /// Beside the diagonal: what lies outside survives so much relative noise.
  void paint_noise(const Scale& scale, float left, float right) {
    for (const double r : kNoiseLines) {
      const double shift = 2 * elementary::asin(r) * 180 / std::numbers::pi;
      pen(kViolet, 1.5F, 150);
      for (const double sign : {1.0, -1.0}) {
        const double from = -scale.most + (sign > 0 ? 0 : shift);
        const double to = scale.most - (sign > 0 ? shift : 0);
        painter_->DrawLine(place(scale, from, left, right),
                           place(scale, from + sign * shift, kDiagramBottom, kDiagramTop),
                           place(scale, to, left, right),
                           place(scale, to + sign * shift, kDiagramBottom, kDiagramTop));
      }
      if (shift < 5) continue;
      words(place(scale, 0, left, right), place(scale, shift, kDiagramBottom, kDiagramTop) + 24,
            fmt::format("noise {:g}", r), 20, false, VTK_TEXT_RIGHT, kViolet);
    }
  }

  void paint_bars(const Scale& scale, float left, float right) {
    const std::size_t count = std::min(pairs_.size(), kMostBars);
    words(left, kBarcodeTop + 28,
          count < pairs_.size() ? fmt::format("barcode: the {} most persistent pairs", count)
                                : std::string("barcode"),
          24, true, VTK_TEXT_LEFT);
    paint_axis(scale, left, right, kBarcodeBottom, kBarcodeTop, scale.name);
    const float step = (kBarcodeTop - kBarcodeBottom) / static_cast<float>(std::max(count, 12UL));
    for (std::size_t i = 0; i < count; ++i) {
      const PersistencePair& pair = *pairs_[i];
      const float y = kBarcodeTop - (static_cast<float>(i) + 0.5F) * step;
      pen(colour_of(pair.kind), std::clamp(0.6F * step, 1.2F, 10.0F));
      constexpr std::array kLines{vtkPen::SOLID_LINE, vtkPen::DASH_LINE, vtkPen::DOT_LINE};
      painter_->GetPen()->SetLineType(kLines[static_cast<std::size_t>(pair.dimension)]);
      painter_->DrawLine(place(scale, scale.of_mode(pair.birth.middle()), left, right), y,
                         place(scale, scale.of_mode(pair.death.middle()), left, right), y);
    }
    painter_->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  }

  /// The numbers of components, loops and voids against the mode, where they are known.
  void paint_betti(std::size_t side, float left, float right) {
    const auto& intervals = homology_->betti[side];
    long most = 1;
    for (const BettiInterval& interval : intervals)
      for (const auto& number : interval.betti) most = std::max(most, number.value_or(0));
    const auto y_of = [&](double n) {
      return kBettiBottom +
             static_cast<float>(n / static_cast<double>(most)) * (kBettiTop - kBettiBottom);
    };
    words(left, kBettiTop + 28, fmt::format("{{mode {} m}}", side == 0 ? ">=" : "<="), 24, true,
          VTK_TEXT_LEFT);
    const Scale& scale = kScales[1];
    paint_axis(scale, left, right, kBettiBottom, kBettiTop, std::string("m: ") + scale.name);
    for (const double n : axis_ticks(0, static_cast<double>(most), 6, true)) {
      if (n > static_cast<double>(most)) continue;
      pen(kPale, 1.5F);
      painter_->DrawLine(left, y_of(n), right, y_of(n));
      words(left - 12, y_of(n), fmt::format("{:g}", n), 20, false, VTK_TEXT_RIGHT);
    }
    constexpr std::array kColours{kInk, kBlue, kRed};
    for (std::size_t k = 0; k < 3; ++k) {
      bool is_known = false;
      std::optional<std::array<float, 2>> last;
      for (const BettiInterval& interval : intervals) {
        if (!interval.betti[k]) {
          last.reset();
          continue;
        }
        const float from = place(scale, scale.of_mode(interval.low), left, right);
        const float to = place(scale, scale.of_mode(interval.high), left, right);
        const float level = y_of(static_cast<double>(*interval.betti[k]));
        pen(kColours[k], 3);
        if (last) painter_->DrawLine((*last)[0], (*last)[1], from, level);
        painter_->DrawLine(from, level, to, level);
        last = {to, level};
        is_known = true;
      }
      words(right - 540 + 210 * static_cast<float>(k), kBettiTop + 28,
            fmt::format("{}{}", kFeatureNames[k], is_known ? "" : ": ?"), 24, true, VTK_TEXT_LEFT,
            kColours[k]);
    }
  }

  const ModeHomology* homology_ = nullptr;
  std::vector<const PersistencePair*> pairs_;  ///< with a known end, the longest first
  std::size_t all_ = 0;
  std::array<std::size_t, 3> count_{};  ///< by dimension
};

vtkStandardNewMacro(PairsChart)

}  // namespace

std::string persistence_chart(const std::vector<PersistencePair>& pairs,
                              const ModeHomology& homology) {
  vtkNew<PairsChart> chart;
  chart->show(pairs, homology);
  return picture_of(*chart, kPictureWidth, kPictureHeight);
}

}  // namespace tensortopo
