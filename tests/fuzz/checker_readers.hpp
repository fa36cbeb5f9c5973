// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "readers.hpp"

namespace tensortopo::test {

/// Those of the checker of certificates.
std::vector<FuzzedReader> checker_readers();

}  // namespace tensortopo::test
