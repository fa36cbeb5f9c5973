// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/element.hpp"
#include "bytes/input_file.hpp"
#include "grids/lattice.hpp"

namespace tensortopo::detail {

/// A NIfTI image: what its header says, and its values, not decoded yet.
struct NiftiImage {
  Lattice lattice;
  std::string_view placed_by;  ///< "sform", "qform" or "voxel sizes"
  std::array<std::size_t, 4> more{1, 1, 1, 1};  ///< dimensions 4 to 7
  std::int64_t intent = 0;
  double slope = 0, intercept = 0;  ///< no scaling if the slope is 0

  ElementType type = ElementType::f32;
  std::endian order = std::endian::native;
  std::string_view data;        ///< all values, the first dimension fastest
  std::string unpacked;         ///< what `data` is of, if the file is packed
  std::shared_ptr<const InputFile> file;

  bool is_scaled() const { return slope != 0 && (slope != 1 || intercept != 0); }
  std::size_t values_per_voxel() const { return more[0] * more[1] * more[2] * more[3]; }
  /// The values of one voxel each, of volume `v`, scaled.
  std::vector<double> volume(std::size_t v) const;
};

/// Throws FormatError.
/// @param most_per_byte  packed values may be this many for each byte of the file, or two million
std::shared_ptr<const NiftiImage> read_nifti_image(const std::shared_ptr<const InputFile>& file,
                                                   std::uint64_t most_per_byte);

}  // namespace tensortopo::detail
