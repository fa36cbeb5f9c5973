// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tensortopo::theory {

/// A theorem that Coq has checked: a line of proofs-check/coq/statements.txt.
struct MachineChecked {
  std::string id;  ///< of a statement, or of a step
  std::string file, theorem, wording;
};
using Theorems = std::vector<MachineChecked>;

/// The page on all statements, in Markdown.
std::string dossier(const Theorems& theorems);

}  // namespace tensortopo::theory
