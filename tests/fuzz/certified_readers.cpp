// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "certified_readers.hpp"

#include <stdexcept>

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"
#include "fuzzed_folder.hpp"
#include "proofs-check/forgeries/certificate_edits.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// Stability may be claimed of a smaller radius as well.
Json without_stability(Json document) {
  for (Json& level : document["levels"]) level.erase("stability");
  return document;
}

/// @param name  of the output in `certified`, and of the corpus
void check_claims(const std::string& name, std::string_view bytes,
                  bool (*may_be_true)(const Json&, const Json&)) {
  const std::string data = TENSORTOPO_FUZZ_DATA;
  const std::string file = fuzzed_folder().put("c.json", bytes);
  try {
    const certificate::Report report = certificate::check_certificate(
        data + "/certified/" + name + ".vtk", data + "/certified/" + name + ".vtp", file);
    if (report.claims() == 0) throw std::logic_error("nothing is claimed");
    if (to_text(report).empty() || !Json::accept(to_json(report)))
      throw std::logic_error("the report cannot be read");
    if (report.status() != "certified") return;
  } catch (const certificate::Malformed&) {
    return;
  }
  const Json honest = certificate::read_document(
      certificate::read_file(data + "/corpus/certified_" + name + "/honest.json"));
  if (!may_be_true(without_stability(honest),
                   without_stability(certificate::read_document(certificate::read_file(file)))))
    throw std::logic_error("a certificate that may be false is certified");
}

}  // namespace

std::vector<FuzzedReader> certified_readers() {
  return {{"certified_surface",
           [](std::string_view bytes) { check_claims("surface", bytes, may_be_true); }},
          {"certified_curves",
           [](std::string_view bytes) { check_claims("curves", bytes, may_be_true_of_curves); }}};
}

}  // namespace tensortopo::test
