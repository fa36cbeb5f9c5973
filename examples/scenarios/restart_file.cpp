// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "restart_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "file_bytes.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::scenarios {

namespace {

constexpr std::size_t kPoints = 8;                 // integration points of a hexahedron
constexpr std::size_t kComponents = 6;             // of its stress at each
constexpr std::size_t kCounts = 13;                // number of the record of three integers
constexpr std::size_t kNodes = 9, kElements = 10;  // numbers of the records with those counts

using Records = std::vector<std::string_view>;

class RestartReader {
 public:
  RestartReader(std::string bytes, const std::filesystem::path& file)
      : file_(file), bytes_(std::move(bytes)) {}

  RestartFile read() const {
    const Records records = split();
    if (records.size() <= kCounts || !records.front().starts_with("Version "))
      refuse("is no restart file of CalculiX");
    if (records[kCounts].size() != 3 * sizeof(std::int32_t))
      refuse("is of a version of CalculiX with another layout (2.20 is known)");
    const std::size_t nodes = count(records[kNodes]), elements = count(records[kElements]);
    if (number_at<std::int32_t>(records[kCounts], 0) != kPoints)
      refuse("has elements that are no hexahedra with 8 integration points");
    const auto freedoms = number_at<std::int32_t>(records[kCounts], sizeof(std::int32_t));
    if (freedoms < 3 || freedoms > 100) refuse("has nodes without three displacements");
    // One more number a node: the temperature comes first.
    const std::size_t stride = static_cast<std::size_t>(freedoms) + 1;

    RestartFile result;
    const auto points = std::find_if(records.begin() + kCounts + 1, records.end(), [&](auto r) {
      return r.size() == 3 * sizeof(double) * nodes;
    });
    if (points == records.end()) refuse("has no record of coordinates");
    result.points = vectors(*points, nodes, 3, 0);

    const std::size_t length = kComponents * kPoints * sizeof(double) * elements;
    const auto is_pair = [&](std::string_view a, std::string_view b) {
      return a.size() == length && b.size() == length;
    };
    // From behind: the neighbour that comes first in reverse is the strain.
    const auto strain = std::adjacent_find(records.rbegin(), records.rend(), is_pair);
    if (strain == records.rend()) refuse("has no record of stresses");
    const auto stress = strain + 1;
    result.stresses = stresses(*stress, elements);

    const auto displacement = std::find_if(stress + 1, records.rend(), [&](auto r) {
      return r.size() == stride * sizeof(double) * nodes;
    });
    if (displacement == records.rend()) refuse("has no record of displacements");
    result.displacements = vectors(*displacement, nodes, stride, 1);
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw IoError(IoError::Kind::invalid, file_, problem);
  }

  // Each record stands between two copies of its length; gfortran negates that of one of several
  // parts of a record longer than 2 GiB.
  Records split() const {
    constexpr std::size_t mark = sizeof(std::int32_t);
    const std::string_view all = bytes_;
    Records records;
    for (std::size_t at = 0; at < all.size();) {
      const std::string where = "(byte " + std::to_string(at) + ")";
      if (all.size() - at < 2 * mark) refuse("ends within a record " + where);
      const auto length = number_at<std::int32_t>(all, at);
      if (length < 0) refuse("has a record of more than 2 GiB, or none " + where);
      const auto size = static_cast<std::size_t>(length);
      if (all.size() - at - 2 * mark < size) refuse("ends within a record " + where);
      if (number_at<std::int32_t>(all, at + mark + size) != length)
        refuse("has a record whose two lengths differ " + where);
      records.push_back(all.substr(at + mark, size));
      at += 2 * mark + size;
    }
    return records;
  }

  std::size_t count(std::string_view record) const {
    const auto n = record.size() == sizeof(std::int32_t) ? number_at<std::int32_t>(record, 0) : 0;
    if (n < 1) refuse("does not say how many nodes and elements it has");
    return static_cast<std::size_t>(n);
  }

  double number(std::string_view record, std::size_t i) const {
    const auto x = number_at<double>(record, sizeof(double) * i);
    if (!std::isfinite(x)) refuse("holds a result that is infinite or not a number");
    return x;
  }

  std::vector<Vector3<double>> vectors(std::string_view record, std::size_t n, std::size_t stride,
                                       std::size_t first) const {
    std::vector<Vector3<double>> result;
    result.reserve(n);
    for (std::size_t i = first; result.size() < n; i += stride)
      result.push_back({number(record, i), number(record, i + 1), number(record, i + 2)});
    return result;
  }

  std::vector<RestartFile::HexStress> stresses(std::string_view record, std::size_t n) const {
    std::vector<RestartFile::HexStress> result(n);
    std::size_t i = 0;
    for (auto& hex : result)
      for (auto& t : hex) {
        t.xx = number(record, i++), t.yy = number(record, i++), t.zz = number(record, i++);
        t.xy = number(record, i++), t.xz = number(record, i++), t.yz = number(record, i++);
      }
    return result;
  }

  std::filesystem::path file_;
  std::string bytes_;
};

}  // namespace

RestartFile parse_restart_file(std::string bytes, const std::filesystem::path& file) {
  return RestartReader(std::move(bytes), file).read();
}

RestartFile read_restart_file(const std::filesystem::path& file) {
  return parse_restart_file(file_bytes(file), file);
}

}  // namespace tensortopo::scenarios
