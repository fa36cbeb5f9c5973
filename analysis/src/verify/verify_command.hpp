// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/theory/verify.hpp"

namespace tensortopo {

/// Which statements to try, and on what.
struct VerifyCommand {
  std::vector<std::string> theorems;  ///< ids, or the paper's numbers; none: all statements
  std::size_t fields = 100;           ///< at least 1
  std::uint64_t seed = 1;
  std::string scalar = "rational";  ///< or interval, real100, double
  std::filesystem::path input;      ///< a mesh whose tetrahedra are the fields; may be empty
  ReadOptions read;                 ///< of the mesh
};

/// How often the linear fields of a mesh lack what the statements ask for.
struct MeshStrata {
  std::filesystem::path file;
  std::string sha256;
  TensorComponents components;     ///< in the input
  std::vector<std::string> notes;  ///< of reading
  std::size_t tetrahedra = 0;
  std::size_t tried = 0;  ///< of the tetrahedra, as fields
  std::array<std::size_t, 5> of_rank{};
  std::size_t with_zero_vertex = 0;
  std::size_t with_common_eigenvector = 0;
  std::size_t neutral_characteristic = 0;
  std::size_t degenerate_characteristic = 0;
  /// The least and the greatest mode of the characteristic tensors, which are in [-1, 0]; rounded.
  /// Nothing if no tetrahedron has rank 4.
  std::optional<std::array<double, 2>> characteristic_modes;
};

struct VerifyReport {
  theory::Arithmetic arithmetic = theory::Arithmetic::rational;
  std::vector<theory::Verification> statements;  ///< in the order of the paper
  std::optional<MeshStrata> mesh;
  /// Nothing is refuted and nothing undecided.
  bool all_established() const;
};

/// Tries the statements on the fields of the seed, or on tetrahedra of a mesh that lie evenly in
/// its order. Throws UsageError for a name that no statement has (and names those that there are)
/// and for a scalar that there is not, IoError for a mesh that can't be read.
VerifyReport run_verify(const VerifyCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const VerifyReport& report);
/// A table for people. Ends with a newline.
std::string to_text(const VerifyReport& report);

}  // namespace tensortopo
