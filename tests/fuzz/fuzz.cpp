// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A program of libFuzzer for the reader TENSORTOPO_READER.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tensortopo::test::FuzzedReader& reader = [] () -> const auto& {
    for (const auto& known : tensortopo::test::fuzzed_readers())
      if (known.name == TENSORTOPO_READER) return known;
    throw std::logic_error("no reader " TENSORTOPO_READER);
  }();
  reader.read({reinterpret_cast<const char*>(data), size});
  return 0;
}
