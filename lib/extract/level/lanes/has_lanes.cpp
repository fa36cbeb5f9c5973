// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/lanes/has_lanes.hpp"

namespace tensortopo {

bool has_lanes() {
#ifdef TENSORTOPO_FOUR_LANES
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  return has_avx2;
#else
  return false;
#endif
}

}  // namespace tensortopo
