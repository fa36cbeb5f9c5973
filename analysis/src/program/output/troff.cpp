// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/output/troff.hpp"

#include <string>

namespace tensortopo {
namespace {

/// Text as troff shows it: no line begins with a control character, and a minus is a minus.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

void add_options(const CLI::App& app, std::string& page) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    page += ".TP\n.B " + escaped(option->get_name(option->get_positional(), true));
    const std::string type = option->get_type_name();
    if (option->get_expected_max() > 0 && !type.empty()) page += "\\fR \\fI" + escaped(type) + "\\fR";
    page += '\n' + escaped(option->get_description()) + '\n';
  }
}

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& footer) {
  std::string page = ".TH TENSORTOPO 1\n.SH NAME\ntensortopo \\- " +
                     escaped(program.get_description()) +
                     "\n.SH SYNOPSIS\n.B tensortopo\n.I SUBCOMMAND\n[\\fIOPTION\\fR]...\n";
  page += ".SH OPTIONS\n";
  add_options(program, page);
  for (const CLI::App* sub : program.get_subcommands({})) {
    page += ".SH TENSORTOPO " + escaped(sub->get_name()) + '\n' + escaped(sub->get_description()) +
            '\n';
    add_options(*sub, page);
  }
  return page + ".SH EXIT STATUS\n" + escaped(footer) + '\n';
}

}  // namespace tensortopo
