// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace tensortopo::python {

/// A progress callback returned False.
class Cancelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Progress = std::function<void(std::string_view stage, double fraction)>;

/// Makes Cancelled the package's exception of that name, in the module that calls it.
void translate_cancelled();

/// Runs `work` in a thread of its own, without Python's lock.
///
/// The calling thread meanwhile handles signals, and calls `callback(stage, fraction)` with the
/// latest progress, some twenty times a second at most. A signal's exception (KeyboardInterrupt),
/// an exception in the callback and False as its answer end the work at its next report; it is
/// waited for, and then the exception, or Cancelled, is thrown.
/// @param callback  may be None
void run_watched(const pybind11::object& callback, const std::function<void(const Progress&)>& work);

/// The same with a result.
template <class Work>
auto watched(const pybind11::object& callback, const Work& work) {
  std::optional<std::invoke_result_t<Work, const Progress&>> result;
  run_watched(callback, [&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

}  // namespace tensortopo::python
