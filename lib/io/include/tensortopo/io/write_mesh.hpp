// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Numbers of a field's points, one each, for a file.
struct PointArray {
  std::string name;            ///< in the file
  std::vector<double> values;  ///< one for each point
};

/// Writes a field as .vtu: inline binary, zlib, 6 components XX YY ZZ XY YZ XZ named so and marked
/// as the tensors; and further arrays.
///
/// Laws      read_mesh gives back points, tensors and tetrahedra bit for bit (if the mesh is valid
///           and positively oriented); `cell_ids` are numbered anew. Whole or not at all.
/// Throws    IoError (`unwritable`, also for a name that does not end in .vtu),
///           std::invalid_argument.
void write_mesh(const TetMesh& mesh, const std::filesystem::path& file,
                const std::string& tensor_name = "stress",
                const std::vector<PointArray>& more = {});

/// Writes the list (.pvtu) of files of `write_mesh` that are the pieces of one field.
/// @param pieces  in the same folder
void write_piece_list(const std::vector<std::filesystem::path>& pieces,
                      const std::filesystem::path& file, const std::string& tensor_name = "stress");

}  // namespace tensortopo
