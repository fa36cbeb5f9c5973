// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk_xml.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "certificate_check/check_certificate.hpp"
#include "document.hpp"

static_assert(std::endian::native == std::endian::little);

namespace certificate {
namespace {

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
  if (!document_.load_buffer(xml.data(), xml.size())) fail("no VTK XML file");
  const pugi::xml_node root = document_.child("VTKFile"), data = root.child(kind);
  if (root.attribute("type").value() != std::string_view(kind) || !data)
    fail(std::string("not of type ") + kind);
  const std::string order = root.attribute("byte_order").value();
  if (order != "LittleEndian" && order != "BigEndian") fail("unknown byte_order");
  highest_first_ = order == "BigEndian";
  const std::string compressor = root.attribute("compressor").value();
  zlib_ = !compressor.empty();
  if (zlib_ && compressor != "vtkZLibDataCompressor") fail("unknown compressor");
  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64") fail("unknown header_type");
  header_ = header == "UInt64" ? 8 : 4;
  appended_base64_ =
      root.child("AppendedData").attribute("encoding").value() != std::string_view("raw");
  if (appended_base64_) appended_ = trim(appended_.substr(0, appended_.find('<')));
  piece_ = data.child("Piece");
  if (!piece_ || piece_.next_sibling("Piece")) fail("not of one piece");
}

std::size_t XmlFile::count(const char* attribute) const {
  const unsigned long long n = piece_.attribute(attribute).as_ullong(0);
  if (n > bytes_.size() * 1100) fail(std::string(attribute) + " is more than the file can hold");
  return n;
}

/// The next bytes of a text; those of base64 end with a group of four characters.
std::string XmlFile::take(std::string_view& text, std::size_t size, bool base64) const {
  if (size > text.size()) fail("data that end too early");
  const std::size_t length = base64 ? (size + 2) / 3 * 4 : size;
  if (length > text.size() || length > 0x7fffffff) fail("data that end too early");
  std::string bytes(text.substr(0, length));
  text.remove_prefix(length);
  if (base64) {
    auto* place = reinterpret_cast<unsigned char*>(bytes.data());
    const std::string source = bytes;
    if (EVP_DecodeBlock(place, reinterpret_cast<const unsigned char*>(source.data()),
                        static_cast<int>(length)) != static_cast<int>(length / 4 * 3))
      fail("text that is no base64");
    bytes.resize(size);
  }
  return bytes;
}

/// The i-th number of what is stored.
template <class Stored>
Stored XmlFile::item(const std::string& bytes, std::size_t i) const {
  std::array<char, sizeof(Stored)> own;
  std::memcpy(own.data(), bytes.data() + i * sizeof(Stored), sizeof(Stored));
  if (highest_first_) std::reverse(own.begin(), own.end());
  return std::bit_cast<Stored>(own);
}

std::uint64_t XmlFile::word(const std::string& words, std::size_t i) const {
  return header_ == 8 ? item<std::uint64_t>(words, i) : item<std::uint32_t>(words, i);
}

/// Undoes base64 and compression of a block that starts with its size, or sizes.
std::string XmlFile::decode(std::string_view text, bool base64) const {
  std::string_view ahead = text;
  const std::uint64_t first = word(take(ahead, header_, base64), 0);
  if (first > text.size()) fail("data that end too early");
  // Base64 encodes the header by itself if the data are compressed, else all as one.
  if (!zlib_) return take(text, header_ + first, base64).substr(header_);
  if (first == 0) return {};
  const std::string header = take(text, (3 + first) * header_, base64);
  std::string result;
  std::uint64_t packed_size = 0;
  for (std::uint64_t i = 0; i < first; ++i) {
    if (word(header, 3 + i) > text.size()) fail("data that end too early");
    packed_size += word(header, 3 + i);
  }
  const std::string packed = take(text, packed_size, base64);
  const char* source = packed.data();
  for (std::uint64_t i = 0; i < first; ++i) {
    const std::uint64_t size = word(header, 3 + i), last = word(header, 2);
    const std::uint64_t target = i + 1 == first && last != 0 ? last : word(header, 1);
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

template <class Stored>
std::vector<double> XmlFile::read(pugi::xml_node array) const {
  std::vector<double> result;
  const std::string_view format = array.attribute("format").value();
  if (format == "ascii") {
    const char* place = array.child_value();
    for (char* end = nullptr;; place = end) {
      const double x = sizeof(Stored) == 4 && std::is_floating_point_v<Stored>
                           ? static_cast<double>(std::strtof(place, &end))
                           : std::strtod(place, &end);
      if (end == place) break;
      result.push_back(x);
    }
    if (!trim(place).empty()) fail("text that is no number");
    return result;
  }
  const unsigned long long start = array.attribute("offset").as_ullong(~0ULL);
  if (format != "binary" && start > appended_.size()) fail("an offset outside the appended data");
  const std::string bytes = format == "binary"
                                ? decode(trim(array.child_value()), true)
                                : decode(appended_.substr(start), appended_base64_);
  if (bytes.size() % sizeof(Stored) != 0) fail("an array with a part of a number");
  result.resize(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = static_cast<double>(item<Stored>(bytes, i));
  return result;
}

std::vector<std::pair<std::string, std::size_t>> XmlFile::arrays(const char* section) const {
  std::vector<std::pair<std::string, std::size_t>> result;
  for (const pugi::xml_node child : piece_.child(section).children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string name = child.attribute("Name").value();
    if (child.name() != std::string_view("DataArray") || name.empty() || name.size() > 1000)
      fail(std::string(section) + " has what is no named array of numbers");
    result.emplace_back(name, child.attribute("NumberOfComponents").as_ullong(1));
  }
  return result;
}

std::vector<double> XmlFile::numbers(const char* section, const std::string& name,
                                     std::size_t components) const {
  pugi::xml_node array;
  for (const pugi::xml_node child : piece_.child(section).children("DataArray")) {
    if (!name.empty() && child.attribute("Name").value() != name) continue;
    if (array) fail(std::string(section) + " has two arrays '" + name + "'");
    array = child;
  }
  if (!array) fail(std::string(section) + " has no array '" + name + "'");
  if (array.attribute("NumberOfComponents").as_ullong(1) != components)
    fail("an array of other than " + std::to_string(components) + " components");
  const std::string_view type = array.attribute("type").value();
  const auto result = type == "Float64"   ? read<double>(array)
                      : type == "Float32" ? read<float>(array)
                      : type == "Int64"   ? read<std::int64_t>(array)
                      : type == "Int32"   ? read<std::int32_t>(array)
                      : type == "UInt8"   ? read<std::uint8_t>(array)
                                          : std::vector<double>{HUGE_VAL};
  for (const double x : result)
    if (!std::isfinite(x)) fail("a number that is not finite, or of unknown type");
  return result;
}

std::vector<std::uint64_t> XmlFile::naturals(const char* section, const char* name) const {
  std::vector<std::uint64_t> result;
  for (const double x : numbers(section, name)) {
    if (!(x >= 0 && x < 0x1p53) || x != std::floor(x)) fail("no natural number");
    result.push_back(static_cast<std::uint64_t>(x));
  }
  return result;
}

}  // namespace certificate
