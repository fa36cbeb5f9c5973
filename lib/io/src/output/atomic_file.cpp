// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "output/atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <list>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "output/noted_names.hpp"
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

/// Descriptors of files without a name that are open at a time; the system grants a thousand or so.
constexpr int most_nameless = 200;
std::atomic<int> nameless{0};

/// A new file beside another, gone unless it is kept.
///
/// Where the file system can, it has no name before it is kept, so that not even a process that is
/// killed leaves it behind.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& beside) : folder_(beside.parent_path()) {
    if (nameless.fetch_add(1) < most_nameless) {
      const std::filesystem::path folder = folder_.empty() ? "." : folder_;
      descriptor_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
      if (descriptor_ >= 0) return;
    }
    --nameless;
    with_fresh_name([this] {
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      return descriptor_ >= 0;
    });
  }
  ~Temporary() {
    try {
      close();
    } catch (const std::system_error&) {  // it is not kept
    }
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
    if (noted_ != nullptr) forget(noted_);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }

  /// All is written. (A file without a name must stay open.)
  void finish() {
    if (!path_.empty()) close();
  }

  void become(const std::filesystem::path& file) {
    if (path_.empty()) {
      const std::string self = "/proc/self/fd/" + std::to_string(descriptor_);
      with_fresh_name([&] {
        return linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) == 0;
      });
      close_nameless();
    }
    std::filesystem::rename(path_, file);
    path_.clear();
  }

 private:
  /// Makes something of a name that is not taken; `make` says whether it could.
  template <class Make>
  void with_fresh_name(const Make& make) {
    static std::atomic<unsigned> counter{0};
    for (int tries = 0;; ++tries) {
      path_ = folder_ / (".tensortopo-" + std::to_string(getpid()) + "-" +
                         std::to_string(counter++) + ".tmp");
      // Noted first: a signal may come as soon as the file is there.
      noted_ = note(path_, NotedKind::file);
      if (make()) return;
      const int error = errno;
      forget(std::exchange(noted_, nullptr));
      path_.clear();
      if (error != EEXIST || tries == 1000) fail(error);
    }
  }
  void close_nameless() {
    --nameless;
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  }
  void close() {
    if (descriptor_ < 0) return;
    if (path_.empty()) return close_nameless();
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  }

  std::filesystem::path folder_, path_;
  Noted* noted_ = nullptr;
  int descriptor_ = -1;
};

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

/// What was written, and where it belongs.
struct UnfinishedFile {
  UnfinishedFile(const std::filesystem::path& as_given, const std::filesystem::path& target)
      : given(as_given), place(target), temporary(target) {}
  std::filesystem::path given, place;
  Temporary temporary;
};

/// What a group has written.
struct UnfinishedFiles {
  std::list<UnfinishedFile> files;
};

namespace {

thread_local UnfinishedFiles* current_group = nullptr;

}  // namespace

template <class Act>
void OutputFile::naming_file(const Act& act) const {
  try {
    act();
  } catch (const std::system_error& error) {
    refuse(file_, error.code());
  }
}

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)) {
  namespace fs = std::filesystem;
  naming_file([&] {
    const fs::file_status status = fs::status(file_);
    if (fs::is_directory(status)) fail(EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      // Devices and pipes have no place to rename to.
      descriptor_ = open(file_.c_str(), O_WRONLY | O_CLOEXEC);
      if (descriptor_ < 0) fail(errno);
      return;
    }
    if (current_group == nullptr) alone_ = std::make_unique<UnfinishedFiles>();
    group_ = alone_ ? alone_.get() : current_group;
    // A link stays one: its target is replaced, or made.
    unfinished_ = &group_->files.emplace_back(
        file_, fs::exists(status) ? fs::canonical(file_) : end_of_links(file_));
    descriptor_ = unfinished_->temporary.descriptor();
  });
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  if (unfinished_ == nullptr)
    close(descriptor_);
  else
    group_->files.remove_if([&](const UnfinishedFile& file) { return &file == unfinished_; });
}

void OutputFile::append(std::string_view bytes) {
  naming_file([&] { write_all(descriptor_, bytes); });
  size_ += bytes.size();
}

void OutputFile::finish() {
  naming_file([&] {
    const int descriptor = std::exchange(descriptor_, -1);
    if (unfinished_ == nullptr) {
      if (close(descriptor) != 0) fail(errno);
      return;
    }
    unfinished_->temporary.finish();
    if (alone_) unfinished_->temporary.become(unfinished_->place);
  });
}

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  OutputFile output(file);
  output.append(bytes);
  output.finish();
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
