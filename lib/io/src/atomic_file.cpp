// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <list>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "noted_names.hpp"
#include "tensortopo/io/file_group.hpp"
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
    for (int tries = 0;; ++tries) {
      path_ = beside.parent_path() / (".tensortopo-" + std::to_string(getpid()) + "-" +
                                      std::to_string(counter++) + ".tmp");
      // Noted first: a signal may come as soon as the file is there.
      noted_ = note(path_, NotedKind::file);
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ >= 0) break;
      const int error = errno;
      forget(noted_);
      if (error != EEXIST || tries == 1000) fail(error);
    }
  }
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
    forget(noted_);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }
  void close() {
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  }
  void become(const std::filesystem::path& file) {
    std::filesystem::rename(path_, file);
    path_.clear();
  }

 private:
  std::filesystem::path path_;
  Noted* noted_ = nullptr;
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

/// Where a chain of links that ends at nothing leads to.
std::filesystem::path end_of_links(std::filesystem::path file) {
  for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(file)); ++links) {
    if (links == 40) fail(ELOOP);
    file = file.parent_path() / std::filesystem::read_symlink(file);
  }
  return file;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::error_code& why) {
  throw IoError(IoError::Kind::unwritable, file, "cannot be written: " + why.message());
}

}  // namespace

/// What a group has written, and where it belongs.
struct UnfinishedFiles {
  struct File {
    File(const std::filesystem::path& as_given, const std::filesystem::path& target)
        : given(as_given), place(target), temporary(target) {}
    std::filesystem::path given, place;
    Temporary temporary;
  };
  std::list<File> files;
};

namespace {

thread_local UnfinishedFiles* current_group = nullptr;

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  namespace fs = std::filesystem;
  try {
    const fs::file_status status = fs::status(file);
    if (fs::is_directory(status)) fail(EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(file, bytes);
    // A link stays one: its target is replaced, or made.
    const fs::path target = fs::exists(status) ? fs::canonical(file) : end_of_links(file);
    UnfinishedFiles alone;
    UnfinishedFiles& group = current_group != nullptr ? *current_group : alone;
    group.files.emplace_back(file, target);
    Temporary& temporary = group.files.back().temporary;
    write_all(temporary.descriptor(), bytes);
    temporary.close();
    if (current_group == nullptr) temporary.become(target);
  } catch (const std::system_error& error) {
    refuse(file, error.code());
  }
}

}  // namespace tensortopo::detail

namespace tensortopo {

FileGroup::FileGroup(Bond bond)
    : files_(std::make_unique<detail::UnfinishedFiles>()),
      outer_(std::exchange(detail::current_group, files_.get())),
      bond_(bond) {}

FileGroup::~FileGroup() { detail::current_group = outer_; }

void FileGroup::commit() {
  if (outer_ != nullptr && bond_ == Bond::joined)
    return outer_->files.splice(outer_->files.end(), files_->files);
  for (auto& file : files_->files) {
    try {
      file.temporary.become(file.place);
    } catch (const std::system_error& error) {
      detail::refuse(file.given, error.code());
    }
  }
  files_->files.clear();
}

}  // namespace tensortopo
