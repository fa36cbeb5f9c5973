// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tensortopo {

/// Text for HTML: what is special to it is replaced.
std::string html_text(std::string_view text);

/// JSON for a script element: nothing in it can end that.
std::string json_for_script(std::string json);

/// The page with its parts: TITLE, FIELD, SWEEP, CERTIFICATE (HTML), FACTS (JSON for a script) and
/// GEOMETRY (base64). Scripts and styles are the program's own, and named by their hashes in the
/// page's content security policy.
std::string page_of(const std::map<std::string, std::string>& parts);

}  // namespace tensortopo
