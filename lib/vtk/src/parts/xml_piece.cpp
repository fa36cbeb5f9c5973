// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/xml_piece.hpp"

#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace tensortopo::filters {

namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

using Bytes = std::vector<unsigned char>;

/// As the value of an attribute.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  return result;
}

std::string spelled(const XmlPiece::Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) text += ' ' + name + "=\"" + escaped(value) + '"';
  return text;
}

/// The beginning of a file of a type.
std::string xml_head(const std::string& type) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
         "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
         "compressor=\"vtkZLibDataCompressor\">\n";
}

std::string in_base64(const Bytes& bytes) {
  Bytes text((bytes.size() + 2) / 3 * 4 + 4);
  const auto size = vtkBase64Utilities::Encode(bytes.data(), bytes.size(), text.data());
  return {text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// A header of 64-bit words, and the bytes in zlib blocks.
std::string in_blocks(std::span<const std::byte> bytes) {
  constexpr std::size_t block = std::size_t{1} << 20;
  vtkNew<vtkZLibDataCompressor> zlib;
  zlib->SetCompressionLevel(6);  // zlib's own choice
  std::vector<std::uint64_t> head{(bytes.size() + block - 1) / block, block, bytes.size() % block};
  Bytes packed;
  for (std::size_t begin = 0; begin < bytes.size(); begin += block) {
    const std::size_t size = std::min(block, bytes.size() - begin), before = packed.size();
    packed.resize(before + zlib->GetMaximumCompressionSpace(size));
    const std::size_t made =
        zlib->Compress(reinterpret_cast<const unsigned char*>(bytes.data() + begin), size,
                       packed.data() + before, packed.size() - before);
    if (made == 0) throw std::runtime_error("zlib cannot compress an array");
    packed.resize(before + made);
    head.push_back(made);
  }
  const auto words = std::as_bytes(std::span(head));
  Bytes first(words.size());
  std::transform(words.begin(), words.end(), first.begin(),
                 [](std::byte b) { return static_cast<unsigned char>(b); });
  return in_base64(first) + in_base64(packed);
}

}  // namespace

XmlPiece::XmlPiece(const std::string& type, const Attributes& counts)
    : type_(type),
      text_(xml_head(type) + '<' + type + ">\n<Piece" + spelled(counts) + ">\n") {}

void XmlPiece::begin(const std::string& section, const Attributes& marks) {
  section_ = section;
  text_ += '<' + section + spelled(marks) + ">\n";
}

void XmlPiece::end() { text_ += "</" + section_ + ">\n"; }

void XmlPiece::put(const std::string& name, const char* type, std::size_t components,
                   const Attributes& more, std::span<const std::byte> bytes) {
  const Attributes attributes{
      {"type", type}, {"Name", name}, {"NumberOfComponents", std::to_string(components)}};
  text_ += "<DataArray" + spelled(attributes) + spelled(more) + " format=\"binary\">" +
           in_blocks(bytes) + "</DataArray>\n";
}

void XmlPiece::array(const std::string& name, std::span<const double> values,
                     std::size_t components, const Attributes& more) {
  put(name, "Float64", components, more, std::as_bytes(values));
}

void XmlPiece::array(const std::string& name, std::span<const Vector3<double>> values) {
  static_assert(sizeof(Vector3<double>) == 3 * sizeof(double));
  put(name, "Float64", 3, {}, std::as_bytes(values));
}

void XmlPiece::array(const std::string& name, std::span<const std::int64_t> values,
                     const Attributes& more) {
  put(name, "Int64", 1, more, std::as_bytes(values));
}

void XmlPiece::array(const std::string& name, std::span<const std::int32_t> values) {
  put(name, "Int32", 1, {}, std::as_bytes(values));
}

void XmlPiece::array(const std::string& name, std::span<const std::uint8_t> values) {
  put(name, "UInt8", 1, {}, std::as_bytes(values));
}

std::string XmlPiece::finish() {
  return std::move(text_) + "</Piece>\n</" + type_ + ">\n</VTKFile>\n";
}

std::string bytes_of(const XmlPieces& pieces, std::span<const std::string> sources) {
  const std::string type = 'P' + pieces.type;
  std::string text = xml_head(type) + '<' + type + " GhostLevel=\"0\">\n";
  const auto list = [&](const std::string& section, const std::vector<XmlPieces::Array>& arrays,
                        const XmlPiece::Attributes& marks) {
    text += '<' + section + spelled(marks) + ">\n";
    for (const XmlPieces::Array& array : arrays)
      text += "<PDataArray" +
              spelled({{"type", array.type},
                       {"Name", array.name},
                       {"NumberOfComponents", std::to_string(array.components)}}) +
              spelled(array.more) + "/>\n";
    text += "</" + section + ">\n";
  };
  list("PPointData", pieces.points, pieces.marks);
  list("PCellData", pieces.cells, pieces.cell_marks);
  list("PPoints", {{"Points", "Float64", 3, {}}}, {});
  for (const std::string& source : sources)
    text += "<Piece" + spelled({{"Source", source}}) + "/>\n";
  return text + "</" + type + ">\n</VTKFile>\n";
}

}  // namespace tensortopo::filters
