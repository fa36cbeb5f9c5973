// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/output/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tensortopo {
namespace {

constexpr std::size_t kWidth = 30;
constexpr auto kInterval = std::chrono::milliseconds(80);
constexpr auto kLineInterval = std::chrono::seconds(60);

bool is_terminal_with_escapes() {
  const char* const type = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && type != nullptr && std::string_view(type) != "dumb";
}

}  // namespace

std::string TimeLeft::after(double fraction, double seconds) {
  while (past_.size() > 1 && past_[1].seconds <= seconds / 2) past_.pop_front();
  const Moment then = past_.front();
  if (seconds >= past_.back().seconds + std::max(0.5, seconds / 64))
    past_.push_back({fraction, seconds});
  const double pace = (fraction - then.fraction) / (seconds - then.seconds);
  if (seconds < 3 || fraction < 0.02 || fraction >= 1 || !(pace > 0)) return "";
  const double left = (1 - fraction) / pace;
  // Hardly anything was done lately: that says nothing of the rest.
  if (left > 100 * seconds) return "";
  if (left < 90) return fmt::format(" ({:.0f} s left)", std::max(1.0, left));
  if (left < 90 * 60) return fmt::format(" ({:.0f} min left)", left / 60);
  return fmt::format(" ({:.0f} h left)", left / 3600);
}

ProgressBar::ProgressBar(bool wanted)
    : kind_(!wanted                      ? Kind::silent
            : is_terminal_with_escapes() ? Kind::bar
                                         : Kind::lines),
      next_line_(kLineInterval) {}

ProgressBar::~ProgressBar() { erase(); }

Progress ProgressBar::callback() {
  if (kind_ == Kind::silent) return {};
  return [this](std::string_view stage, double fraction) { show(stage, fraction); };
}

void ProgressBar::erase() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

void ProgressBar::show(std::string_view stage, double fraction) {
  const auto now = Clock::now();
  const double part = std::clamp(fraction, 0.0, 1.0);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (kind_ == Kind::lines) return show_line(stage, part, seconds);
  const bool is_full = fraction >= 1;
  if (stage == stage_ && (is_full ? full_ : now - last_ < kInterval)) return;
  last_ = now;
  stage_ = stage;
  full_ = is_full;
  const auto full = static_cast<std::size_t>(part * static_cast<double>(kWidth));
  const std::string line =
      fmt::format("\r\033[K[{}{}] {:3.0f} % {}{}", std::string(full, '#'),
                  std::string(kWidth - full, '.'), 100 * part, stage, left_.after(part, seconds));
  std::fputs(line.c_str(), stderr);
  shown_ = true;
}

void ProgressBar::show_line(std::string_view stage, double fraction, double seconds) {
  if (seconds < static_cast<double>(next_line_.count())) return;
  next_line_ = std::chrono::seconds(static_cast<long>(seconds)) + kLineInterval;
  std::fputs(fmt::format("tensortopo: {:.0f} %, {}{}\n", std::floor(100 * fraction), stage,
                         left_.after(fraction, seconds))
                 .c_str(),
             stderr);
}

}  // namespace tensortopo
