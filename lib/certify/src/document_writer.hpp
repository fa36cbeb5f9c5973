// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tensortopo/certify/certificate.hpp"

namespace tensortopo::detail {

/// Writes a document of JSON or CBOR from its beginning to its end, without holding it as a tree.
/// The bytes are those that `nlohmann::ordered_json` writes for the same document.
/// @pre of each array and object, as many members as were announced, and its `end_...`
class DocumentWriter {
 public:
  explicit DocumentWriter(CertificateEncoding encoding)
      : is_text_(encoding == CertificateEncoding::json) {}

  void array(std::size_t size) { open('[', 0x80, size); }
  void end_array() { close(']'); }
  void object(std::size_t size) { open('{', 0xA0, size); }
  void end_object() { close('}'); }

  void number(std::unsigned_integral auto x) { unsigned_number(x); }
  void number(std::signed_integral auto x) {
    if (x >= 0)
      unsigned_number(static_cast<std::uint64_t>(x));
    else
      negative_number(x);
  }
  void key(std::string_view name);
  /// A value of any kind, meant for small ones.
  void value(const nlohmann::ordered_json& json);

  /// An array with one member for each item, in parallel.
  /// @param write  writes the member of an item with the writer given
  template <class Items, class Write>
  void list(const Items& items, const Write& write) {
    constexpr std::size_t kBlock = 4096;
    const std::size_t count = std::size(items);
    std::vector<DocumentWriter> blocks((count + kBlock - 1) / kBlock, DocumentWriter(*this, 0));
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
      const std::size_t end = std::min(count, (b + 1) * kBlock);
      for (std::size_t i = b * kBlock; i < end; ++i) write(blocks[b], i);
    });
    array(count);
    for (const auto& block : blocks) {
      separate();
      bytes_ += block.bytes_;
    }
    end_array();
  }

  std::string take() { return std::move(bytes_); }

 private:
  /// With no bytes.
  DocumentWriter(const DocumentWriter& like, int) : is_text_(like.is_text_) {}

  void open(char text, std::uint8_t major, std::size_t size) {
    separate();
    if (is_text_)
      bytes_ += text;
    else
      head(major, size);
    is_first_ = true;
  }
  void close(char text) {
    if (is_text_) bytes_ += text;
    is_first_ = false;
  }
  /// Before each member.
  void separate() {
    if (is_text_ && !is_first_) bytes_ += ',';
    is_first_ = false;
  }
  void unsigned_number(std::uint64_t x);
  void negative_number(std::int64_t x);
  /// CBOR: a major type and a number.
  void head(std::uint8_t major, std::uint64_t x);

  bool is_text_;
  bool is_first_ = true;  ///< no comma before what comes next
  std::string bytes_;
};

}  // namespace tensortopo::detail
