// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bytes/encode_block.hpp"
#include "output/atomic_file.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo::detail {

/// Writes a file of VTK's XML formats: little endian, arrays inline (some readers in use, ParaView
/// 5.11 with a recent expat among them, refuse appended ones), in zlib blocks with headers of
/// 64-bit words. The text of an array goes to the file before the next one is made.
class XmlOutput {
 public:
  using Attributes = std::vector<std::pair<std::string_view, std::string>>;

  /// @param type  what the file holds, as "PolyData"
  /// @param file  outlives this
  XmlOutput(std::string_view type, OutputFile& file);

  void open(std::string_view element, const Attributes& attributes = {});
  void close(std::string_view element);

  // Arrays of numbers.
  void array(std::string_view name, std::span<const double> values, Patterns patterns,
             std::size_t components = 1, const Attributes& more = {});
  void array(std::string_view name, std::span<const Vector3<double>> values, Patterns patterns);
  void array(std::string_view name, std::span<const std::int64_t> values);
  void array(std::string_view name, std::span<const std::int32_t> values);
  void array(std::string_view name, std::span<const std::uint8_t> values);
  void string(std::string_view name, const std::string& value);

  /// The two arrays that a section of cells has: the corners of all, one after the other, and where
  /// those of each end.
  template <std::size_t Corners>
  void corners(std::span<const std::array<std::int32_t, Corners>> cells);

  /// The last of the text, and the file's end. Throws IoError (unwritable), as all above.
  void finish();

 private:
  void tag(std::string_view element, const Attributes& attributes);
  void block(std::string_view element, const Attributes& attributes,
             std::span<const std::byte> bytes, Patterns patterns);
  void array(std::string_view name, std::string_view type, std::size_t components,
             const Attributes& more, std::span<const std::byte> bytes, Patterns patterns);

  OutputFile& file_;
  std::string text_;  ///< that is not in the file yet
  std::string indent_;
};

}  // namespace tensortopo::detail
