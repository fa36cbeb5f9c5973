// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tensortopo::detail {

/// A NetCDF file of one of the classic formats (CDF-1, -2, -5): what its header lists, and its
/// values, whose places are checked against the bytes at hand. (The NetCDF library takes what a
/// file that was cut off lacks for zeros.) Throws FormatError.
/// Source  "The NetCDF Classic Format Specification", NetCDF User's Guide, appendix B.
class NetcdfFile {
 public:
  struct Variable {
    std::string name;
    std::vector<std::size_t> sizes;  ///< of its dimensions, without that of records
    bool has_records = false;
    std::map<std::string, std::string> texts;  ///< attributes that are text
    int type = 0;
    std::uint64_t begin = 0, bytes = 0;  ///< of a record, or of all
  };

  /// @param bytes  must outlive the file
  explicit NetcdfFile(std::string_view bytes);

  std::size_t records() const { return records_; }
  /// An attribute of the file that is text; empty if there is none of the name.
  std::string text(const std::string& name) const;
  /// Length of a dimension; 0 if there is none of the name.
  std::size_t dimension(const std::string& name) const;
  /// Null if there is none of the name.
  const Variable* find(const std::string& name) const;
  /// The same, with sizes that it must have.
  const Variable& variable(const std::string& name, const std::vector<std::size_t>& sizes) const;

  /// All values, or those of one record. Value is double or std::int64_t.
  template <class Value>
  std::vector<Value> values(const Variable& variable, std::size_t record = 0) const;
  /// Rows of text, without what fills them up.
  std::vector<std::string> rows(const Variable& variable) const;

 private:
  friend class NetcdfHeader;
  std::string_view bytes_of(const Variable& variable, std::size_t record) const;

  std::string_view bytes_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::size_t> dimensions_;
  std::map<std::string, Variable> variables_;
  std::size_t records_ = 0;
  std::uint64_t record_bytes_ = 0;
};

}  // namespace tensortopo::detail
