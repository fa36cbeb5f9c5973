// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/nifti_image.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bytes/format_error.hpp"
#include "bytes/gzip.hpp"

namespace tensortopo::detail {
namespace {

/// Where the fields of a header are, and of which types; of NIfTI-1 and NIfTI-2.
struct Layout {
  std::size_t size;
  ElementType integer, real;                     // of dimensions; of placements and scales
  ElementType code;                              // of qform, sform and intent
  std::size_t magic, type, dim, pixdim, offset, slope, qform, sform, intent, quatern, srow;
  ElementType offset_type;
};
using enum ElementType;
constexpr Layout nifti_1{348, i16, f32, i16, 344, 70, 40, 76, 108, 112, 252, 254, 68, 256, 280, f32};
constexpr Layout nifti_2{540, i64, f64, i32, 4, 12, 16, 104, 168, 176, 344, 348, 504, 352, 400, i64};

constexpr std::size_t largest_header = 544;

ElementType type_of(std::int64_t code) {
  switch (code) {
    case 2:
      return u8;
    case 4:
      return i16;
    case 8:
      return i32;
    case 16:
      return f32;
    case 64:
      return f64;
    case 256:
      return i8;
    case 512:
      return u16;
    case 768:
      return u32;
    case 1024:
      return i64;
    case 1280:
      return u64;
    default:
      throw FormatError(fmt::format("has voxels of the type {}, which is not supported", code));
  }
}

class NiftiHeader {
 public:
  explicit NiftiHeader(std::string_view bytes) : bytes_(bytes) {
    if (bytes.size() < nifti_1.size) throw FormatError("is too short for a NIfTI image");
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      order_ = order;
      const std::int64_t size = number<std::int64_t>(0, i32);
      if (size == 348) layout_ = &nifti_1;
      if (size == 540) layout_ = &nifti_2;
      if (layout_ != nullptr) break;
    }
    if (layout_ == nullptr || bytes.size() < layout_->size)
      throw FormatError("is no NIfTI image: it does not begin with the size of a header");
    const std::string_view magic = bytes.substr(layout_->magic, 4);
    const char version = layout_ == &nifti_1 ? '1' : '2';
    if (magic[0] == 'n' && magic[1] == 'i')
      throw FormatError("is the header of an image in two files; write one .nii");
    if (magic[0] != 'n' || magic[1] != '+' || magic[2] != version)
      throw FormatError("is no NIfTI image: it lacks the mark n+" + std::string(1, version));
  }

  template <class Value>
  Value number(std::size_t at, ElementType type, std::size_t i = 0) const {
    const std::size_t size = size_of(type);
    return from_bytes<Value>(bytes_.substr(at + i * size, size), type, order_).front();
  }
  double real(std::size_t at, std::size_t i = 0) const {
    return number<double>(at, layout_->real, i);
  }
  std::int64_t code(std::size_t at) const { return number<std::int64_t>(at, layout_->code); }

  const Layout& layout() const { return *layout_; }
  std::endian order() const { return order_; }

