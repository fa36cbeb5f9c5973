// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <png.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tensortopo::test {

/// A picture's colours, row by row from the top.
struct Pixels {
  int width = 0, height = 0;
  std::vector<unsigned char> bytes;

  std::array<int, 3> at(int x, int y) const {
    const auto i = static_cast<std::size_t>(3 * (y * width + x));
    return {bytes[i], bytes[i + 1], bytes[i + 2]};
  }
};

/// Of a .png; empty if it cannot be read.
inline Pixels pixels_of(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return {};
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  pixels.bytes.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.bytes.data(), 0, nullptr) == 0) return {};
  return pixels;
}

}  // namespace tensortopo::test
