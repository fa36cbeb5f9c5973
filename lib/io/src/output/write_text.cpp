// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/write_text.hpp"

#include "output/atomic_file.hpp"

namespace tensortopo {

void write_text(const std::filesystem::path& file, std::string_view text) {
  detail::write_atomically(file, text);
}

}  // namespace tensortopo
