// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

namespace tensortopo::scenarios {

static_assert(std::endian::native == std::endian::little, "CalculiX writes in the machine's order");

/// All bytes of a file. Throws IoError (`unreadable`).
std::string file_bytes(const std::filesystem::path& file);

/// The number of type T at an offset, which must leave room for it.
template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

}  // namespace tensortopo::scenarios
