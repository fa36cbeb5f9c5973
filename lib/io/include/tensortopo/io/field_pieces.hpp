// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// The field that a .pvtu names the pieces of, which are read one at a time.
///
/// The pieces must be made of tetrahedra, all of them the piece's own: then positions in the
/// pieces, one after the other, are what `read_mesh` calls the cells of the whole. Options that
/// make another mesh of the file are refused (IoError, inapplicable).
class FieldPieces {
 public:
  /// Reads the list of pieces, and the first of them. Throws IoError.
  FieldPieces(const std::filesystem::path& file, const ReadOptions& options);

  /// The number of pieces.
  std::int32_t size() const { return static_cast<std::int32_t>(files_.size()); }
  /// A piece, with points of its own. Throws IoError, also for a piece whose tensors have another
  /// name or order than those of the first.
  TetMesh read(std::int32_t piece) const;
  /// Of the first piece.
  const ReadReport& report() const { return report_; }
  /// As `ReadResult::sha256` of the whole; reads all files.
  std::string sha256() const;

 private:
  std::filesystem::path file_;
  ReadOptions options_;
  std::vector<std::filesystem::path> files_;
  ReadReport report_;
};

}  // namespace tensortopo
