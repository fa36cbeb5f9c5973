// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo {

/// Gives back the memory of what nobody reads any more. (`vector = {}` would keep the room.)
template <class... Values>
void release(Values&... values) {
  ((values = Values()), ...);
}

}  // namespace tensortopo
