// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace certificate {

/// The document in JSON or CBOR: with bounded depth, and without keys given twice, which a
/// document object model would not show. Throws Malformed, without the
/// file's name.
nlohmann::json parse_strictly(const std::string& bytes, bool cbor);

}  // namespace certificate
