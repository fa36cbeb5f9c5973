// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/output/help.hpp"

#include <algorithm>
#include <cctype>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "program/output/conventions.hpp"
#include "program/output/report_output.hpp"
#include "program/output/troff.hpp"

namespace tensortopo {
namespace {

constexpr const char* kFooter =
    "Exit status: 0 done; 1 done, but something is refuted, or undecided where certainty was asked "
    "for; 2 bad usage; 3 bad input; 4 cannot write.\n"
    "tensortopo help conventions: the formula of the mode, orders of components, units.";

class Style : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    for (const char* list : {" Excludes: ", " Needs: "})
      if (const auto at = text.find(list); at != std::string::npos) text.erase(at);
    return text;
  }
};

/// Insertions, deletions, changes and exchanges of neighbours from one word to another.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        least[i][j] = i + j;
        continue;
      }
      least[i][j] = std::min({least[i - 1][j] + 1, least[i][j - 1] + 1,
                              least[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
    }
  return least[a.size()][b.size()];
}

/// "; did you mean X?" for the nearest of some words, "" if none is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const std::string* nearest = nullptr;
  std::size_t least = 3;
  for (const std::string& candidate : known) {
    const bool is_beginning = word.size() > 3 && candidate.starts_with(word);
    const std::size_t distance = is_beginning ? 0 : edits(word, candidate);
    if (distance < least && 2 * distance < word.size()) least = distance, nearest = &candidate;
  }
  return nearest == nullptr ? "" : "; did you mean " + *nearest + "?";
}

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> subcommand_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* sub : program.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

const CLI::App* find_subcommand(const CLI::App& program, const std::string& name) {
  for (const CLI::App* sub : program.get_subcommands({}))
    if (sub->get_name() == name) return sub;
  return nullptr;
}

bool is_number(std::string_view word) {
  return word.size() > 1 && (std::isdigit(static_cast<unsigned char>(word[1])) || word[1] == '.');
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string bash_completion(const CLI::App& program) {
  std::string text =
      "# Completion for bash: source this file, or put it in\n"
      "# /usr/share/bash-completion/completions/tensortopo.\n"
      "_tensortopo() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} words=\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    words='--help --version " +
      joined(subcommand_names(program)) +
      "'\n  elif [[ $current == -* ]]; then\n    case ${COMP_WORDS[1]} in\n";
  for (const CLI::App* sub : program.get_subcommands({}))
    text += "      " + sub->get_name() + ") words='" + joined(long_names(*sub)) + "' ;;\n";
  return text +
         "    esac\n  fi\n"
         "  if [ -n \"$words\" ]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
         "  fi\n}\n"
         "complete -o bashdefault -o default -F _tensortopo tensortopo\n";
}

ExitStatus help(const CLI::App& program, const std::string& topic) {
  if (topic.empty()) {
    print(program.help());
  } else if (topic == "conventions") {
    print(kConventions);
  } else if (topic == "man") {
    print(manual_page(program, kFooter));
  } else if (topic == "completion") {
    print(bash_completion(program));
  } else {
    const CLI::App* sub = find_subcommand(program, topic);
    if (sub == nullptr) {
      std::vector<std::string> known = subcommand_names(program);
      known.insert(known.end(), {"conventions", "man", "completion"});
      throw UsageError("help: there is no topic '" + topic + "'" + suggestion(topic, known));
    }
    print(sub->help("tensortopo"));
  }
  return ExitStatus::done;
}

}  // namespace

void set_help_style(CLI::App& program) {
  const auto style = std::make_shared<Style>();
  style->column_width(34);
  program.formatter(style);
  program.footer(kFooter);
}

void add_help_subcommand(CLI::App& program, CommonOptions&, Action& action) {
  CLI::App& app = *program.add_subcommand(
      "help", "Help on a subcommand; conventions; a manual page; completion for bash");
  const auto topic = std::make_shared<std::string>();
  app.add_option("TOPIC", *topic, "A subcommand, conventions, man, or completion");
  app.callback([topic, &program, &action] {
    action = [topic, &program] { return help(program, *topic); };
  });
}

std::string unknown_word(const CLI::App& program, int argc, const char* const* argv) {
  if (argc < 2) return "";
  const std::string first = argv[1];
  const CLI::App* sub = find_subcommand(program, first);
  if (sub == nullptr) {
    if (first.starts_with("-"))
      return program.get_option_no_throw(first) != nullptr
                 ? ""
                 : "there is no option '" + first + "'" + suggestion(first, long_names(program)) +
                       " (see tensortopo --help)";
    return "there is no subcommand '" + first + "'" +
           suggestion(first, subcommand_names(program)) + " (see tensortopo --help)";
  }
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("-") || word == "-" || word == "--" || is_number(word)) continue;
    const std::string name = word.substr(0, word.find('='));
    // One letter may have its value behind it.
    const std::string option = name.starts_with("--") ? name : name.substr(0, 2);
    if (sub->get_option_no_throw(option) != nullptr) continue;
    return "tensortopo " + first + " has no option '" + name + "'" +
           suggestion(name, long_names(*sub)) + " (see tensortopo " + first + " --help)";
  }
  return "";
}

}  // namespace tensortopo
