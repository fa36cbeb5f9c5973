// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "bytes/input_file.hpp"
#include "tensortopo/io/read_surface_file.hpp"

namespace tensortopo::detail {

// Each throws FormatError for bytes that are no such file.
SurfaceFile read_obj(std::string_view bytes);
SurfaceFile read_off(std::string_view bytes);
SurfaceFile read_ply(std::string_view bytes);
SurfaceFile read_stl(std::string_view bytes);
SurfaceFile read_vtp(const std::shared_ptr<const InputFile>& file);

/// `read_surface_file` of a file that is in memory. Throws IoError.
SurfaceFile read_surface_of(const std::shared_ptr<const InputFile>& file);

}  // namespace tensortopo::detail
