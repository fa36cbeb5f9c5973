// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "checker_readers.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"
#include "files/files.hpp"

namespace tensortopo::test {
namespace {

/// A folder for this process, in memory if there is a place for that.
class Folder {
 public:
  Folder() {
    const std::filesystem::path memory = "/dev/shm";
    std::string name = ((std::filesystem::exists(memory) ? memory
                                                         : std::filesystem::temp_directory_path()) /
                        "tensortopo-fuzz-XXXXXX")
                           .string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string put(const char* name, std::string_view bytes) const {
    const std::string file = path_ / name;
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

 private:
  std::filesystem::path path_;
};

template <class Read>
void malformed_or_result(const char* name, std::string_view bytes, const Read& read) {
  static const Folder folder;
  try {
    read(folder.put(name, bytes));
  } catch (const certificate::Malformed&) {
  }
}

}  // namespace

std::vector<FuzzedReader> checker_readers() {
  using namespace certificate;
  return {{"checker_json",
           [](std::string_view bytes) {
             malformed_or_result("c.json", bytes, [](const auto& f) { read_document(f); });
           }},
          {"checker_cbor",
           [](std::string_view bytes) {
             malformed_or_result("c.cbor", bytes, [](const auto& f) { read_document(f); });
           }},
          {"checker_vtk",
           [](std::string_view bytes) {
             malformed_or_result("f.vtk", bytes,
                                 [](const auto& f) { read_input(f, "stress", "vtk"); });
           }},
          {"checker_vtu",
           [](std::string_view bytes) {
             malformed_or_result("f.vtu", bytes,
                                 [](const auto& f) { read_input(f, "stress", "vtk"); });
           }},
          {"checker_vtp", [](std::string_view bytes) {
             malformed_or_result("f.vtp", bytes, [](const auto& f) { read_triangles(f); });
             malformed_or_result("f.vtp", bytes, [](const auto& f) { read_polylines(f); });
           }}};
}

}  // namespace tensortopo::test
