// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace certificate {

/// A file that cannot be read as what it should be; what() is "FILE: what is wrong".
class Malformed : public std::runtime_error {
 public:
  Malformed(const std::string& file, const std::string& problem)
      : std::runtime_error(file + ": " + problem), file_(file), problem_(problem) {}

  const std::string& file() const { return file_; }
  const std::string& problem() const { return problem_; }

 private:
  std::string file_, problem_;
};

/// A claim that is wrong, or could not be decided.
struct Finding {
  std::string entity, claimed, derived;
};

/// What came of the claims of one kind.
struct Verdicts {
  std::string kind;
  std::size_t certified = 0, refuted = 0, undecided = 0;
};

/// What came of a certificate's claims, each counted once.
struct Report {
  std::size_t certified = 0, refuted = 0, undecided = 0;
  std::vector<Verdicts> kinds;  ///< the same by kind
  /// How many sides and proofs were settled by doubles with an error bound, and by integers.
  std::uint64_t by_balls = 0, by_integers = 0;
  std::vector<Finding> refutations;  ///< the first ones
  std::vector<Finding> open;         ///< the first undecided ones

  std::size_t claims() const { return certified + refuted + undecided; }
  /// "refuted" if one claim is, else "undecided" if one is, else "certified".
  std::string status() const;
};

/// Told now and then, by the thread that called, what is derived and how much of it, in [0, 1].
using Progress = std::function<void(std::string_view what, double part)>;

/// Checks each claim of a certificate (proofs-check/certificate/FORMAT.md) about the field in
/// `input` (.vtu, .vtk) and the triangles in `surface` (.vtp), deriving the truth from the input's bits.
/// The report does not depend on the number of threads. Throws Malformed, std::bad_alloc.
Report check_certificate(const std::string& input, const std::string& surface,
                         const std::string& certificate, const Progress& progress = {});

std::string to_text(const Report& report);
std::string to_json(const Report& report);

}  // namespace certificate
