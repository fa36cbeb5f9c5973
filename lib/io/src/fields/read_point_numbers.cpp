// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/read_point_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "formats/field_format.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo {

std::vector<double> read_point_numbers(const std::filesystem::path& file, const std::string& array,
                                       const ReadOptions& options, const ReadResult& read) {
  const auto fail = [&](IoError::Kind kind, const std::string& problem) {
    throw IoError(kind, file, "array `" + array + "`: " + problem);
  };
  const detail::FieldFormatEntry& entry = detail::format_of(file);
  const auto input = detail::load(file);
  Sha256 sum;
  sum.add(input->bytes);
  std::vector<std::string> notes;  // said when the field was read
  const auto grids = entry.read(detail::FieldSource{input, options, sum, notes});
  if (sum.hex() != read.sha256) fail(IoError::Kind::invalid, "the file has been changed");
  const ReadReport& report = read.report;
  if (grids.size() != 1 || report.merged_points > 0 || report.added_vertices > 0 ||
      report.doubled_vertices > 0 || grids.front().points() != read.mesh.points.size())
    fail(IoError::Kind::inapplicable,
         "vertices of the field are not the points of the file, one for one; give it at the "
         "vertices of what tensortopo convert makes of the file");
  const auto& arrays = grids.front().point_data;
  const auto is_it = [&](const detail::ArraySource& source) { return source.name == array; };
  const auto found = std::find_if(arrays.begin(), arrays.end(), is_it);
  if (found == arrays.end()) {
    std::string names;
    for (const auto& source : arrays)
      if (source.components == 1) names += (names.empty() ? "" : ", ") + source.name;
    fail(IoError::Kind::inapplicable,
         "there is none on the points; with one number a point there are: " +
             (names.empty() ? "none" : names));
  }
  if (std::count_if(arrays.begin(), arrays.end(), is_it) > 1)
    fail(IoError::Kind::inapplicable, "there are two of that name");
  if (found->components != 1)
    fail(IoError::Kind::inapplicable,
         "has " + std::to_string(found->components) + " components, not one");
  std::vector<double> numbers = found->values();
  if (numbers.size() != read.mesh.points.size())
    fail(IoError::Kind::invalid, "has not one number for each point");
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (!std::isfinite(numbers[v]))
      fail(IoError::Kind::invalid, "a number is not finite (point " + std::to_string(v) + ")");
  return numbers;
}

}  // namespace tensortopo
