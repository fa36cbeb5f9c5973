// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Alters certificates as documents, not as bytes: libFuzzer's own changes of bytes seldom leave one
// that can be read. For the reader TENSORTOPO_READER, whose name ends in "cbor" if it takes CBOR.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string_view>
#include <vector>

#include "proofs-check/forgeries/certificate_edits.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Json = nlohmann::json;
constexpr bool is_cbor = std::string_view(TENSORTOPO_READER).ends_with("cbor");

/// Discarded if it is none.
Json document_of(const std::uint8_t* data, std::size_t size) {
  try {
    return is_cbor ? Json::from_cbor(data, data + size, true, false)
                   : Json::parse(data, data + size, nullptr, false);
  } catch (const Json::exception&) {  // of sizes that no memory holds
    return Json(Json::value_t::discarded);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  std::mt19937_64 random(seed);
  if (random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
  Json document = document_of(data, size);
  const auto places = tensortopo::test::places_in(document);
  if (document.is_discarded() || places.empty()) return LLVMFuzzerMutate(data, size, most);
  for (std::size_t k = random() % 4 == 0 ? 3 : 1; k > 0; --k)
    tensortopo::test::edit_document(document, places, random);
  std::vector<std::uint8_t> bytes;
  if (is_cbor) {
    bytes = Json::to_cbor(document);
  } else {
    const std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
    bytes.assign(text.begin(), text.end());
  }
  if (bytes.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}
