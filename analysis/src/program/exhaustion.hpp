// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

namespace tensortopo {

/// From here on a program that cannot go on (no memory for GMP, an exception where none may leave)
/// removes its unfinished files and ends with a line of ours and the status of bad input or of our
/// fault, instead of being aborted.
void prepare_for_exhaustion();

/// What the machine has too little of, if that is what the exception tells; else null.
const char* exhausted(const std::exception& error);

}  // namespace tensortopo
