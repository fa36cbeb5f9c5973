// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/read_surface_file.hpp"

#include <memory>
#include <new>
#include <stdexcept>

#include "bytes/format_error.hpp"
#include "bytes/input_file.hpp"
#include "surfaces/read_formats.hpp"
#include "surfaces/surface_format.hpp"

namespace tensortopo {
namespace {

const SurfaceArray* find(const std::vector<SurfaceArray>& arrays, const std::string& name) {
  for (const SurfaceArray& array : arrays)
    if (array.name == name) return &array;
  return nullptr;
}

}  // namespace

SurfaceFile detail::read_surface_of(const std::shared_ptr<const InputFile>& file) {
  const SurfaceFormatEntry* const entry = surface_entry_of(file->path);
  if (entry == nullptr)
    throw IoError(IoError::Kind::invalid, file->path,
                  "the name must end in " + surface_extensions());
  return naming_file(file->path, "", [&] {
    return entry->read != nullptr ? entry->read(file->bytes) : read_vtp(file);
  });
}

const SurfaceArray* SurfaceFile::find_point_data(const std::string& name) const {
  return find(point_data, name);
}

const SurfaceArray* SurfaceFile::find_cell_data(const std::string& name) const {
  return find(cell_data, name);
}

SurfaceFile read_surface_file(const std::filesystem::path& file) {
  try {
    return detail::read_surface_of(detail::load(file));
  } catch (const std::bad_alloc&) {
    throw IoError(IoError::Kind::invalid, file, "is too large for this machine's memory");
  } catch (const std::length_error&) {
    throw IoError(IoError::Kind::invalid, file, "is too large for this machine's memory");
  }
}

}  // namespace tensortopo
