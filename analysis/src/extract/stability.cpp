// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/stability.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_point_numbers.hpp"

namespace tensortopo {
namespace {

constexpr std::string_view kArray = "array:";

}  // namespace

std::optional<Uncertainty> requested_uncertainty(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text.starts_with(kArray)) {
    Uncertainty result;
    result.kind = Uncertainty::Kind::per_vertex;
    result.array = text.substr(kArray.size());
    if (result.array.empty()) throw UsageError("--uncertainty: array: names no array");
    return result;
  }
  try {
    return parse_uncertainty(text);
  } catch (const std::invalid_argument& problem) {
    throw UsageError(std::string("--uncertainty: ") + problem.what() +
                     ", nor array: with the name of an array of radii");
  }
}

void read_radii(const std::filesystem::path& input, const ReadOptions& options,
                const ReadResult& read, Uncertainty& uncertainty) {
  if (uncertainty.array.empty()) return;
  uncertainty.radii = read_point_numbers(input, uncertainty.array, options, read);
  for (std::size_t v = 0; v < uncertainty.radii.size(); ++v)
    if (uncertainty.radii[v] < 0)
      throw IoError(IoError::Kind::invalid, input,
                    "array `" + uncertainty.array + "`: a radius is negative (point " +
                        std::to_string(v) + ")");
  uncertainty.radii_sha256 = numbers_sha256(uncertainty.radii);
}

}  // namespace tensortopo
