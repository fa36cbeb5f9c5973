// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo {

/// Whether this processor, and this build, compute four at a time (AVX2). Results do not depend on
/// it.
bool has_lanes();

}  // namespace tensortopo
