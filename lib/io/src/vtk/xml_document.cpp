// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk/xml_document.hpp"

#include <algorithm>
#include <bit>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "bytes/base64.hpp"
#include "bytes/format_error.hpp"
#include "bytes/words.hpp"

namespace tensortopo::detail {
namespace {

/// Parts the markup from the bytes after <AppendedData ...>_ and returns the markup, closed again.
/// @param own  keeps what the view is of, if that is not the file
std::string_view separate(XmlDocument& document, std::string& own) {
  const std::string_view bytes = document.file->bytes;
  const std::size_t tag = bytes.find("<AppendedData");
  if (tag == std::string_view::npos) return bytes;
  const std::size_t close = bytes.find('>', tag);
  const std::size_t underscore = close == std::string_view::npos ? close : bytes.find('_', close);
  if (underscore == std::string_view::npos) throw FormatError("ends within the tag AppendedData");
  // The end tag is sought from the back: the bytes may hold anything.
  const std::size_t end = bytes.rfind("</AppendedData");
  if (end == std::string_view::npos || end <= underscore)
    throw FormatError("is cut off: the end of AppendedData is missing");
  document.appended = bytes.substr(underscore + 1, end - underscore - 1);
  return own = std::string(bytes.substr(0, close + 1)) + "</AppendedData></VTKFile>";
}

BlockFormat block_format(pugi::xml_node root) {
  BlockFormat format;
  const std::string_view order = root.attribute("byte_order").value();
  if (order == "BigEndian")
    format.order = std::endian::big;
  else if (order == "LittleEndian")
    format.order = std::endian::little;
  else if (!order.empty())
    throw FormatError("has the unknown byte order \"" + std::string(order) + "\"");

  const std::string_view word = root.attribute("header_type").value();
  if (word == "UInt64")
    format.header_word = 8;
  else if (!word.empty() && word != "UInt32")
    throw FormatError("has the unknown header type \"" + std::string(word) + "\"");

  using Compressor = BlockFormat::Compressor;
  const std::string_view name = root.attribute("compressor").value();
  if (name == "vtkZLibDataCompressor")
    format.compressor = Compressor::zlib;
  else if (name == "vtkLZ4DataCompressor")
    format.compressor = Compressor::lz4;
  else if (name == "vtkLZMADataCompressor")
    format.compressor = Compressor::lzma;
  else if (!name.empty())
    throw FormatError("has the unknown compressor \"" + std::string(name) + "\"");
  return format;
}

/// Gathers where appended arrays begin, so that each is known to end before the next.
struct OffsetWalker : pugi::xml_tree_walker {
  std::vector<std::uint64_t> offsets;
  bool for_each(pugi::xml_node& node) override {
    if (const auto offset = node.attribute("offset"))
      if (const auto value = to_count(trimmed(offset.value()))) offsets.push_back(*value);
    return true;
  }
};

/// VTK's parser takes one element and no text outside of it, and loses the text of an array before
/// a comment. Comments elsewhere are taken out.
void require_one_element(pugi::xml_document& markup) {
  struct Walker : pugi::xml_tree_walker {
    std::vector<pugi::xml_node> comments;
    bool for_each(pugi::xml_node& node) override {
      if (node.type() == pugi::node_comment) comments.push_back(node);
      return true;
    }
  } walker;
  markup.traverse(walker);
  for (pugi::xml_node comment : walker.comments) {
    if (comment.parent().name() == std::string_view("DataArray"))
      throw FormatError("is not read by VTK: a comment in an array; take it out");
    comment.parent().remove_child(comment);
  }
  std::size_t elements = 0;
  for (const pugi::xml_node node : markup.children()) {
    if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata ||
        (node.type() == pugi::node_element && ++elements > 1))
      throw FormatError("is not well-formed XML: there is more than the element \"" +
                        std::string(markup.document_element().name()) + "\"; take it out");
  }
}

std::string_view appended_block(const XmlDocument& document, pugi::xml_node array) {
  const std::uint64_t begin = count_attribute(array, "offset");
  const std::string_view all = document.appended;
  if (begin >= all.size())
    throw FormatError("begins at byte " + std::to_string(begin) + " of " +
                      std::to_string(all.size()) + " appended bytes");
  const auto next = std::upper_bound(document.offsets.begin(), document.offsets.end(), begin);
  const std::uint64_t end =
      next == document.offsets.end() ? all.size() : std::min<std::uint64_t>(*next, all.size());
  return all.substr(begin, end - begin);
}

/// The block of an array that is not written as numbers.
/// @param own  keeps what the view is of, if that is not the file
std::string_view block_of(const XmlDocument& document, pugi::xml_node array, std::string& own) {
  const std::string_view format = array.attribute("format").value();
  if (format == "appended") {
    const std::string_view block = appended_block(document, array);
    if (!document.appended_is_base64) return block;
    return own = from_base64(block, true);
  }
  if (format == "binary") return own = from_base64(array.text().get());
  throw FormatError("has the unknown data format \"" + std::string(format) + "\"");
}

template <class Value>
constexpr ElementType element_type =
    std::is_floating_point_v<Value> ? ElementType::f64 : ElementType::i64;

}  // namespace

