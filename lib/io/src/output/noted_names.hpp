// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace tensortopo::detail {

/// A name that `remove_unfinished_files` removes.
struct Noted;

enum class NotedKind { file, folder };

/// Notes a name, before there is anything of this name. A folder is noted before what is in it, and
/// empty when that is removed.
Noted* note(const std::filesystem::path& path, NotedKind kind);

/// There is no such thing any more, or it stays.
void forget(Noted* noted);

}  // namespace tensortopo::detail
