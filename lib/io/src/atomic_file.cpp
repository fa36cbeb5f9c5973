// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo::detail {
namespace {

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// A file of a fresh name beside another, removed unless it is kept.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& beside) {
    static std::atomic<unsigned> counter{0};
    for (int tries = 0; descriptor_ < 0; ++tries) {
      path_ = beside.parent_path() / (".tensortopo-" + std::to_string(getpid()) + "-" +
                                      std::to_string(counter++) + ".tmp");
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && (errno != EEXIST || tries == 1000)) fail(errno);
    }
  }
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }
  void become(const std::filesystem::path& file) {
    if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
    std::filesystem::rename(path_, file);
    path_.clear();
  }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Devices and pipes have no place to rename to.
void write_in_place(const std::filesystem::path& file, std::string_view bytes) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(errno);
  try {
    write_all(descriptor, bytes);
  } catch (...) {
    close(descriptor);
    throw;
  }
  if (close(descriptor) != 0) fail(errno);
}

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  namespace fs = std::filesystem;
  try {
    const fs::file_status status = fs::status(file);
    if (fs::is_directory(status)) fail(EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(file, bytes);
    // A link stays one: its target is replaced.
    const fs::path target = fs::exists(status) ? fs::canonical(file) : file;
    Temporary temporary(target);
    write_all(temporary.descriptor(), bytes);
    temporary.become(target);
  } catch (const std::system_error& error) {
    throw IoError(IoError::Kind::unwritable, file, "cannot be written: " + error.code().message());
  }
}

}  // namespace tensortopo::detail
