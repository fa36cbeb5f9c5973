// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/parts_certificate.hpp"

#include <nlohmann/json.hpp>

namespace tensortopo {

std::string parts_certificate_bytes(const std::string& mode, const std::string& role,
                                    std::span<const CertifiedPart> parts,
                                    const WholeNumbers& whole) {
  using Object = nlohmann::ordered_json;
  const auto named = [](const CertifiedFile& file) {
    return Object{{"file", file.name}, {"sha256", file.sha256}};
  };
  Object listed = Object::array(), counts = Object::object();
  for (const CertifiedPart& part : parts)
    listed.push_back({{"input", named(part.input)},
                      {role, named(part.output)},
                      {"certificate", named(part.certificate)}});
  for (const auto& [name, number] : whole) counts[name] = number;
  const Object document{{"format", "tensortopo certificate of parts"},
                        {"version", 1},
                        {"mode", mode},
                        {"parts", listed},
                        {"whole", counts}};
  return document.dump(1) + "\n";
}

}  // namespace tensortopo
