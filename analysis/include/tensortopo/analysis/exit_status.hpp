// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo {

/// How the program ends.
enum class ExitStatus {
  done = 0,
  undecided = 1,     ///< done, but something is refuted or undecided where certainty was asked for
  bad_usage = 2,     ///< the caller's words make no sense
  bad_input = 3,     ///< a file is unreadable, wrong, or inconsistent
  cannot_write = 4,  ///< a result could not be stored
  our_fault = 70,    ///< an invariant of ours broke
};

}  // namespace tensortopo
