// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A certificate as FORMAT.md describes it.
#pragma once

#include <gmpxx.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "curves/degenerate_points.hpp"
#include "files/file.hpp"
#include "free_tets.hpp"
#include "invariant_rule.hpp"

namespace certificate {

using Json = nlohmann::json;

/// Reads a certificate, JSON or CBOR (.cbor), of bounded depth and without keys given twice. Throws
/// Malformed unless it has the keys, types, lengths and order that the format asks for; what
/// the numbers and texts say is not looked at.
Json read_document(const File& file);

/// Reads a certificate of parts (JSON) likewise.
Json read_parts_document(const File& file);
/// Is it of degenerate curves, by its mode?
bool is_of_curves(const Json& parts_document);

/// Texts and numbers of a document. These throw Malformed, without the file's name.
/// A fraction or decimal that a user writes: "1/2", "0.5", "-9/10". Nothing if it is none.
std::optional<mpq_class> number_of(const std::string& text);
mpq_class mode_of(const Json& value);      ///< in lowest terms, between -1 and 1
Kind kind_of(const Json& mode);           ///< of degenerate tensors, mode 1 or -1
Invariant invariant_of(const Json& name);
/// In lowest terms, positive, below 1 for an anisotropy.
mpq_class value_of(const Json& value, Invariant invariant);
double length_of(const Json& value);       ///< not negative, hexadecimal
/// Of the keys `radius` and `of`. Radii of an array are left to `read_radii`.
Radius radius_of(const Json& stability);
std::string reason_of(const Json& value);  ///< one of FORMAT.md's for surfaces
std::string curve_reason_of(const Json& value);  ///< one of those for curves
/// The ends of a crossing's interval [i / 2^k, (i + 1) / 2^k], in [0, 1].
struct Interval {
  mpz_class i;
  unsigned k = 0;

  mpq_class end(int which) const { return mpq_class(i + which, mpz_class(1) << k); }
};
Interval interval_of(const Json& crossing);

}  // namespace certificate
