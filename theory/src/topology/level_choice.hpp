// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tensors.hpp"

namespace tensortopo::theory {

/// Parameters of modes on both sides of the critical one, at a distance from it and from 0 and 1
/// that keeps complexes small; nothing on a side that has no room for it. (A choice only: on which
/// side a parameter is, is decided by its square.)
struct LevelChoice {
  std::optional<Rational> below, above;
};

LevelChoice level_choice(const Tensor& normal, Random& random);

}  // namespace tensortopo::theory
