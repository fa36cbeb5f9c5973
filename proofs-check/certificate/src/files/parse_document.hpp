// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Bounded readers of JSON and CBOR for what certificates hold.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace certificate {

/// Reads a document of integers, texts, booleans, nulls, arrays and objects: RFC 8259 without
/// fractions and exponents, RFC 8949 with definite lengths only. Nesting is bounded by 16, and the
/// memory of the result by 64 bytes for each byte of the file and 2^20 more. Throws Malformed,
/// without the file's name, for anything else: other types, invalid UTF-8, control
/// characters in texts, keys given twice, bytes behind the document.
nlohmann::json parse_json(std::string_view bytes);
nlohmann::json parse_cbor(std::string_view bytes);

}  // namespace certificate
