// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tensortopo {

/// Processor, number of threads in use, memory and system, as Linux tells them.
std::string machine_text();
/// The average number of processes that wanted to run in the last minute; "unknown" if not known.
std::string load_text();
/// The commit of the work tree that the running program lies in, with "-dirty" if files differ from
/// it; "unknown" outside of one.
std::string commit_text();
/// The commit and the date at which all tests have passed last in the program's build tree, as
/// `tests/run --all` writes them to `all-passed` there; "unknown" if it has not.
std::string tested_text();
/// Today, in universal time: "2026-11-23".
std::string date_text();

}  // namespace tensortopo
