// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <vector>

namespace tensortopo::test {

/// Where the values of a document are, but for the document itself.
std::vector<nlohmann::json::json_pointer> places_in(const nlohmann::json& document);

/// One change of the document at one of the places, or none; which one is up to chance. Keys of
/// objects stay.
void edit_document(nlohmann::json& document,
                   const std::vector<nlohmann::json::json_pointer>& places,
                   std::mt19937_64& random);

/// Do the two certificates say the same, or the second one less, or the same otherwise? A
/// distance may be claimed with other reaches, a larger bound or more coarse tetrahedra, or not at
/// all; isotopy of fewer tetrahedra; a crossing by a wider or narrower interval; and a surface
/// without crossings may be that of another value: such claims may be true as well.
bool may_be_true(const nlohmann::json& honest, const nlohmann::json& altered);

/// Do the two certificates say the same, but for boxes that may hold the same points?
bool may_be_true_of_curves(const nlohmann::json& honest, const nlohmann::json& altered);

}  // namespace tensortopo::test
