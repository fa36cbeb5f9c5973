// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "output/noted_names.hpp"

#include <unistd.h>

#include <atomic>
#include <string>

#include "tensortopo/io/file_group.hpp"

namespace tensortopo {
namespace detail {

/// For a handler that may interrupt anything: entries are never changed but for the flag, nor
/// freed.
struct Noted {
  std::string path;
  NotedKind kind;
  std::atomic<bool> exists{true};
  Noted* next = nullptr;
};

namespace {

std::atomic<Noted*> last_noted{nullptr};

}  // namespace

Noted* note(const std::filesystem::path& path, NotedKind kind) {
  auto* const entry = new Noted{path.string(), kind};
  entry->next = last_noted.load();
  while (!last_noted.compare_exchange_weak(entry->next, entry)) {
  }
  return entry;
}

void forget(Noted* noted) { noted->exists = false; }

}  // namespace detail

void remove_unfinished_files() noexcept {
  // What was noted last comes first, so that folders are empty.
  for (auto* entry = detail::last_noted.load(); entry != nullptr; entry = entry->next) {
    if (!entry->exists) continue;
    if (entry->kind == detail::NotedKind::file) unlink(entry->path.c_str());
    if (entry->kind == detail::NotedKind::folder) rmdir(entry->path.c_str());
  }
}

}  // namespace tensortopo
