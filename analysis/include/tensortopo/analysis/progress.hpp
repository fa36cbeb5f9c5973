// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace tensortopo {

/// Told now and then, by one thread at a time, what is going on and how much of it is done, in
/// [0, 1]. May be empty.
using Progress = std::function<void(std::string_view stage, double fraction)>;

}  // namespace tensortopo
