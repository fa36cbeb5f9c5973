// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tensortopo {

/// What a certificate that was written holds.
struct CertificateReport {
  std::filesystem::path path;
  std::uintmax_t bytes = 0;
  std::size_t certified = 0;  ///< claims: on edges, faces, tetrahedra, components, distances
  std::map<std::string, std::size_t> kinds;      ///< the same by kind
  std::map<std::string, std::size_t> undecided;  ///< tetrahedra, over all modes, by reason
  std::size_t undecided_cells = 0;
  /// Of the first of these the number in the file, and the reason.
  std::vector<std::pair<std::int64_t, std::string>> listed;
  /// Proved by arguments that the checker does not have, which it may leave open: sheets that are
  /// thin tubes, and tetrahedra taken at a mode next to a critical one.
  std::size_t tubes = 0, at_critical = 0;
  bool counts_beyond_checker = true;  ///< whether these are known
  double seconds = 0;  ///< proofs beyond the extraction's, and writing
};

}  // namespace tensortopo
