// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/data_block.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

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

vtkSmartPointer<vtkDataCompressor> make_decompressor(BlockFormat::Compressor kind) {
  vtkSmartPointer<vtkDataCompressor> result;
  switch (kind) {
    case BlockFormat::Compressor::lz4:
      result = vtkSmartPointer<vtkLZ4DataCompressor>::New();
      break;
    case BlockFormat::Compressor::lzma:
      result = vtkSmartPointer<vtkLZMADataCompressor>::New();
      break;
    default:
      result = vtkSmartPointer<vtkZLibDataCompressor>::New();
  }
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

std::string decompress(std::string_view block, std::size_t expected, const BlockFormat& format) {
  Header header(block, format);
  const std::uint64_t count = header.next(), size = header.next(), last = header.next();
  if (count > block.size() / format.header_word)
    throw FormatError("promises " + std::to_string(count) +
                      " compressed blocks, more than it has room for");
  if (count == 0 || size == 0 || last > size || size > UINT64_MAX / count)
    throw FormatError("has a senseless compression header");
  const std::uint64_t total = last == 0 ? count * size : (count - 1) * size + last;
  if (total != expected) throw FormatError(wrong_size(total, expected));

  std::vector<std::uint64_t> sizes(count);
  for (auto& s : sizes) s = header.next();
  std::string_view rest = header.rest();
  const auto decompressor = make_decompressor(format.compressor);
  std::string bytes;
  // Room for all, but for no more than the block can hold.
  const std::uint64_t ratio = greatest_ratio(format.compressor);
  bytes.reserve(total / ratio > block.size() ? 0 : total);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t wanted = i + 1 == count && last != 0 ? last : size;
    if (sizes[i] > rest.size()) throw FormatError("ends within a compressed block");
    if (wanted / ratio > sizes[i] + 64)
      throw FormatError("promises more bytes than a compressed block can hold");
    const std::size_t begin = bytes.size();
    bytes.resize(begin + wanted);
    const std::size_t got =
        decompressor->Uncompress(reinterpret_cast<const unsigned char*>(rest.data()), sizes[i],
                                 reinterpret_cast<unsigned char*>(bytes.data() + begin), wanted);
    if (got != wanted) throw FormatError("has a damaged compressed block");
    rest.remove_prefix(sizes[i]);
  }
  return bytes;
}

}  // namespace

std::string decode_block(std::string_view block, std::size_t expected, const BlockFormat& format) {
  if (expected == 0) return {};
  if (format.compressor != BlockFormat::Compressor::none)
    return decompress(block, expected, format);
  Header header(block, format);
  const std::uint64_t size = header.next();
  if (size != expected) throw FormatError(wrong_size(size, expected));
  if (size > header.rest().size()) throw FormatError("ends within an array's bytes");
  return std::string(header.rest().substr(0, expected));
}

}  // namespace tensortopo::detail
