// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/encode_block.hpp"

#include <libdeflate.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <numeric>
#include <vector>

#include "bytes/to_base64.hpp"

namespace tensortopo::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written as little endian");

constexpr std::size_t kBlockSize = 1 << 16;

struct Free {
  void operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
  }
};
using DeflateCompressor = std::unique_ptr<libdeflate_compressor, Free>;

/// The largest effort is the least that finds patterns: more saves one byte in a hundred.
DeflateCompressor make_compressor(Patterns patterns) {
  DeflateCompressor compressor(libdeflate_alloc_compressor(patterns == Patterns::some ? 1 : 0));
  if (!compressor) throw std::bad_alloc();
  return compressor;
}

}  // namespace

void append_block(std::span<const std::byte> bytes, Patterns patterns, std::string& text) {
  const std::size_t count = (bytes.size() + kBlockSize - 1) / kBlockSize;
  std::vector<std::vector<std::byte>> blocks(count);
  tbb::enumerable_thread_specific<DeflateCompressor> compressors(
      [&] { return make_compressor(patterns); });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    libdeflate_compressor* const compressor = compressors.local().get();
    const auto block =
        bytes.subspan(i * kBlockSize, std::min(kBlockSize, bytes.size() - i * kBlockSize));
    blocks[i].resize(libdeflate_zlib_compress_bound(compressor, block.size()));
    blocks[i].resize(libdeflate_zlib_compress(compressor, block.data(), block.size(),
                                              blocks[i].data(), blocks[i].size()));
  });
  // How many blocks, the size of each, that of the last if it is smaller; then their compressed
  // sizes.
  std::vector<std::uint64_t> header{count, kBlockSize, bytes.size() % kBlockSize};
  for (const auto& block : blocks) header.push_back(block.size());
  std::vector<std::byte> all;
  all.reserve(std::accumulate(header.begin() + 3, header.end(), std::size_t{0}));
  for (const auto& block : blocks) all.insert(all.end(), block.begin(), block.end());
  append_base64(std::as_bytes(std::span(header)), text);
  append_base64(all, text);
}

}  // namespace tensortopo::detail
