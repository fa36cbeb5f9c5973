// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "frd_file.hpp"

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "file_bytes.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::scenarios {

namespace {

// Lines of text between blocks of binary numbers. A line that opens a block has its count in
// columns 25 to 36, and in its last column what the numbers are.
class FrdReader {
 public:
  FrdReader(std::string bytes, const std::filesystem::path& file)
      : file_(file), bytes_(std::move(bytes)) {}

  FrdFile read() {
    FrdFile result;
    for (;;) {
      const std::string_view head = line();
      if (head.starts_with(" 9999")) break;
      if (head.starts_with("    2C")) {
        block(count(head), sizeof(std::int32_t) + 3 * real_size(head));
      } else if (head.starts_with("    3C")) {
        elements(count(head));
      } else if (head.starts_with("  100C")) {
        results(head, result);
      }
    }
    if (result.displacements.empty() || result.stresses.empty())
      refuse("lacks displacements or stresses");
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw IoError(IoError::Kind::invalid, file_, problem + " (byte " + std::to_string(at_) + ")");
  }

  std::string_view line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) refuse("ends without its last line");
    const auto text = std::string_view(bytes_).substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  std::size_t count(std::string_view head) const {
    const std::string_view field = head.size() > 36 ? head.substr(24, 12) : "";
    const auto digits = field.find_first_not_of(' ');
    std::size_t n = 0;
    if (digits == field.npos) refuse("has a block without a count");
    const auto [end, error] =
        std::from_chars(field.data() + digits, field.data() + field.size(), n);
    if (error != std::errc{} || end != field.data() + field.size())
      refuse("has a block without a count");
    return n;
  }

  std::size_t real_size(std::string_view head) const {
    if (head.back() == '2') return sizeof(float);
    if (head.back() == '3') return sizeof(double);
    refuse("is not binary");
  }

  // The next n pieces of a size.
  std::string_view block(std::size_t n, std::size_t size) {
    if ((bytes_.size() - at_) / size < n) refuse("ends within a block");
    const auto found = std::string_view(bytes_).substr(at_, n * size);
    at_ += n * size;
    return found;
  }

  void elements(std::size_t n) {
    constexpr std::size_t hex_size = (4 + 8) * sizeof(std::int32_t);
    const auto all = block(n, hex_size);
    // Number, type, group, material, corners. Type 1 has eight.
    for (std::size_t i = 0; i < n; ++i)
      if (number_at<std::int32_t>(all, i * hex_size + sizeof(std::int32_t)) != 1)
        refuse("has elements that are no hexahedra with 8 nodes");
  }

  void results(std::string_view head, FrdFile& result) {
    const std::size_t n = count(head), real = real_size(head);
    const std::string_view title = line();
    if (!title.starts_with(" -4")) refuse("has a result block without a name");
    const std::string_view name = title.substr(5, title.find(' ', 5) - 5);
    std::size_t components = 0;
    while (std::string_view(bytes_).substr(at_).starts_with(" -5"))
      // A magnitude, ALL, is listed but not stored.
      if (!line().starts_with(" -5  ALL")) ++components;
    const std::size_t stride = sizeof(std::int32_t) + components * real;
    const std::string_view values = block(n, stride);
    const auto value = [&](std::size_t node, std::size_t c) {
      const std::size_t at = node * stride + sizeof(std::int32_t) + c * real;
      return real == sizeof(float) ? double{number_at<float>(values, at)}
                                   : number_at<double>(values, at);
    };
    for (std::size_t i = 0; i < n; ++i)
      if (number_at<std::int32_t>(values, i * stride) != static_cast<std::int32_t>(i + 1))
        refuse("has nodes out of order");
    if (name == "DISP" && components == 3) {
      for (std::size_t i = 0; i < n; ++i)
        result.displacements.push_back({value(i, 0), value(i, 1), value(i, 2)});
    } else if (name == "STRESS" && components == 6) {
      for (std::size_t i = 0; i < n; ++i)
        result.stresses.push_back(
            {value(i, 0), value(i, 1), value(i, 2), value(i, 3), value(i, 4), value(i, 5)});
    }
  }

  std::filesystem::path file_;
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace

FrdFile parse_frd_file(std::string bytes, const std::filesystem::path& file) {
  return FrdReader(std::move(bytes), file).read();
}

FrdFile read_frd_file(const std::filesystem::path& file) {
  return parse_frd_file(file_bytes(file), file);
}

}  // namespace tensortopo::scenarios
