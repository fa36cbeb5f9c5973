// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/parts_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace tensortopo::filters {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_to_write(const fs::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": cannot be written (" + why + ")");
}

/// Makes something of a hidden name that nothing else has, beside a path.
/// @param make   make(name) says whether it could, else errno why
/// @param named  what a message is about
template <class Make>
fs::path made_beside(const fs::path& path, const fs::path& named, const Make& make) {
  static std::atomic<unsigned> counter{0};
  constexpr int most_tries = 1000;
  for (int tries = 1;; ++tries) {
    const fs::path name = path.parent_path() / (".tensortopo-" + std::to_string(getpid()) + "-" +
                                                std::to_string(counter++) + ".tmp");
    if (make(name.c_str())) return name;
    if (errno != EEXIST || tries == most_tries)
      refuse_to_write(named, std::generic_category().message(errno));
  }
}

fs::path fresh_folder(const fs::path& beside) {
  return made_beside(beside, beside, [](const char* name) { return mkdir(name, 0777) == 0; });
}

bool are_digits(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// Whether a name is STEM_5.json or the like.
bool is_numbered(const std::string& name, const std::string& stem, const std::string& extension) {
  if (name.size() <= stem.size() + 1 + extension.size()) return false;
  return name.starts_with(stem + '_') && name.ends_with(extension) &&
         are_digits(name.substr(stem.size() + 1, name.size() - stem.size() - 1 - extension.size()));
}

bool names_first_part(const PartsFiles& files) {
  std::ifstream stream(files.field, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return text.find("\"" + files.below(files.field_of(0)) + "\"") != std::string::npos;
}

/// Files under other names, which are gone in the end.
class Temporaries {
 public:
  ~Temporaries() {
    std::error_code ignored;
    for (const auto& [made, place] : files_) fs::remove(made, ignored);
  }
  void add(const fs::path& place, const std::string& bytes) {
    int descriptor = -1;
    const fs::path name = made_beside(place, place, [&](const char* free) {
      descriptor = open(free, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      return descriptor >= 0;
    });
    close(descriptor);
    files_.emplace_back(name, place);
    write_bytes(name, bytes, place);
  }
  void put_in_place() {
    for (const auto& [made, place] : files_) fs::rename(made, place);
  }

 private:
  std::vector<std::pair<fs::path, fs::path>> files_;
};

}  // namespace

PartsFiles::PartsFiles(const std::string& certificate_file)
    : certificate(fs::absolute(certificate_file)) {
  if (certificate.extension() != ".json")
    throw std::runtime_error(certificate_file +
                             ": on several ranks the name of the certificate must end in .json");
  folder = certificate;
  folder.replace_extension();
  output = folder.string() + ".pvtp";
  field = folder.string() + "_field.pvtu";
}

std::string PartsFiles::field_of(std::size_t part) const {
  return folder.filename().string() + "_field_" + std::to_string(part) + ".vtu";
}
std::string PartsFiles::output_of(std::size_t part) const {
  return folder.filename().string() + '_' + std::to_string(part) + ".vtp";
}
std::string PartsFiles::certificate_of(std::size_t part) const {
  return folder.filename().string() + '_' + std::to_string(part) + ".json";
}
std::string PartsFiles::below(const std::string& name) const {
  return folder.filename().string() + '/' + name;
}

void PartsFiles::require_place() const {
  for (const fs::path& file : {certificate, output, field})
    if (fs::is_directory(file))
      throw std::runtime_error(file.string() + ": is a folder; name another certificate");
  if (fs::exists(field) && !names_first_part(*this))
    throw std::runtime_error(field.string() +
                             ": is another field, which is not replaced; name another certificate");
  if (access(folder.parent_path().c_str(), W_OK | X_OK) != 0)
    refuse_to_write(certificate, std::generic_category().message(errno));
  if (!fs::exists(fs::symlink_status(folder))) return;
  if (!fs::is_directory(folder))
    throw std::runtime_error(folder.string() +
                             ": is in the place of the folder for the parts; remove it");
  const std::string name = folder.filename().string();
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (is_numbered(file, name, ".vtp") || is_numbered(file, name, ".json") ||
        is_numbered(file, name + "_field", ".vtu"))
      continue;
    throw std::runtime_error(folder.string() + ": has " + file +
                             ", which is no part of a surface; name another certificate");
  }
}

NewFolder::NewFolder(fs::path place)
    : place_(std::move(place)), path_(fresh_folder(place_)) {}

NewFolder::~NewFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void NewFolder::put_in_place(const std::vector<std::pair<fs::path, std::string>>& files) {
  Temporaries beside;
  for (const auto& [file, bytes] : files) beside.add(file, bytes);
  fs::path before;  // what was there
  try {
    if (fs::exists(place_)) {
      const fs::path made = fresh_folder(place_);
      before = made / place_.filename();
      fs::rename(place_, before);
    }
    fs::rename(path_, place_);
    beside.put_in_place();
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    if (fs::exists(place_, ignored) && !fs::exists(path_, ignored))
      fs::rename(place_, path_, ignored);
    if (!before.empty()) {
      fs::rename(before, place_, ignored);
      fs::remove(before.parent_path(), ignored);
    }
    refuse_to_write(place_, error.code().message());
  }
  std::error_code ignored;
  if (!before.empty()) fs::remove_all(before.parent_path(), ignored);
}

void write_bytes(const fs::path& file, const std::string& bytes, const fs::path& named) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream)
    refuse_to_write(named, errno != 0 ? std::generic_category().message(errno) : "unknown reason");
}

}  // namespace tensortopo::filters
