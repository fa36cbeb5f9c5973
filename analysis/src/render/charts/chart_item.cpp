// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/chart_item.hpp"

#include <vtkContext2D.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

namespace tensortopo {

void ChartItem::pen(const chart::Rgb& colour, float width, unsigned char opacity) {
  painter_->GetPen()->SetColor(colour[0], colour[1], colour[2], opacity);
  painter_->GetPen()->SetWidth(width);
}

void ChartItem::words(float x, float y, const std::string& text, int size, bool bold, int justify,
                      const chart::Rgb& colour) {
  vtkTextProperty* const property = painter_->GetTextProp();
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetBold(bold);
  property->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  property->SetJustification(justify);
  property->SetVerticalJustificationToCentered();
  painter_->DrawString(x, y, text.c_str());
}

}  // namespace tensortopo
