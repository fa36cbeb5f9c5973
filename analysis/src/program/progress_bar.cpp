// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tensortopo {
namespace {

constexpr std::size_t kWidth = 30;
constexpr auto kInterval = std::chrono::milliseconds(80);

}  // namespace

ProgressBar::ProgressBar(bool wanted) : active_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() { erase(); }

Progress ProgressBar::callback() {
  if (!active_) return {};
  return [this](std::string_view stage, double fraction) { show(stage, fraction); };
}

void ProgressBar::erase() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

void ProgressBar::show(std::string_view stage, double fraction) {
  const auto now = std::chrono::steady_clock::now();
  const bool is_full = fraction >= 1;
  if (stage == stage_ && (is_full ? full_ : now - last_ < kInterval)) return;
  last_ = now;
  stage_ = stage;
  full_ = is_full;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(part * static_cast<double>(kWidth));
  const std::string line = fmt::format("\r\033[K[{}{}] {:3.0f} % {}", std::string(full, '#'),
                                       std::string(kWidth - full, '.'), 100 * part, stage);
  std::fputs(line.c_str(), stderr);
  shown_ = true;
}

}  // namespace tensortopo
