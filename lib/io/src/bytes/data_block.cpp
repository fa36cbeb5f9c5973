// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/data_block.hpp"

#include <libdeflate.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {
namespace {

/// Reads a block's header words.
class Header {
 public:
  Header(std::string_view block, const BlockFormat& format) : block_(block), format_(format) {}

  std::uint64_t next() {
    const std::size_t size = format_.header_word;
    if (block_.size() - position_ < size) throw FormatError("ends within a block's header");
    std::array<unsigned char, 8> raw{};
    std::memcpy(raw.data(), block_.data() + position_, size);
    if (format_.order == std::endian::big)
      std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    position_ += size;
    std::uint64_t word = 0;
    for (std::size_t i = size; i-- > 0;) word = word << 8 | raw[i];
    return word;
  }
  std::string_view rest() const { return block_.substr(position_); }

 private:
  std::string_view block_;
  const BlockFormat& format_;
  std::size_t position_ = 0;
};

std::string wrong_size(std::uint64_t is, std::uint64_t should) {
  return "holds " + std::to_string(is) + " bytes where " + std::to_string(should) + " belong";
}

/// Of another kind than zlib.
vtkSmartPointer<vtkDataCompressor> make_decompressor(BlockFormat::Compressor kind) {
  vtkSmartPointer<vtkDataCompressor> result;
  if (kind == BlockFormat::Compressor::lz4)
    result = vtkSmartPointer<vtkLZ4DataCompressor>::New();
  else
    result = vtkSmartPointer<vtkLZMADataCompressor>::New();
  // With a listener, an error is not printed; the number of bytes tells us all.
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  result->AddObserver(vtkCommand::ErrorEvent, silence);
  result->AddObserver(vtkCommand::WarningEvent, silence);
  return result;
}

/// The most that a compressor makes of one byte.
std::uint64_t greatest_ratio(BlockFormat::Compressor kind) {
  switch (kind) {
    case BlockFormat::Compressor::lz4:
      return 256;
    case BlockFormat::Compressor::lzma:
      return 20000;
    default:
      return 1040;
  }
}

/// Of a compressed array: the first words of its header.
struct Parts {
  std::uint64_t count, size, last;

  Parts(Header& header, std::size_t block, const BlockFormat& format)
      : count(header.next()), size(header.next()), last(header.next()) {
    if (count > block / format.header_word)
      throw FormatError("promises " + std::to_string(count) +
                        " compressed blocks, more than it has room for");
    if (count == 0 || size == 0 || last > size || size > UINT64_MAX / count)
      throw FormatError("has a senseless compression header");
  }
  std::uint64_t total() const { return last == 0 ? count * size : (count - 1) * size + last; }
};

PackedArray compressed_array(std::string_view block, std::size_t expected,
                             const BlockFormat& format) {
  Header header(block, format);
  const Parts parts(header, block.size(), format);
  if (parts.total() != expected) throw FormatError(wrong_size(parts.total(), expected));

  const auto [count, size, last] = parts;
  std::vector<std::uint64_t> sizes(count);
  for (auto& s : sizes) s = header.next();
  std::string_view rest = header.rest();
  const std::uint64_t ratio = greatest_ratio(format.compressor);
  PackedArray array{format.compressor, expected, size, {}};
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t wanted = i + 1 == count && last != 0 ? last : size;
    if (sizes[i] > rest.size()) throw FormatError("ends within a compressed block");
    if (wanted / ratio > sizes[i] + 64)
      throw FormatError("promises more bytes than a compressed block can hold");
    array.parts.push_back(rest.substr(0, sizes[i]));
    rest.remove_prefix(sizes[i]);
  }
  return array;
}

/// Unpacks parts one after the other.
class Unpacker {
 public:
  explicit Unpacker(BlockFormat::Compressor kind) {
    if (kind == BlockFormat::Compressor::zlib) {
      zlib_.reset(libdeflate_alloc_decompressor());
      if (!zlib_) throw std::bad_alloc();
    } else {
      other_ = make_decompressor(kind);
    }
  }
  /// Does the part hold exactly so many bytes?
  bool operator()(std::string_view part, std::span<std::byte> bytes) const {
    if (zlib_)
      return libdeflate_zlib_decompress(zlib_.get(), part.data(), part.size(), bytes.data(),
                                        bytes.size(), nullptr) == LIBDEFLATE_SUCCESS;
    return other_->Uncompress(reinterpret_cast<const unsigned char*>(part.data()), part.size(),
                              reinterpret_cast<unsigned char*>(bytes.data()),
                              bytes.size()) == bytes.size();
  }

 private:
  struct Free {
    void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
  };
  std::unique_ptr<libdeflate_decompressor, Free> zlib_;
  vtkSmartPointer<vtkDataCompressor> other_;
};

}  // namespace

std::uint64_t promised_size(std::string_view block, const BlockFormat& format) {
  Header header(block, format);
  return format.compressor == BlockFormat::Compressor::none
             ? header.next()
             : Parts(header, block.size(), format).total();
}

PackedArray packed_array(std::string_view block, std::size_t expected, const BlockFormat& format) {
  if (expected == 0) return {};
  if (format.compressor != BlockFormat::Compressor::none)
    return compressed_array(block, expected, format);
  Header header(block, format);
  const std::uint64_t size = header.next();
  if (size != expected) throw FormatError(wrong_size(size, expected));
  if (size > header.rest().size()) throw FormatError("ends within an array's bytes");
  return {BlockFormat::Compressor::none, expected, expected, {header.rest().substr(0, expected)}};
}

void unpack(const PackedArray& array, std::span<std::byte> bytes) {
  if (array.size == 0) return;
  if (array.compressor == BlockFormat::Compressor::none) {
    std::memcpy(bytes.data(), array.parts.front().data(), array.size);
    return;
  }
  tbb::enumerable_thread_specific<Unpacker> unpackers([&] { return Unpacker(array.compressor); });
  std::atomic<bool> is_whole{true};
  tbb::parallel_for(std::size_t{0}, array.parts.size(), [&](std::size_t i) {
    const std::size_t begin = i * array.part;
    const auto part = bytes.subspan(begin, std::min(array.part, array.size - begin));
    if (!unpackers.local()(array.parts[i], part)) is_whole = false;
  });
  if (!is_whole) throw FormatError("has a damaged compressed block");
}

}  // namespace tensortopo::detail
