// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "data_arrays.hpp"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>

#include "file_bytes.hpp"
#include "certificate_check/check_certificate.hpp"

static_assert(std::endian::native == std::endian::little);

namespace certificate {
namespace {

int digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Bytes as base64 gives them, part after part: each part may end in padding.
class Base64 {
 public:
  explicit Base64(std::string_view text) : text_(text) {}

  /// The next bytes, or fewer where the text ends.
  std::string next(std::size_t count) {
    std::string bytes;
    for (; bytes.size() < count && place_ + 4 <= text_.size(); place_ += 4) {
      std::uint32_t group = 0;
      int padding = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const char c = text_[place_ + i];
        const int d = digit(c);
        if (c == '=' && i >= 2) {
          ++padding;
        } else if (d < 0 || padding > 0) {
          return bytes;
        }
        group = group << 6 | static_cast<std::uint32_t>(d < 0 ? 0 : d);
      }
      for (int i = 0; i < 3 - padding; ++i)
        bytes += static_cast<char>(group >> (16 - 8 * i) & 255U);
    }
    if (bytes.size() > count) bytes.resize(count);
    return bytes;
  }

 private:
  std::string_view text_;
  std::size_t place_ = 0;
};

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

void XmlFile::fail(const std::string& what) const { throw Malformed(file_, what); }

XmlFile::XmlFile(const std::string& file, const char* kind)
    : file_(file), bytes_(file_bytes(file)) {
  // The appended bytes are no XML: from the underscore on they are cut off.
  std::string xml = bytes_;
  if (const std::size_t tag = bytes_.find("<AppendedData"); tag != std::string::npos) {
    const std::size_t open = bytes_.find('>', tag);
    const std::size_t start = open == std::string::npos ? open : bytes_.find('_', open);
    if (start == std::string::npos) fail("AppendedData without data");
    appended_ = std::string_view(bytes_).substr(start + 1);
    xml = bytes_.substr(0, open) + "/></VTKFile>";
  }
  if (!document_.load_buffer(xml.data(), xml.size())) fail("not well-formed XML");
  const pugi::xml_node root = document_.child("VTKFile"), data = root.child(kind);
  if (root.attribute("type").value() != std::string_view(kind) || !data)
    fail(std::string("not of type ") + kind);
  if (root.attribute("byte_order").value() != std::string_view("LittleEndian"))
    fail("not little-endian");
  const std::string compressor = root.attribute("compressor").value();
  zlib_ = !compressor.empty();
  if (zlib_ && compressor != "vtkZLibDataCompressor") fail("unknown compressor");
  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64") fail("unknown header_type");
  header_ = header == "UInt64" ? 8 : 4;
  appended_base64_ =
      root.child("AppendedData").attribute("encoding").value() != std::string_view("raw");
  if (appended_base64_) {
    const std::size_t end = appended_.find('<');
    appended_ = trim(appended_.substr(0, end));
  }
  piece_ = data.child("Piece");
  if (!piece_ || piece_.next_sibling("Piece")) fail("not of one piece");
}

std::size_t XmlFile::count(const char* attribute) const {
  const unsigned long long n = piece_.attribute(attribute).as_ullong(0);
  if (n > bytes_.size() * 1100) fail(std::string(attribute) + " is more than the file can hold");
  return n;
}

pugi::xml_node XmlFile::array(const char* section, const std::string& name) const {
  pugi::xml_node found;
  for (const pugi::xml_node child : piece_.child(section).children("DataArray")) {
    if (child.attribute("Name").value() != name) continue;
    if (found) fail("two arrays are called '" + name + "'");
    found = child;
  }
  if (!found) fail(std::string(section) + " has no array '" + name + "'");
  return found;
}

pugi::xml_node XmlFile::array(const char* section) const {
  const pugi::xml_node found = piece_.child(section).child("DataArray");
  if (!found || found.next_sibling("DataArray"))
    fail(std::string(section) + " has not one array");
  return found;
}

/// Undoes base64 and compression of a block that starts with its size, or sizes.
std::string XmlFile::decode(std::string_view text, bool base64) const {
  Base64 decoder(text);
  const auto take = [&](std::size_t size) {
    std::string part;
    if (size > text.size()) fail("data that end too early");
    if (base64) {
      part = decoder.next(size);
    } else {
      part = std::string(text.substr(0, size));
      text.remove_prefix(part.size());
    }
    if (part.size() != size) fail("data that end too early");
    return part;
  };
  const auto word = [&](const std::string& words, std::size_t i) {
    std::uint64_t value = 0;
    std::memcpy(&value, words.data() + i * header_, header_);
    return value;
  };
  // A base64 text encodes the header by itself if the data are compressed, else all as one.
  if (!zlib_) {
    if (!base64) return take(word(take(header_), 0));
    const std::string all = decoder.next(text.size());
    if (all.size() < header_) fail("data that end too early");
    const std::uint64_t size = word(all, 0);
    if (size > all.size() - header_) fail("data that end too early");
    return all.substr(header_, size);
  }
  Base64 first(text);
  const std::string count = base64 ? first.next(header_) : std::string(text.substr(0, header_));
  if (count.size() != header_) fail("data that end too early");
  const std::uint64_t blocks = word(count, 0);
  if (blocks > text.size()) fail("data that end too early");
  const std::string header = take((3 + blocks) * header_);
  const std::uint64_t full = word(header, 1), last = word(header, 2);
  std::string packed, result;
  std::uint64_t packed_size = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    if (word(header, 3 + i) > text.size()) fail("data that end too early");
    packed_size += word(header, 3 + i);
  }
  packed = take(packed_size);
  const char* source = packed.data();
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t size = word(header, 3 + i);
    const std::uint64_t target = i + 1 == blocks && last != 0 ? last : full;
    if (target / 1100 > size) fail("a block that cannot hold so much");  // zlib: at most 1032:1
    const std::size_t before = result.size();
    result.resize(before + target);
    uLongf produced = target;
    if (uncompress(reinterpret_cast<Bytef*>(result.data() + before), &produced,
                   reinterpret_cast<const Bytef*>(source), size) != Z_OK ||
        produced != target)
      fail("a block that does not decompress");
    source += size;
  }
  return result;
}

