// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk/xml_output.hpp"

namespace tensortopo::detail {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\t' || c == '\n' || c == '\r')
      result += "&#" + std::to_string(c) + ";";
    else
      result += c;
  }
  return result;
}

}  // namespace

XmlOutput::XmlOutput(std::string_view type, OutputFile& file)
    : file_(file), text_("<?xml version=\"1.0\"?>\n") {
  open("VTKFile", {{"type", std::string(type)},
                   {"version", "1.0"},
                   {"byte_order", "LittleEndian"},
                   {"header_type", "UInt64"},
                   {"compressor", "vtkZLibDataCompressor"}});
}

void XmlOutput::tag(std::string_view element, const Attributes& attributes) {
  text_.append(indent_).append("<").append(element);
  for (const auto& [name, value] : attributes)
    text_.append(" ").append(name).append("=\"").append(escaped(value)).append("\"");
  text_ += ">\n";
}

void XmlOutput::open(std::string_view element, const Attributes& attributes) {
  tag(element, attributes);
  indent_ += "  ";
}

void XmlOutput::close(std::string_view element) {
  indent_.resize(indent_.size() - 2);
  text_.append(indent_).append("</").append(element).append(">\n");
}

void XmlOutput::block(std::string_view element, const Attributes& attributes,
                      std::span<const std::byte> bytes, Patterns patterns) {
  open(element, attributes);
  text_ += indent_;
  append_block(bytes, patterns, text_);
  text_ += "\n";
  close(element);
  constexpr std::size_t kWorthACall = 1 << 16;
  if (text_.size() < kWorthACall) return;
  file_.append(text_);
  text_.clear();
}

void XmlOutput::array(std::string_view name, std::string_view type, std::size_t components,
                      const Attributes& more, std::span<const std::byte> bytes, Patterns patterns) {
  Attributes attributes{{"type", std::string(type)},
                        {"Name", std::string(name)},
                        {"NumberOfComponents", std::to_string(components)}};
  attributes.insert(attributes.end(), more.begin(), more.end());
  attributes.emplace_back("format", "binary");
  block("DataArray", attributes, bytes, patterns);
}

void XmlOutput::array(std::string_view name, std::span<const double> values, Patterns patterns,
                      std::size_t components, const Attributes& more) {
  array(name, "Float64", components, more, std::as_bytes(values), patterns);
}

void XmlOutput::array(std::string_view name, std::span<const Vector3<double>> values,
                      Patterns patterns) {
  static_assert(sizeof(Vector3<double>) == 3 * sizeof(double));
  array(name, "Float64", 3, {}, std::as_bytes(values), patterns);
}

void XmlOutput::array(std::string_view name, std::span<const std::int64_t> values) {
  array(name, "Int64", 1, {}, std::as_bytes(values), Patterns::some);
}

void XmlOutput::array(std::string_view name, std::span<const std::int32_t> values) {
  array(name, "Int32", 1, {}, std::as_bytes(values), Patterns::some);
}

void XmlOutput::array(std::string_view name, std::span<const std::uint8_t> values) {
  array(name, "UInt8", 1, {}, std::as_bytes(values), Patterns::some);
}

void XmlOutput::string(std::string_view name, const std::string& value) {
  // With the zero at its end.
  block("Array",
        {{"type", "String"},
         {"Name", std::string(name)},
         {"NumberOfTuples", "1"},
         {"format", "binary"}},
        std::as_bytes(std::span(value.c_str(), value.size() + 1)), Patterns::some);
}

template <std::size_t Corners>
void XmlOutput::corners(std::span<const std::array<std::int32_t, Corners>> cells) {
  std::vector<std::int64_t> corners, ends(cells.size());
  corners.reserve(Corners * cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    corners.insert(corners.end(), cells[c].begin(), cells[c].end());
    ends[c] = static_cast<std::int64_t>(corners.size());
  }
  array("connectivity", corners);
  array("offsets", ends);
}

template void XmlOutput::corners(std::span<const std::array<std::int32_t, 3>>);
template void XmlOutput::corners(std::span<const std::array<std::int32_t, 4>>);

void XmlOutput::finish() {
  close("VTKFile");
  file_.append(text_);
  file_.finish();
}

}  // namespace tensortopo::detail
