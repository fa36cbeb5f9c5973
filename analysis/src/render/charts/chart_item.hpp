// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkContextItem.h>

#include <array>
#include <string>

class vtkContext2D;

namespace tensortopo {

namespace chart {

using Rgb = std::array<unsigned char, 3>;
inline constexpr Rgb kInk{41, 46, 54}, kPale{225, 228, 232}, kTeal{15, 148, 145},
    kGold{214, 140, 20}, kBlue{46, 98, 176}, kRed{196, 60, 60}, kViolet{128, 84, 168};

}  // namespace chart

/// What charts have in common: pens and words. For `picture_of`.
class ChartItem : public vtkContextItem {
 public:
  vtkTypeMacro(ChartItem, vtkContextItem)

 protected:
  void pen(const chart::Rgb& colour, float width, unsigned char opacity = 255);
  /// Their middle is at that height.
  void words(float x, float y, const std::string& text, int size, bool bold, int justify,
             const chart::Rgb& colour = chart::kInk);

  vtkContext2D* painter_ = nullptr;  ///< while it paints
};

}  // namespace tensortopo
