// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tensortopo::detail {

/// How an XML file packs the bytes of its binary arrays.
struct BlockFormat {
  enum class Compressor { none, zlib, lz4, lzma };

  std::optional<std::endian> order;  ///< empty if the file does not say
  std::size_t header_word = 4;  ///< bytes of an integer in a block's header: 4 or 8
  Compressor compressor = Compressor::none;
};

/// The `expected` bytes of the array whose block begins at the front of `block` (which may go on
/// beyond it). Nothing is allocated that the compressed bytes could not fill. Throws FormatError.
std::string decode_block(std::string_view block, std::size_t expected, const BlockFormat& format);

}  // namespace tensortopo::detail
