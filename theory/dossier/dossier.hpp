// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tensortopo::theory {

/// The page on all statements, as Markdown.
std::string dossier();

}  // namespace tensortopo::theory
