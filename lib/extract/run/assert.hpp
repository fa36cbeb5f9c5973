// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// \file
/// What holds between the stages, whatever the input. An assertion that fails is a mistake of ours:
/// it names the condition and ends the program. They are on in builds without NDEBUG (the preset
/// dev) and where TENSORTOPO_ASSERTIONS is defined (builds with sanitizers), else not evaluated.

#if !defined(NDEBUG) || defined(TENSORTOPO_ASSERTIONS)
#include <cstdio>
#include <cstdlib>

#define TENSORTOPO_ASSERT(condition, meaning)                                                   \
  do {                                                                                          \
    if (!(condition)) {                                                                         \
      std::fprintf(stderr, "%s:%d: broken invariant: %s (%s)\n", __FILE__, __LINE__, (meaning), \
                   #condition);                                                                 \
      std::abort();                                                                             \
    }                                                                                           \
  } while (false)
#else
#define TENSORTOPO_ASSERT(condition, meaning) \
  do {                                        \
  } while (false && (condition) && (meaning))
#endif
