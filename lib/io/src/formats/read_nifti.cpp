// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_nifti.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "bytes/format_error.hpp"
#include "formats/nifti_image.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo::detail {
namespace {

using Image = std::shared_ptr<const NiftiImage>;

/// Throws FormatError unless the corners of the mask are at those of the image, to a hundredth of
/// the distance between neighbours: programs round what places an image.
void require_same_place(const Lattice& mask, const Lattice& image) {
  if (mask.size != image.size)
    throw FormatError(fmt::format("has {} x {} x {} voxels, the image {} x {} x {}", mask.size[0],
                                  mask.size[1], mask.size[2], image.size[0], image.size[1],
                                  image.size[2]));
  double step = INFINITY, off = 0;
  for (std::size_t a = 0; a < 3; ++a)
    step = std::min(
        step, elementary::hypot(image.to_space[0][a], image.to_space[1][a], image.to_space[2][a]));
  for (std::size_t r = 0; r < 3; ++r) {
    double far = std::abs(mask.to_space[r][3] - image.to_space[r][3]);
    for (std::size_t a = 0; a < 3; ++a)
      far +=
          std::abs(mask.to_space[r][a] - image.to_space[r][a]) * static_cast<double>(image.size[a]);
    off = std::max(off, far);
  }
  if (!(off <= 0.01 * step)) throw FormatError("lies elsewhere in space than the image");
}

void apply_mask(const FieldSource& source, Lattice& lattice) {
  const auto file = load(source.options.mask);
  source.sum.add(file->bytes);
  naming_file(file->path, "the mask", [&] {
    const Image mask = read_nifti_image(file, 2000);
    require_same_place(mask->lattice, lattice);
    if (mask->values_per_voxel() != 1)
      throw FormatError(fmt::format("has {} values at a voxel", mask->values_per_voxel()));
    const std::vector<double> values = mask->volume(0);
    lattice.kept.resize(values.size());
    std::transform(values.begin(), values.end(), lattice.kept.begin(),
                   [](double x) { return static_cast<char>(x != 0 && !std::isnan(x)); });
    const std::size_t inside = lattice.points();
    keep_whole_cubes(lattice);
    source.notes.push_back(
        fmt::format("{} of {} voxels are in the mask, {} of them corners of cubes that are in it",
                    inside, values.size(), lattice.points()));
    if (lattice.points() == 0) throw FormatError("leaves no cube of the image");
  });
}

ArraySource tensors_of(const Image& image, const std::vector<char>& kept) {
  ArraySource array{"tensor", image->values_per_voxel(), {}, {}};
  constexpr std::int64_t symmetric_matrix = 1005;
  if (array.components == 6 && image->intent == symmetric_matrix)
    array.component_names = {"XX", "XY", "YY", "XZ", "YZ", "ZZ"};
  array.has_no_usual_order = true;
  array.values = [image, kept, n = array.components] {
    return naming_file(image->file->path, "", [&] {
      std::vector<double> values;
      for (std::size_t c = 0; c < n; ++c) {
        const std::vector<double> volume = image->volume(c);
        std::size_t next = 0;
        if (c == 0)
          values.resize(n * (kept.empty() ? volume.size()
                                          : static_cast<std::size_t>(
                                                std::count(kept.begin(), kept.end(), char{1}))));
        for (std::size_t v = 0; v < volume.size(); ++v)
          if (kept.empty() || kept[v] != 0) values[n * next++ + c] = volume[v];
      }
      return values;
    });
  };
  return array;
}

}  // namespace

std::vector<RawGrid> read_nifti(const FieldSource& source) {
  const auto& path = source.file->path;
  const Image image = naming_file(path, "", [&] {
    const Image read = read_nifti_image(source.file, 32);
    const auto& more = read->more;
    const bool is_tensor = (more[0] == 6 || more[0] == 9) && more[1] == 1;
    const bool is_matrix = more[0] == 1 && (more[1] == 6 || more[1] == 9);
    if (!(is_tensor || is_matrix) || more[2] != 1 || more[3] != 1)
      throw FormatError(fmt::format(
          "has dimensions 4 and 5 of {} and {}; 6 or 9 components are the fourth, or the fifth "
          "after a fourth of 1",
          more[0], more[1]));
    return read;
  });
  RawGrid grid;
  grid.file = path;
  grid.lattice = image->lattice;
  if (!source.options.mask.empty()) apply_mask(source, *grid.lattice);
  source.notes.push_back(
      fmt::format("voxel centres are the vertices, placed by {}", image->placed_by));
  if (image->is_scaled())
    source.notes.push_back(
        fmt::format("values are scaled by {} and shifted by {}, as the file says", image->slope,
                    image->intercept));
  grid.point_data.push_back(tensors_of(image, grid.lattice->kept));
  std::vector<RawGrid> grids;
  grids.push_back(std::move(grid));
  return grids;
}

}  // namespace tensortopo::detail
