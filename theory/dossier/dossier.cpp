// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "dossier.hpp"

#include <algorithm>
#include <sstream>

#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory {
namespace {

constexpr std::string_view kIntroduction = R"(# theory

What the paper says, whether it is true, under which hypotheses, what is true instead where it is not, and an exact witness where it
fails. *The paper* is Qu, Roy, Zhang and Zhang, "Mode Surfaces of Symmetric Tensor Fields: Topological Analysis and Seamless
Extraction" (2020). This page is written by a program from the statements in `src`; a build fails if the two differ, and
`cmake --build BUILD --target theory_readme` writes it again.

- **A statement is a program.** `tensortopo verify` tries each on random linear fields with rational entries, special ones among them;
  `--theorem ID` chooses, `--input MESH` takes the fields of a mesh's tetrahedra. Prose alone is not a statement.
- **What decides.** Over `rational` (the default) everything, without rounding or tolerance. Over `interval`, `real100` and `double` numbers
  carry a bound on their error: a strict sign is certain, an equality can be refuted and is otherwise left open, with its width.
- **Holds** means that every field that satisfies the hypotheses has passed; **corrected**, that the paper's wording is violated at a
  witness, which every run checks again, and that ours has passed. Passing is evidence, not proof: the proofs, step by step, are in
  `proofs-check`.
- **Whether it would notice.** The tests change each number of each claim by one, up and down, and want a violation.

Words: *T* is a traceless symmetric tensor; the *characteristic tensor* is the one orthogonal to all tensors of a linear field, *l1 >= l2 >= l3* its
eigenvalues; *s* is the parameter of a mode mu = s (9 - s^2) / (3 + s^2)^(3/2); *in projective space* means with the points at
infinity. Tensors are listed as [xx, yy, zz, xy, yz, xz]. `notation.md` has every symbol against its name in code.
)";

constexpr std::string_view kClosing = R"(
## How it is made

- `random.hpp`: a generator of its own, so that a seed means the same numbers everywhere.
- `trial.hpp`: the fields. A part of them is made from a rational eigen-frame of the characteristic tensor, which makes statements
  about its eigenvalues decidable; others are neutral, planar degenerate or of a rank below 4.
- `facts.hpp`, `check.hpp`: a check states facts about numbers; the arithmetic decides them as far as it can. Numbers that belong to
  the claim are asked for one by one, so that a test can make any of them wrong.
- `statement.hpp`, `verify.hpp`: the list `statements()`, and what trying one gives.

To add a statement: a check in the group of `src` that it belongs to, and an entry in that group's list. If the paper's wording
fails, the entry says what is true instead and carries a function that tries the paper's wording at a witness.
)";

bool is_ours(const Statement& s) { return s.paper.starts_with("none"); }

std::string_view verdict_of(const Statement& s) {
  return s.corrected.empty() ? "holds" : "corrected";
}

std::string place_of(const Statement& s) {
  if (!is_ours(s)) return s.paper;
  const auto bracket = s.paper.find('(');
  if (bracket == std::string::npos) return "ours";
  return "ours: " + s.paper.substr(bracket + 1, s.paper.size() - bracket - 2);
}

// Stars and bars mean something in Markdown.
std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words) {
    if (c == '*' || c == '|' || c == '_' || c == '<') result += '\\';
    result += c;
  }
  return result;
}

void add_line(std::ostringstream& out, std::string_view heading, const std::string& words) {
  if (!words.empty()) out << "- **" << heading << "** " << escaped(words) << '\n';
}

void add_page(std::ostringstream& out, const Statement& s) {
  out << "\n### " << s.id << "\n\n";
  out << "*" << escaped(place_of(s)) << "*: **" << verdict_of(s) << "**\n\n";
  add_line(out, is_ours(s) ? "Says:" : "The paper says:", s.claim);
  add_line(out, "True is:", s.corrected);
  add_line(out, "Sharper:", s.sharper);
  add_line(out, "Tried on:", s.hypotheses);
  add_line(out, "Special fields:", s.strata);
  if (s.paper_at_witness) add_line(out, "Witness:", s.paper_at_witness().detail);
  if (!s.check.suffices(Arithmetic::interval)) add_line(out, "Numbers:", "rational only");
}

}  // namespace

std::string dossier() {
  std::ostringstream out;
  const auto& all = statements();
  const auto corrected = std::count_if(all.begin(), all.end(),
                                       [](const Statement& s) { return !s.corrected.empty(); });
  const auto ours = std::count_if(all.begin(), all.end(), is_ours);
  out << kIntroduction << "\n## Statements\n\n"
      << all.size() << " statements, " << ours << " of them ours; " << corrected
      << " correct the paper.\n\n"
      << "| id | in the paper | verdict |\n| --- | --- | --- |\n";
  for (const Statement& s : all) {
    out << "| [" << s.id << "](#" << s.id << ") | " << escaped(place_of(s)) << " | "
        << verdict_of(s) << " |\n";
  }
  out << "\n## One by one\n";
  for (const Statement& s : all) add_page(out, s);
  out << kClosing;
  return out.str();
}

}  // namespace tensortopo::theory
