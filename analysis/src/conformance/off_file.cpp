// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/off_file.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw IoError(IoError::Kind::invalid, file, what);
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  fail(file, "is no readable .off file of triangles");
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\f\v";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

template <class Number>
std::optional<Number> number_of(std::string_view word) {
  Number number{};
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

/// The lines of a file that say something, one after the other.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& file) : file_(file), stream_(file) {}

  /// The words of the next line, `least` or more, which are good until the line after it.
  std::vector<std::string_view> next(std::size_t least) {
    while (std::getline(stream_, line_))
      if (auto words = words_of(line_); !words.empty()) {
        if (words.size() < least) fail(file_);
        return words;
      }
    fail(file_);
  }

 private:
  const std::filesystem::path& file_;
  std::ifstream stream_;
  std::string line_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> read_off(const std::filesystem::path& file) {
  Lines lines(file);
  const auto whole = [&](std::string_view word) {
    const auto number = number_of<vtkIdType>(word);
    if (!number) fail(file);
    return *number;
  };
  auto words = lines.next(1);
  const std::string_view kind = words[0];
  if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF") fail(file);
  words.erase(words.begin());
  if (words.empty()) words = lines.next(2);  // on a line of their own
  if (words.size() < 2) fail(file);
  const vtkIdType vertices = whole(words[0]), faces = whole(words[1]);
  if (vertices < 0 || faces < 0) fail(file);

  // Nothing is reserved for what a file only declares.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < vertices; ++i) {
    words = lines.next(3);
    double p[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = number_of<double>(words[k]);
      if (!number) fail(file);
      p[k] = *number;
    }
    points->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> corners;
  for (vtkIdType i = 0; i < faces; ++i) {
    words = lines.next(1);
    const vtkIdType count = whole(words[0]);
    if (count < 1 || static_cast<std::size_t>(count) >= words.size()) fail(file);
    corners.clear();
    for (std::size_t k = 1; k <= static_cast<std::size_t>(count); ++k) {
      corners.push_back(whole(words[k]));
      if (corners.back() < 0 || corners.back() >= vertices)
        fail(file, "a triangle names a point that is not there");
    }
    if (count >= 3) polygons->InsertNextCell(count, corners.data());
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

}  // namespace tensortopo
