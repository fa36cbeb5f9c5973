// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The files of `page/`, which the build makes text of.
namespace tensortopo::page_sources {

extern const std::string_view frame, style, scene_script, report_script;

}  // namespace tensortopo::page_sources
