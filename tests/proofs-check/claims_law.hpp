// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tensortopo::test {

/// Wherever brute force at two resolutions agrees with itself, it agrees with what a certificate
/// claims, and the checker certifies: sheets of tetrahedra (Euler characteristic and loops),
/// crossings of edges, arcs and closed curves of faces. The tetrahedra have independent normal
/// tensors; each fifth has an isotropic vertex, around which there is a cone for each curve
/// of the face opposite.
void expect_claims_that_brute_force_sees(const std::string& mode, int count, std::uint64_t seed);

}  // namespace tensortopo::test
