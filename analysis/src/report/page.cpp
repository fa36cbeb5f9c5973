// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "report/page.hpp"

#include "report/page_arrays.hpp"
#include "report/page_sources.hpp"

namespace tensortopo {

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string json_for_script(std::string json) {
  std::string result;
  for (const char c : json)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

std::string page_of(const std::map<std::string, std::string>& parts) {
  const std::string script =
      std::string(page_sources::scene_script) + std::string(page_sources::report_script);
  const std::string style(page_sources::style);
  std::map<std::string, std::string> all = parts;
  all["SCRIPT"] = script, all["STYLE"] = style;
  all["SCRIPT_HASH"] = policy_hash(script), all["STYLE_HASH"] = policy_hash(style);
  const std::string_view frame = page_sources::frame;
  std::string page;
  for (std::size_t at = 0; at < frame.size();) {
    const std::size_t start = frame.find('@', at);
    const std::size_t end = start == frame.npos ? frame.npos : frame.find('@', start + 1);
    if (end == frame.npos) {
      page += frame.substr(at);
      break;
    }
    const auto found = all.find(std::string(frame.substr(start + 1, end - start - 1)));
    page += frame.substr(at, start - at);
    if (found != all.end())
      page += found->second, at = end + 1;
    else
      page += '@', at = start + 1;
  }
  return page;
}

}  // namespace tensortopo