std::shared_ptr<const XmlDocument> parse_xml(std::shared_ptr<const InputFile> file,
                                             std::string_view type) {
  auto document = std::make_shared<XmlDocument>();
  document->file = std::move(file);
  std::string own;
  const std::string_view markup = separate(*document, own);
  const pugi::xml_parse_result parsed = document->markup.load_buffer(
      markup.data(), markup.size(),
      pugi::parse_default | pugi::parse_comments | pugi::parse_fragment, pugi::encoding_utf8);
  if (!parsed)
    throw FormatError(std::string("is not well-formed XML: ") + parsed.description() + " (byte " +
                      std::to_string(parsed.offset) + ")");
  require_one_element(document->markup);

  document->root = document->markup.child("VTKFile");
  if (!document->root) throw FormatError("is not a VTK file: no element VTKFile");
  const std::string_view found = document->root.attribute("type").value();
  if (found != type)
    throw FormatError("holds \"" + std::string(found) + "\", not " + std::string(type));
  document->format = block_format(document->root);

  const std::string_view encoding =
      document->root.child("AppendedData").attribute("encoding").value();
  if (encoding == "base64")
    document->appended_is_base64 = true;
  else if (!encoding.empty() && encoding != "raw")
    throw FormatError("has the unknown encoding \"" + std::string(encoding) + "\"");

  OffsetWalker walker;
  document->root.traverse(walker);
  std::sort(walker.offsets.begin(), walker.offsets.end());
  document->offsets = std::move(walker.offsets);
  return document;
}

template <class Value>
std::vector<Value> read_array(const XmlDocument& document, pugi::xml_node array,
                              std::size_t count) {
  const std::string_view type_name = array.attribute("type").value();
  const auto type = xml_element_type(type_name);
  if (!type) throw FormatError("has the unknown type \"" + std::string(type_name) + "\"");
  if (std::is_integral_v<Value> && !is_integer(*type))
    throw FormatError("holds floating-point numbers where integers belong");
  const std::string_view format = array.attribute("format").value();
  if (format == "ascii" || format.empty()) {
    std::string_view text = array.text().get();
    auto values = take_numbers<Value>(text, count, *type);
    if (!take_word(text).empty())
      throw FormatError("holds more than the " + std::to_string(count) + " numbers that belong");
    return values;
  }
  if (!document.format.order)
    throw FormatError("is binary, but the file does not say its byte_order");
  if (count > SIZE_MAX / 8) throw FormatError("promises too many numbers");
  if (document.format.compressor != BlockFormat::Compressor::none) {
    const std::uint64_t most = std::max<std::uint64_t>(2000000, 32 * document.file->bytes.size());
    document.decompressed += count;
    if (document.decompressed > most)
      throw FormatError("promises more numbers than a file of its size holds");
  }
  std::string own;
  const PackedArray packed =
      packed_array(block_of(document, array, own), count * size_of(*type), document.format);
  if (*type == element_type<Value> && *document.format.order == std::endian::native) {
    std::vector<Value> values(count);
    unpack(packed, std::as_writable_bytes(std::span(values)));
    return values;
  }
  std::string bytes(packed.size, '\0');
  unpack(packed, std::as_writable_bytes(std::span(bytes)));
  return from_bytes<Value>(bytes, *type, *document.format.order);
}

template std::vector<double> read_array(const XmlDocument&, pugi::xml_node, std::size_t);
template std::vector<std::int64_t> read_array(const XmlDocument&, pugi::xml_node, std::size_t);

std::optional<std::string> read_string(const XmlDocument& document, pugi::xml_node array) {
  constexpr std::size_t kMost = 4096;
  if (array.attribute("type").value() != std::string_view("String")) return std::nullopt;
  std::string bytes;  // with the zero at the end of the string
  const std::string_view format = array.attribute("format").value();
  if (format == "ascii" || format.empty()) {
    std::string_view text = array.text().get();
    for (auto word = take_word(text); !word.empty(); word = take_word(text)) {
      const auto code = to_count(word);
      if (!code || *code > 255 || bytes.size() == kMost) return std::nullopt;
      bytes.push_back(static_cast<char>(*code));
    }
  } else {
    std::string own;
    const std::string_view block = block_of(document, array, own);
    const std::uint64_t size = promised_size(block, document.format);
    if (size > kMost) return std::nullopt;
    bytes.resize(size);
    unpack(packed_array(block, size, document.format), std::as_writable_bytes(std::span(bytes)));
  }
  if (bytes.empty() || bytes.find('\0') != bytes.size() - 1) return std::nullopt;
  bytes.pop_back();
  return bytes;
}

std::uint64_t count_attribute(pugi::xml_node node, const char* name) {
  const auto value = to_count(trimmed(node.attribute(name).value()));
  if (!value) throw FormatError(std::string("has no usable ") + name + " in <" + node.name() + ">");
  return *value;
}

std::uint64_t components_of(pugi::xml_node array) {
  return array.attribute("NumberOfComponents") ? count_attribute(array, "NumberOfComponents") : 1;
}

}  // namespace tensortopo::detail
