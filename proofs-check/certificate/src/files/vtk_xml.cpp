// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/vtk_xml.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <system_error>

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"
#include "files/grid.hpp"
#include "files/word_number.hpp"
#include "run/parallel.hpp"

static_assert(std::endian::native == std::endian::little);

namespace certificate {
namespace {

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// The numbers of a text, each a word. False if a word is none.
template <class Stored>
bool read_words(std::string_view text, std::vector<double>& numbers) {
  constexpr std::string_view kSpaces = " \t\r\n";
  for (;;) {
    const std::size_t first = text.find_first_not_of(kSpaces);
    if (first == std::string_view::npos) return true;
    text.remove_prefix(first);
    const std::string_view word = text.substr(0, text.find_first_of(kSpaces));
    text.remove_prefix(word.size());
    const auto number = number_of_word<Stored>(word);
    if (!number) return false;
    numbers.push_back(*number);
  }
}

}  // namespace

void XmlFile::fail(const std::string& what) const { throw Malformed(file_, what); }

XmlFile::XmlFile(const File& file, const char* kind, std::vector<std::string_view> sections)
    : file_(file.name), bytes_(file.bytes), budget_((1UL << 24) + 64 * bytes_.size()) {
  const std::string xml = markup();
  require_utf8(xml);
  if (!document_.load_buffer(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8))
    fail("no VTK XML file");
  const pugi::xml_node root = document_.child("VTKFile"), data = root.child(kind);
  if (root.attribute("type").value() != std::string_view(kind) || !data)
    fail(std::string("not of type ") + kind);
  if (!data.child("Piece") || data.child("Piece").next_sibling("Piece")) fail("not of one piece");
  require_one_reading(kind, sections);
  const std::string order = root.attribute("byte_order").value();
  has_order_ = !order.empty();
  if (has_order_ && order != "LittleEndian" && order != "BigEndian") fail("unknown byte_order");
  highest_first_ = order == "BigEndian";
  const std::string compressor = root.attribute("compressor").value();
  zlib_ = !compressor.empty();
  if (zlib_ && compressor != "vtkZLibDataCompressor") fail("is compressed by " + compressor + ", which is not read here");
  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64") fail("unknown header_type");
  header_ = header == "UInt64" ? 8 : 4;
  const std::string encoding = root.child("AppendedData").attribute("encoding").as_string("base64");
  if (encoding != "raw" && encoding != "base64") fail("unknown encoding of AppendedData");
  appended_base64_ = encoding == "base64";
  if (appended_base64_) appended_ = trim(appended_.substr(0, appended_.find('<')));
  piece_ = data.child("Piece");
  for (const pugi::xml_node section : piece_.children())
    for (const pugi::xml_node array : section.children()) {
      const std::string_view name = array.name();
      // Of texts; only numbers are read.
      if (name != "DataArray" && name != "Array")
        fail(std::string(section.name()) + " has what is no array");
      if (!arrays_.try_emplace({section.name(), array.attribute("Name").value()}, array).second)
        fail(std::string(section.name()) + " has two arrays '" + array.attribute("Name").value() +
             "'");
      if (*array.attribute("Name").value() == '\0')
        fail(std::string(section.name()) + " has an array without a name");
      // Cells that others leave out.
      const std::string_view called = array.attribute("Name").value();
      if (marks_ghosts(called)) fail(ghosts_refused(called));
    }
}

void XmlFile::spend(std::size_t bytes) const {
  if (bytes > budget_) fail("numbers that take more than 64 times the file's size");
  budget_ -= bytes;
}

/// A whole number in an attribute: its digits, and nothing else.
std::size_t XmlFile::natural(pugi::xml_node node, const char* attribute,
                             std::size_t otherwise) const {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return otherwise;
  const std::string_view text = found.value();
  std::size_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (text.empty() || error != std::errc() || end != text.data() + text.size())
    fail(std::string("attribute '") + attribute + "' is no whole number");
  return n;
}

std::size_t XmlFile::count(const char* attribute) const {
  const std::size_t n = natural(piece_, attribute, 0);
  if (n > bytes_.size() * 1100) fail(std::string(attribute) + " is more than the file can hold");
  return n;
}

/// The first bytes of a text; of base64 those of whole groups of four characters, perhaps more.
std::string XmlFile::first(std::string_view text, std::size_t size, bool base64) const {
  if (size > text.size()) fail("data that end too early");
  const std::size_t length = base64 ? (size + 2) / 3 * 4 : size;
  if (length > text.size() || length > 0x7fffffff) fail("data that end too early");
  if (!base64) return std::string(text.substr(0, length));
  std::string bytes(length / 4 * 3, '\0');
  if (EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                      reinterpret_cast<const unsigned char*>(text.data()),
                      static_cast<int>(length)) != static_cast<int>(length / 4 * 3))
    fail("text that is no base64");
  return bytes;
}

