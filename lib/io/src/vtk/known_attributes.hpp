// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>

namespace tensortopo::detail {

/// An attribute of a VTK XML file, in words, that the checker of certificates refuses, because some
/// readers may obey it and others not (such as `TimeStep`); if there is one.
std::optional<std::string> unknown_attribute(const pugi::xml_node& root);

}  // namespace tensortopo::detail
