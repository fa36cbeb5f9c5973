// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/field_pieces.hpp"

#include <set>
#include <utility>

#include "bytes/input_file.hpp"
#include "formats/read_vtu.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {

namespace {

/// Throws IoError for a piece whose cells are not those of the file, one by one.
ReadResult read_plain(const std::filesystem::path& file, const ReadOptions& options) {
  ReadResult read = read_mesh(file, options);
  const ReadReport& report = read.report;
  if (report.skipped_cells_2d_1d + report.skipped_ghost_cells + report.split_cells > 0)
    throw IoError(IoError::Kind::inapplicable, file,
                  "a field is read piece by piece only if its cells are tetrahedra, none of them a "
                  "ghost; make such a file with tensortopo convert");
  return read;
}

}  // namespace

FieldPieces::FieldPieces(const std::filesystem::path& file, const ReadOptions& options)
    : file_(file), options_(options) {
  if (lower_extension(file) != ".pvtu")
    throw IoError(IoError::Kind::inapplicable, file,
                  "only a .pvtu, a field in pieces, is read piece by piece");
  if (const char* const option = options.making_others())
    throw IoError(IoError::Kind::inapplicable, file,
                  std::string(option) + " does not go with reading piece by piece");
  std::set<std::filesystem::path> seen;
  files_ = detail::read_pvtu(detail::load(file));
  for (const auto& piece : files_)
    if (!seen.insert(std::filesystem::weakly_canonical(piece)).second)
      throw IoError(IoError::Kind::invalid, file,
                    "names a piece twice (" + piece.filename().string() + ")");
  report_ = read_plain(files_.front(), options_).report;
}

TetMesh FieldPieces::read(std::int32_t piece) const {
  const auto& file = files_[as_size(piece)];
  ReadResult read = read_plain(file, options_);
  if (read.report.tensor_name != report_.tensor_name ||
      read.report.components.order != report_.components.order)
    throw IoError(IoError::Kind::invalid, file,
                  "the tensors have another name or order than those of the first piece");
  return std::move(read.mesh);
}

std::string FieldPieces::sha256() const {
  Sha256 sum;
  sum.add(detail::load(file_)->bytes);
  for (const auto& piece : files_) sum.add(detail::load(piece)->bytes);
  return sum.hex();
}

}  // namespace tensortopo