/// The next bytes of a text, which are all of a text of base64: it has one form.
std::string XmlFile::take(std::string_view& text, std::size_t size, bool base64) const {
  std::string bytes = first(text, size, base64);
  const std::string_view source = text.substr(0, base64 ? bytes.size() / 3 * 4 : size);
  text.remove_prefix(source.size());
  if (!base64) return bytes;
  // The last characters stand for no more than is needed.
  const std::size_t last = source.size() - (3 - size % 3) % 3;
  if (source.substr(0, last).find('=') != std::string_view::npos ||
      source.substr(last).find_first_not_of('=') != std::string_view::npos ||
      std::any_of(bytes.begin() + static_cast<std::ptrdiff_t>(size), bytes.end(),
                  [](char c) { return c != 0; }))
    fail("text that is no base64 of its length");
  bytes.resize(size);
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
/// @param item  bytes of each number: parts that are compressed hold whole ones, as others swap bytes
/// part by part
std::string XmlFile::decode(std::string_view text, bool base64, std::size_t item) const {
  const std::uint64_t number = word(first(text, header_, base64), 0);
  if (number > text.size()) fail("data that end too early");
  // Base64 encodes the header by itself if the data are compressed, else all as one.
  if (!zlib_) return take(text, header_ + number, base64).substr(header_);
  if (number == 0) return {};
  const std::string header = take(text, (3 + number) * header_, base64);
  struct Block {
    std::uint64_t source, size, place, target;
  };
  std::vector<Block> blocks;
  std::uint64_t packed_size = 0, whole = 0;
  for (std::uint64_t i = 0; i < number; ++i) {
    const std::uint64_t size = word(header, 3 + i), last = word(header, 2);
    if (size > text.size()) fail("data that end too early");
    const std::uint64_t target = i + 1 == number && last != 0 ? last : word(header, 1);
    if (target / 1100 > size) fail("a block that cannot hold so much");  // zlib: at most 1032:1
    if (target % item != 0) fail("a compressed block with a part of a number");
    spend(target);
    blocks.push_back({packed_size, size, whole, target});
    packed_size += size, whole += target;
  }
  const std::string packed = take(text, packed_size, base64);
  std::string result(whole, '\0');
  std::atomic<bool> fits{true};
  parallel_for<1>(blocks.size(), [&](std::size_t i) {
    const auto& [source, size, place, target] = blocks[i];
    uLongf produced = target;
    if (uncompress(reinterpret_cast<Bytef*>(result.data() + place), &produced,
                   reinterpret_cast<const Bytef*>(packed.data() + source), size) != Z_OK ||
        produced != target)
      fits = false;
  });
  if (!fits) fail("a block that does not decompress");
  return result;
}

template <class Stored>
std::vector<double> XmlFile::read(pugi::xml_node array) const {
  std::vector<double> result;
  const std::string_view format = array.attribute("format").value();
  const bool is_appended = format == "appended";
  if (!is_appended && format != "ascii" && format != "binary") fail("an array of unknown format");
  if (is_appended == array.attribute("offset").empty())
    fail("an array with an offset that is not appended, or the reverse");
  std::size_t texts = 0;
  for (const pugi::xml_node child : array.children())
    if (child.type() != pugi::node_element) ++texts;
  if (texts > (is_appended ? 0U : 1U)) fail("an array with several texts");
  if (!is_appended && array.first_child() && array.first_child().type() != pugi::node_pcdata)
    fail("an array that does not begin with its numbers");
  if (format == "ascii") {
    if (!read_words<Stored>(array.child_value(), result)) fail("text that is no number of its type");
    return result;
  }
  if (!has_order_ && sizeof(Stored) > 1) fail("binary numbers without byte_order");
  const std::size_t start = natural(array, "offset", std::string::npos);
  if (is_appended && start > appended_.size()) fail("an offset outside the appended data");
  const std::string bytes = format == "binary"
                                ? decode(trim(array.child_value()), true, sizeof(Stored))
                                : decode(appended_.substr(start), appended_base64_, sizeof(Stored));
  if (bytes.size() % sizeof(Stored) != 0) fail("an array with a part of a number");
  spend(bytes.size() / sizeof(Stored) * sizeof(double));
  result.resize(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = in_double(item<Stored>(bytes, i));
  return result;
}

std::vector<std::pair<std::string, std::size_t>> XmlFile::arrays(const char* section) const {
  std::vector<std::pair<std::string, std::size_t>> result;
  for (const pugi::xml_node child : piece_.child(section).children()) {
    if (child.type() != pugi::node_element) fail(std::string(section) + " has a text");
    const std::string name = child.attribute("Name").value();
    if (child.name() != std::string_view("DataArray") || name.empty() || name.size() > 1000)
      fail(std::string(section) + " has what is no named array of numbers");
    result.emplace_back(name, natural(child, "NumberOfComponents", 1));
  }
  return result;
}

/// The array of that name in a section; of the points the only one, whatever its name.
pugi::xml_node XmlFile::only_array(const char* section, const std::string& name) const {
  if (section == std::string_view("Points")) {
    const pugi::xml_node array = piece_.child(section).child("DataArray");
    if (!array || array.next_sibling() || array.previous_sibling())
      fail(std::string(section) + " has not one array");
    return array;
  }
  const auto found = arrays_.find({section, name});
  if (name.empty() || found == arrays_.end())
    fail(std::string(section) + " has no array '" + name + "'");
  return found->second;
}

void XmlFile::require_only(const char* section, const std::vector<std::string_view>& names) const {
  for (const pugi::xml_node child : piece_.child(section).children()) {
    const std::string_view name = child.attribute("Name").value();
    if (child.name() != std::string_view("DataArray") ||
        std::find(names.begin(), names.end(), name) == names.end())
      fail("'" + std::string(name) + "' does not belong into '" + section + "'");
  }
}

std::vector<std::string> XmlFile::component_names(const char* section,
                                                  const std::string& name) const {
  const pugi::xml_node array = only_array(section, name);
  std::vector<std::string> result(std::min<std::size_t>(
      natural(array, "NumberOfComponents", 1), 9));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = array.attribute(("ComponentName" + std::to_string(i)).c_str()).value();
  return result;
}

std::vector<double> XmlFile::numbers(const char* section, const std::string& name,
                                     std::size_t components) const {
  const pugi::xml_node array = only_array(section, name);
  if (const std::size_t is = natural(array, "NumberOfComponents", 1); is != components)
    fail("the array '" + name + "' has " + std::to_string(is) + " components where " +
         std::to_string(components) + " belong");
  const std::string_view type = array.attribute("type").value();
  const auto result = type == "Float64"  ? read<double>(array)
                      : type == "Float32" ? read<float>(array)
                      : type == "Int64"   ? read<std::int64_t>(array)
                      : type == "Int32"   ? read<std::int32_t>(array)
                      : type == "Int16"   ? read<std::int16_t>(array)
                      : type == "Int8"    ? read<std::int8_t>(array)
                      : type == "UInt64"  ? read<std::uint64_t>(array)
                      : type == "UInt32"  ? read<std::uint32_t>(array)
                      : type == "UInt16"  ? read<std::uint16_t>(array)
                      : type == "UInt8"   ? read<std::uint8_t>(array)
                                          : std::vector<double>{HUGE_VAL};
  const auto bad = std::find_if(result.begin(), result.end(),
                                [](double x) { return !std::isfinite(x); });
  if (bad != result.end())
    fail("number " + std::to_string(bad - result.begin()) + " of the array '" + name +
         "' is not finite, an integer beyond 2^53, or of unknown type");
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
