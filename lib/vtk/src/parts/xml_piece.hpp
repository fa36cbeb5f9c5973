// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo::filters {

/// A .vtu or .vtp of one piece in the making, with inline arrays in zlib blocks: the bytes that
/// tensortopo's Python package writes for equal arrays.
class XmlPiece {
 public:
  /// Names and values of attributes, in order.
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  /// @param type    what the file holds, as "PolyData"
  /// @param counts  of the piece
  XmlPiece(const std::string& type, const Attributes& counts);

  void begin(const std::string& section, const Attributes& marks = {});
  void end();  ///< of the section

  // Arrays of the section, of one number a row unless it is said.
  void array(const std::string& name, std::span<const double> values, std::size_t components = 1,
             const Attributes& more = {});
  void array(const std::string& name, std::span<const Vector3<double>> values);
  void array(const std::string& name, std::span<const std::int64_t> values,
             const Attributes& more = {});
  void array(const std::string& name, std::span<const std::int32_t> values);
  void array(const std::string& name, std::span<const std::uint8_t> values);
  /// Cells, as the arrays of their corners and of where those of each end.
  template <class Cells>
  void cells(const Cells& list) {
    std::vector<std::int64_t> corners, ends;
    for (const auto& cell : list) {
      corners.insert(corners.end(), cell.begin(), cell.end());
      ends.push_back(static_cast<std::int64_t>(corners.size()));
    }
    array("connectivity", corners);
    array("offsets", ends);
  }

  /// The bytes of the file.
  std::string finish();

 private:
  void put(const std::string& name, const char* type, std::size_t components,
           const Attributes& more, std::span<const std::byte> bytes);

  std::string type_, section_, text_;
};

/// A .pvtu or .pvtp: which arrays its pieces have, and where these are.
struct XmlPieces {
  /// An array that each piece has.
  struct Array {
    std::string name, type;      ///< as "Float64"
    std::size_t components = 1;  ///< numbers of a row
    XmlPiece::Attributes more;   ///< further attributes
  };
  std::string type;                       ///< what the pieces hold, as "PolyData"
  std::vector<Array> points, cells;       ///< of points and of cells
  XmlPiece::Attributes marks, cell_marks;  ///< which array is the points' `Scalars`, and so on
};

/// The bytes of such a file.
/// @param sources  the names of the pieces
std::string bytes_of(const XmlPieces& pieces, std::span<const std::string> sources);

}  // namespace tensortopo::filters
