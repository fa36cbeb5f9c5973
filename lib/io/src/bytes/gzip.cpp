// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/gzip.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>

#include <zlib.h>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, std::size_t count) {
  constexpr int gzip_only = 16 + MAX_WBITS;
  z_stream stream{};
  if (inflateInit2(&stream, gzip_only) != Z_OK) throw FormatError("cannot be unpacked");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
  std::string out;
  constexpr std::size_t piece = 1u << 20;
  while (out.size() < count) {
    if (bytes.empty()) return out;
    const std::size_t in = std::min(bytes.size(), piece), begin = out.size();
    out.resize(begin + std::min(count - begin, piece));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(in);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + begin);
    stream.avail_out = static_cast<uInt>(out.size() - begin);
    const int status = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    bytes.remove_prefix(in - stream.avail_in);
    if (status == Z_STREAM_END) {
      if (bytes.empty()) return out;
      if (inflateReset(&stream) != Z_OK) throw FormatError("cannot be unpacked");
    } else if (status != Z_OK) {
      throw FormatError("is damaged: what gzip packed does not unpack");
    } else if (bytes.empty() && stream.avail_out != 0) {
      throw FormatError("ends within what gzip packed");
    }
  }
  return out;
}

}  // namespace tensortopo::detail
