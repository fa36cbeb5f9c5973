// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The modes of the frames of `--animate`; see `parse_mode_range`.
std::vector<ModeValue> parse_animation(std::string_view text);

/// The file of a frame: for FILE.png FILE-007.png, with as many digits as `count` frames need.
std::filesystem::path frame_file(const std::filesystem::path& picture, std::size_t frame,
                                 std::size_t count);

/// Whether the name ends in .gif or .mp4.
bool is_film(const std::filesystem::path& file);

/// Throws IoError about `file`, which is to be a film, if the program ffmpeg is not there.
void require_ffmpeg(const std::filesystem::path& file);

/// Makes a film of pictures, each the bytes of a PNG, by the program ffmpeg, and writes it whole or
/// not at all. Throws IoError, also where there is no ffmpeg.
/// @return its size in bytes
std::size_t write_film(const std::filesystem::path& file, const std::vector<std::string>& pictures);

}  // namespace tensortopo
