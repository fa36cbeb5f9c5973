// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "checker_readers.hpp"

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"
#include "files/files.hpp"
#include "fuzzed_folder.hpp"

namespace tensortopo::test {
namespace {

template <class Read>
void malformed_or_result(const char* name, std::string_view bytes, const Read& read) {
  try {
    read(fuzzed_folder().put(name, bytes));
  } catch (const certificate::Malformed&) {
  }
}

}  // namespace

std::vector<FuzzedReader> checker_readers() {
  using namespace certificate;
  return {
      {"checker_json",
       [](std::string_view bytes) {
         malformed_or_result("c.json", bytes, [](const auto& f) { read_document(read_file(f)); });
       }},
      {"checker_cbor",
       [](std::string_view bytes) {
         malformed_or_result("c.cbor", bytes, [](const auto& f) { read_document(read_file(f)); });
       }},
      {"checker_vtk",
       [](std::string_view bytes) {
         malformed_or_result("f.vtk", bytes,
                             [](const auto& f) { read_input(read_file(f), "stress", "vtk"); });
       }},
      {"checker_vtu",
       [](std::string_view bytes) {
         malformed_or_result("f.vtu", bytes,
                             [](const auto& f) { read_input(read_file(f), "stress", "vtk"); });
       }},
      {"checker_vtp", [](std::string_view bytes) {
         malformed_or_result("f.vtp", bytes, [](const auto& f) { read_triangles(read_file(f)); });
         malformed_or_result("f.vtp", bytes, [](const auto& f) { read_polylines(read_file(f)); });
       }}};
}

}  // namespace tensortopo::test