std::string XmlFile::block(pugi::xml_node array) const {
  if (array.attribute("format").value() == std::string_view("binary"))
    return decode(trim(array.child_value()), true);
  const pugi::xml_attribute offset = array.attribute("offset");
  const unsigned long long start = offset.as_ullong(~0ULL);
  if (!offset || start > appended_.size()) fail("an offset outside the appended data");
  return decode(appended_.substr(start), appended_base64_);
}

template <class Result, class Convert>
std::vector<Result> XmlFile::numbers(pugi::xml_node array, const Convert& convert) const {
  std::vector<Result> result;
  const std::string type = array.attribute("type").value();
  const auto as = [&]<class Stored>(Stored) {
    if (array.attribute("format").value() == std::string_view("ascii")) {
      const std::string text(array.child_value());
      const char* place = text.c_str();
      for (char* end = nullptr;; place = end) {
        const bool real = std::is_floating_point_v<Stored>;
        const double d = real ? (sizeof(Stored) == 4 ? static_cast<double>(std::strtof(place, &end))
                                                     : std::strtod(place, &end))
                              : 0;
        const long long i = real ? 0 : std::strtoll(place, &end, 10);
        if (end == place) break;
        if (!real && static_cast<long long>(static_cast<Stored>(i)) != i) fail("an overflow");
        result.push_back(convert(real ? static_cast<Stored>(d) : static_cast<Stored>(i)));
      }
      if (!trim(place).empty()) fail("text that is no number");
      return;
    }
    const std::string bytes = block(array);
    if (bytes.size() % sizeof(Stored) != 0) fail("an array with a part of a number");
    result.reserve(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Stored)) {
      Stored value;
      std::memcpy(&value, bytes.data() + i, sizeof(Stored));
      result.push_back(convert(value));
    }
  };
  if (type == "Float64") as(double{});
  else if (type == "Float32") as(float{});
  else if (type == "Int64") as(std::int64_t{});
  else if (type == "Int32") as(std::int32_t{});
  else if (type == "UInt8") as(std::uint8_t{});
  else fail("numbers of type '" + type + "'");
  return result;
}

std::vector<double> XmlFile::reals(pugi::xml_node array, std::size_t components) const {
  if (array.attribute("NumberOfComponents").as_ullong(1) != components)
    fail("an array of other than " + std::to_string(components) + " components");
  const auto result =
      numbers<double>(array, [](auto value) { return static_cast<double>(value); });
  for (const double x : result)
    if (!std::isfinite(x)) fail("a number that is not finite");
  return result;
}

std::vector<std::uint64_t> XmlFile::naturals(pugi::xml_node array) const {
  return numbers<std::uint64_t>(array, [&](auto value) {
    if (!std::is_integral_v<decltype(value)> || !(value >= 0)) fail("not a natural number");
    return static_cast<std::uint64_t>(value);
  });
}

}  // namespace certificate
