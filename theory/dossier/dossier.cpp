// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "dossier.hpp"

#include <algorithm>
#include <sstream>

#include "tensortopo/theory/statement.hpp"
#include "texts.hpp"

namespace tensortopo::theory {
namespace {

bool is_ours(const Statement& s) { return s.paper.starts_with("none"); }
bool is_corrected(const Statement& s) { return !s.corrected.empty(); }

std::string_view verdict_of(const Statement& s) { return is_corrected(s) ? "corrected" : "holds"; }

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

std::string link_to(const Statement& s) { return "[" + s.id + "](#" + s.id + ")"; }

std::string flaws_of(const Statement& s) {
  std::string words;
  for (const Flaw flaw : s.flaws) {
    words += (words.empty() ? "" : "; ") + std::string(name(flaw));
  }
  return words;
}

std::vector<const MachineChecked*> theorems_of(const Statement& s, const Theorems& theorems) {
  std::vector<const MachineChecked*> result;
  for (const MachineChecked& t : theorems) {
    const bool is_step = std::find(s.steps.begin(), s.steps.end(), t.id) != s.steps.end();
    if (t.id == s.id || is_step) result.push_back(&t);
  }
  return result;
}

// The ways in which a statement is established, in a few words.
std::string ways_of(const Statement& s, const Theorems& theorems) {
  const std::size_t coq = theorems_of(s, theorems).size();
  std::string words;
  const auto add = [&](const std::string& way) { words += (words.empty() ? "" : ", ") + way; };
  if (coq > 0) add("Coq (" + std::to_string(coq) + ")");
  if (!s.steps.empty()) add("steps (" + std::to_string(s.steps.size()) + ")");
  add(s.restates.empty() ? "tried" : "tried (restates a definition)");
  if (!s.reader.empty()) add("reader");
  return words;
}

void add_line(std::ostringstream& out, std::string_view heading, const std::string& words) {
  if (!words.empty()) out << "- **" << heading << "** " << escaped(words) << '\n';
}

void add_page(std::ostringstream& out, const Statement& s, const Theorems& theorems) {
  out << "\n### " << s.id << "\n\n";
  out << "*" << escaped(place_of(s)) << "*: **" << verdict_of(s) << "**";
  if (is_corrected(s)) out << " (" << flaws_of(s) << ")";
  out << "\n\n";
  add_line(out, is_ours(s) ? "Says:" : "The paper says:", s.claim);
  add_line(out, "True is:", s.corrected);
  add_line(out, "Sharper:", s.sharper);
  add_line(out, "Tried on:", s.hypotheses);
  add_line(out, "Special fields:", s.special);
  if (s.paper_at_witness) add_line(out, "Witness:", s.paper_at_witness().detail);
  for (const Needed& needed : s.needed) {
    add_line(out, "Needed:", needed.hypothesis + ". Without it: " + needed.without().detail);
  }
  add_line(out, "Other hypotheses:", s.unneeded);
  for (const MachineChecked* t : theorems_of(s, theorems)) {
    add_line(out, "Coq:", t->wording + " (`" + t->theorem + "` in `" + t->file + ".v`)");
  }
  if (!s.steps.empty()) {
    std::string steps;
    for (const std::string& id : s.steps) steps += (steps.empty() ? "`" : ", `") + id + "`";
    out << "- **Exact steps:** " << steps << '\n';
  }
  if (!s.restates.empty()) {
    add_line(out, "The trials check no more than:", s.restates + ".");
  }
  if (!s.check.suffices(Arithmetic::interval)) add_line(out, "Numbers:", "rational only");
}

void add_table(std::ostringstream& out, const std::vector<Statement>& all,
               const Theorems& theorems) {
  const auto count = [&](const auto& condition) {
    return std::count_if(all.begin(), all.end(), condition);
  };
  const auto ours = count(is_ours);
  out << "\n## Statements\n\n"
      << all.size() << " statements: " << all.size() - static_cast<std::size_t>(ours)
      << " of the paper, of which " << count(is_corrected) << " are corrected, and " << ours
      << " of ours. "
      << count([&](const Statement& s) { return !theorems_of(s, theorems).empty(); })
      << " have theorems in Coq, " << count([](const Statement& s) { return !s.steps.empty(); })
      << " have exact steps, all are tried; in "
      << count([](const Statement& s) { return !s.reader.empty(); })
      << " something is left to a reader.\n\n"
      << "| id | in the paper | verdict | established by |\n| --- | --- | --- | --- |\n";
  for (const Statement& s : all) {
    out << "| " << link_to(s) << " | " << escaped(place_of(s)) << " | " << verdict_of(s) << " | "
        << ways_of(s, theorems) << " |\n";
  }
}

void add_corrections(std::ostringstream& out, const std::vector<Statement>& all) {
  out << "\n## The corrections, sorted\n\n"
         "Most are small. A statement can be in two rows.\n\n"
         "| what is wrong | how many | statements |\n| --- | --- | --- |\n";
  for (const Flaw flaw : kFlaws) {
    std::string ids;
    int count = 0;
    for (const Statement& s : all) {
      if (std::find(s.flaws.begin(), s.flaws.end(), flaw) == s.flaws.end()) continue;
      ids += (ids.empty() ? "" : ", ") + link_to(s);
      ++count;
    }
    out << "| " << name(flaw) << " | " << count << " | " << ids << " |\n";
  }
  out << "\n*Projective, not affine*: true if the points at infinity are counted; the paper speaks "
         "of "
         "points in space.\n*Excluded by structural stability*: false for fields that an "
         "arbitrarily "
         "small change makes regular. The paper excludes them; symmetric data have them.\n"
         "*Substantive*: what is concluded or computed has to change.\n";
}

void add_inferences(std::ostringstream& out, const std::vector<Statement>& all,
                    const Theorems& theorems) {
  out << "\n## What is left to a reader\n\n"
         "Inferences in words, which no program has checked. What the steps and theorems named on "
         "each statement's entry prove is not repeated.\n\n";
  for (const Statement& s : all) {
    if (!s.reader.empty()) out << "- " << link_to(s) << ": " << escaped(s.reader) << '\n';
  }
  out << kExtraction;
  for (const MachineChecked& t : theorems) {
    const bool is_listed = std::any_of(all.begin(), all.end(), [&](const Statement& s) {
      return t.id == s.id || std::find(s.steps.begin(), s.steps.end(), t.id) != s.steps.end();
    });
    if (is_listed) continue;
    out << "- Coq, " << t.id << ": " << escaped(t.wording) << " (`" << t.theorem << "` in `"
        << t.file << ".v`)\n";
  }
}

}  // namespace

std::string dossier(const Theorems& theorems) {
  std::ostringstream out;
  const auto& all = statements();
  out << kIntroduction;
  add_table(out, all, theorems);
  add_corrections(out, all);
  out << kErrata;
  add_inferences(out, all, theorems);
  out << "\n## One by one\n";
  for (const Statement& s : all) add_page(out, s, theorems);
  out << kClosing;
  return out.str();
}

}  // namespace tensortopo::theory
