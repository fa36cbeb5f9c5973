// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tensortopo::detail {

/// How an XML file packs the bytes of its binary arrays.
struct BlockFormat {
  enum class Compressor { none, zlib, lz4, lzma };

  std::optional<std::endian> order;  ///< empty if the file does not say
  std::size_t header_word = 4;       ///< bytes of an integer in a block's header: 4 or 8
  Compressor compressor = Compressor::none;
};

/// Where the bytes of an array are in its block. Views into the block.
struct PackedArray {
  BlockFormat::Compressor compressor = BlockFormat::Compressor::none;
  std::size_t size = 0;                 ///< unpacked bytes
  std::size_t part = 0;                 ///< unpacked bytes of each part but the last
  std::vector<std::string_view> parts;  ///< compressed; of an array that is not, its bytes
};

/// How many unpacked bytes the header of a block promises, without the block being looked at.
/// Throws FormatError.
std::uint64_t promised_size(std::string_view block, const BlockFormat& format);

/// Finds the `expected` bytes of the array whose block begins at the front of `block` (which may go
/// on beyond it). Throws FormatError, also where the compressed bytes cannot be so many.
PackedArray packed_array(std::string_view block, std::size_t expected, const BlockFormat& format);

/// Unpacks an array, in parallel. Throws FormatError. @pre bytes.size() == array.size
void unpack(const PackedArray& array, std::span<std::byte> bytes);

}  // namespace tensortopo::detail