 private:
  std::string_view bytes_;
  const Layout* layout_ = nullptr;
  std::endian order_ = std::endian::little;
};

void read_dimensions(const NiftiHeader& header, NiftiImage& image) {
  const Layout& l = header.layout();
  const auto dim = [&](std::size_t i) { return header.number<std::int64_t>(l.dim, l.integer, i); };
  const std::int64_t count = dim(0);
  if (count < 3 || count > 7)
    throw FormatError(fmt::format("has {} dimensions; a field in space has 3 at least", count));
  for (std::size_t i = 1; i <= static_cast<std::size_t>(count); ++i) {
    const std::int64_t n = dim(i);
    if (n < 1 || n > INT32_MAX)
      throw FormatError(fmt::format("has {} voxels along dimension {}", n, i));
    (i <= 3 ? image.lattice.size[i - 1] : image.more[i - 4]) = static_cast<std::size_t>(n);
  }
  for (const std::size_t n : image.more)
    if (n > 1000) throw FormatError("has too many values at a voxel");
}

using Matrix = std::array<std::array<double, 4>, 3>;

/// Rotation of a unit quaternion, of which b, c and d are given, times the sizes of voxels.
Matrix by_quaternion(const NiftiHeader& header) {
  const Layout& l = header.layout();
  double b = header.real(l.quatern, 0), c = header.real(l.quatern, 1), d = header.real(l.quatern, 2);
  double a = 1 - (b * b + c * c + d * d);
  if (a < 1e-7) {  // as the standard's own code does
    const double norm = std::sqrt(b * b + c * c + d * d);
    b /= norm, c /= norm, d /= norm, a = 0;
  } else {
    a = std::sqrt(a);
  }
  const double x = header.real(l.pixdim, 1), y = header.real(l.pixdim, 2);
  const double z = header.real(l.pixdim, 3) * (header.real(l.pixdim, 0) < 0 ? -1 : 1);
  const auto shift = [&](std::size_t i) { return header.real(l.quatern, 3 + i); };
  return {{{(a * a + b * b - c * c - d * d) * x, 2 * (b * c - a * d) * y, 2 * (b * d + a * c) * z,
            shift(0)},
           {2 * (b * c + a * d) * x, (a * a + c * c - b * b - d * d) * y, 2 * (c * d - a * b) * z,
            shift(1)},
           {2 * (b * d - a * c) * x, 2 * (c * d + a * b) * y, (a * a + d * d - b * b - c * c) * z,
            shift(2)}}};
}

void read_placement(const NiftiHeader& header, NiftiImage& image) {
  const Layout& l = header.layout();
  Matrix& to_space = image.lattice.to_space;
  if (header.code(l.sform) > 0) {
    image.placed_by = "sform";
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t i = 0; i < 4; ++i) to_space[r][i] = header.real(l.srow, 4 * r + i);
  } else if (header.code(l.qform) > 0) {
    image.placed_by = "qform";
    to_space = by_quaternion(header);
  } else {
    image.placed_by = "voxel sizes";
    for (std::size_t r = 0; r < 3; ++r) to_space[r][r] = header.real(l.pixdim, r + 1);
  }
}

}  // namespace

std::vector<double> NiftiImage::volume(std::size_t v) const {
  const std::size_t size = lattice.samples() * size_of(type);
  std::vector<double> values = from_bytes<double>(data.substr(v * size, size), type, order);
  if (is_scaled())
    for (double& x : values) x = slope * x + intercept;
  return values;
}

std::shared_ptr<const NiftiImage> read_nifti_image(const std::shared_ptr<const InputFile>& file,
                                                   std::uint64_t most_per_byte) {
  const bool packed = is_gzip(file->bytes);
  const std::string front = packed ? gunzip(file->bytes, largest_header)
                                   : file->bytes.substr(0, largest_header);
  const NiftiHeader header(front);
  const Layout& l = header.layout();
  auto image = std::make_shared<NiftiImage>();
  image->file = file;
  read_dimensions(header, *image);
  read_placement(header, *image);
  check_lattice(image->lattice);
  image->intent = header.code(l.intent);
  image->type = type_of(header.number<std::int64_t>(l.type, i16));
  image->order = header.order();
  image->slope = header.real(l.slope);
  image->intercept = header.real(l.slope, 1);
  if (image->slope != 0 && !(std::isfinite(image->slope) && std::isfinite(image->intercept)))
    throw FormatError("has a scale of values that is not finite");

  const double offset = header.number<double>(l.offset, l.offset_type);
  if (!(offset >= static_cast<double>(l.size)) || offset != std::floor(offset) || offset > 1e9)
    throw FormatError("has its values at no usable place");
  const auto begin = static_cast<std::size_t>(offset);
  // Samples fit 31 bits, values a voxel 40.
  const std::uint64_t values = image->lattice.samples() * image->values_per_voxel();
  if (packed && values > std::max<std::uint64_t>(2000000, most_per_byte * file->bytes.size()))
    throw FormatError("promises more values than a file of its size holds");
  if (values > (SIZE_MAX >> 4) / 8) throw FormatError("promises too many values");
  const std::size_t size = values * size_of(image->type);
  if (packed) image->unpacked = gunzip(file->bytes, begin + size);
  const std::string_view all = packed ? image->unpacked : file->bytes;
  if (all.size() < begin || all.size() - begin < size)
    throw FormatError(fmt::format("ends before its {} values", values));
  image->data = all.substr(begin, size);
  return image;
}

}  // namespace tensortopo::detail
