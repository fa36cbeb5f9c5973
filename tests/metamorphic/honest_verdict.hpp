// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "cases.hpp"
#include "proofs-check/forgeries/forgery.hpp"

namespace tensortopo::test {

/// What the independent checker makes of honest certificates.
struct HonestVerdict {
  std::string status;  ///< "certified", "refuted", "undecided" or "malformed"
  /// How many claims are open, by reason: "extractor: NAME" for tetrahedra about which the
  /// extractor claims nothing, "checker: KIND" for claims that the checker could not decide.
  std::map<std::string, int> open;
  std::string report;
  std::size_t triangles = 0, claims = 0;
  std::size_t vectors = 0, vectors_shown = 0;  ///< eigenvectors and normals
};

/// Extracts surfaces with certificates and has them checked by files in a folder of its own.
class HonestCourt {
 public:
  explicit HonestCourt(const std::string& name);
  ~HonestCourt();
  HonestCourt(const HonestCourt&) = delete;
  HonestCourt& operator=(const HonestCourt&) = delete;

  HonestVerdict judge(const Exhibit& exhibit) const;
  HonestVerdict judge(const FieldCase& c) const { return judge(exhibit_with_arrays(c.mesh, {c.mode})); }

 private:
  std::filesystem::path folder_;
};

}  // namespace tensortopo::test
