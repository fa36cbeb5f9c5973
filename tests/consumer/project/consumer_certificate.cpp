// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <span>

#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/io/write_text.hpp"

using namespace tensortopo;

namespace {

/// Writes the surface of a mode in a field, and a certificate of it, as lib/certify's page says.
void write_certified(const std::filesystem::path& field, const ModeValue& mode,
                     const std::filesystem::path& surface,
                     const std::filesystem::path& certificate) {
  const ReadResult read = read_mesh(field);
  ExtractOptions options;
  options.keep_topology = true;
  Extraction extraction = extract_mode_surface<double>(read.mesh, mode, options);
  const CertifiedLevel level = certify(read.mesh, mode, extraction);
  write_surface(extraction.surface, read.mesh, surface);

  CertificateSubject subject;
  subject.tensor = read.report.tensor_name;
  subject.components = name_of(read.report.components.order);
  subject.points = read.mesh.points.size();
  subject.tetrahedra = read.mesh.tets.size();
  subject.field_sha256 = field_sha256(read.mesh);
  subject.vertices = extraction.surface.points.size();
  subject.cells = extraction.surface.triangles.size();
  subject.output_sha256 = surface_sha256(extraction.surface, read.mesh);
  for (const ArrayHash& array : array_hashes(extraction.surface))
    subject.arrays.push_back({array.of, array.name, array.components, array.sha256});
  write_text(certificate, certificate_bytes(subject, std::span(&level, 1), read.mesh,
                                            CertificateEncoding::json));
}

}  // namespace

/// Leaves field.vtu, surface.vtp and certificate.json in a folder.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tensors = {{2, -1, -1, 0, 0, 0},
                  {1, 0, -1, 0.25, 0, 0},
                  {1, 1, -2, 0, 0.125, 0},
                  {3, -1, -1, 0, 0, 0.25}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.cell_ids = {0};
  write_mesh(mesh, folder / "field.vtu");
  write_certified(folder / "field.vtu", ModeValue::parse("1/2"), folder / "surface.vtp",
                  folder / "certificate.json");
}
