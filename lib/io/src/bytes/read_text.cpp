// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/read_text.hpp"

#include "bytes/input_file.hpp"

namespace tensortopo {

std::string read_text(const std::filesystem::path& file) { return detail::load(file)->bytes; }

}  // namespace tensortopo
