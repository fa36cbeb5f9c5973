// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

class vtkContextItem;

namespace tensortopo {

/// What the item paints, in pixels on white, as the bytes of a PNG. Throws std::runtime_error if
/// there is no display (see `DisplayServer`).
std::string picture_of(vtkContextItem& item, int width, int height);

/// The round numbers of an axis, about so many, the numbers themselves whole if asked for.
std::vector<double> axis_ticks(double low, double high, int about, bool whole);

}  // namespace tensortopo
