// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "readers.hpp"

namespace tensortopo::test {

/// The whole checker on certificates about the fields and outputs in the folder `certified`. What
/// it certifies must say what the honest certificate in the corpus says, or less.
std::vector<FuzzedReader> certified_readers();

}  // namespace tensortopo::test
