// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/exhaustion.hpp"

#include <fcntl.h>
#include <gmp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <system_error>

#include "tensortopo/analysis/exit_status.hpp"
#include "tensortopo/io/file_group.hpp"

namespace tensortopo {
namespace {

constexpr const char* out_of_memory = "out of memory";

/// Calls nothing that allocates.
[[noreturn]] void end(const char* problem, ExitStatus status) {
  remove_unfinished_files();
  for (const char* part : {"tensortopo: ", problem, "\n"})
    if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
  _exit(static_cast<int>(status));
}

void end_for_terminate() {
  if (const auto error = std::current_exception()) {
    try {
      std::rethrow_exception(error);
    } catch (const std::exception& known) {
      if (const char* what = exhausted(known)) end(what, ExitStatus::bad_input);
    } catch (...) {
    }
  }
  end("internal error: an exception where none may be", ExitStatus::our_fault);
}

/// Whether the address space is nearly used up. Makes nothing but system calls.
bool is_short_of_memory() {
  constexpr rlim_t margin = 256u << 20;  // what a library may ask for at once
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
  std::array<char, 32> text{};
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  const bool known = file >= 0 && read(file, text.data(), text.size() - 1) > 0;
  if (file >= 0) close(file);
  rlim_t pages = 0;
  for (const char* c = text.data(); *c >= '0' && *c <= '9'; ++c)
    pages = 10 * pages + static_cast<rlim_t>(*c - '0');
  return known && pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + margin > limit.rlim_cur;
}

/// Libraries that draw abort where they get no memory.
extern "C" void end_for_abort(int) {
  if (is_short_of_memory()) end(out_of_memory, ExitStatus::bad_input);
  end("internal error: a library gave up", ExitStatus::our_fault);
}

// GMP has no way to go on without memory: it would abort.
void* checked(void* memory) {
  if (memory == nullptr) end(out_of_memory, ExitStatus::bad_input);
  return memory;
}
void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* memory, std::size_t, std::size_t size) {
  return checked(std::realloc(memory, size));
}
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void prepare_for_exhaustion() {
  std::set_terminate(end_for_terminate);
  std::signal(SIGABRT, end_for_abort);
  mp_set_memory_functions(allocate, reallocate, release);
}

const char* exhausted(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return out_of_memory;
  // When the system gives no thread: what the standard library throws, and what oneTBB does.
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  if ((system != nullptr && system->code() == std::errc::resource_unavailable_try_again) ||
      std::string_view(error.what()).starts_with("pthread_create"))
    return "cannot start threads: too little memory, or too many processes";
  return nullptr;
}

}  // namespace tensortopo
