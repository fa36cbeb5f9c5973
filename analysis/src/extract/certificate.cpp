// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/certificate.hpp"

#include <map>
#include <string>
#include <utility>

#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_text.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {

namespace {

using Kinds = std::map<std::string, std::size_t>;

/// Claims by kind, as `claims` counts them.
void count(const CertifiedLevel& level, Kinds& kinds) {
  const LevelTopology& t = level.topology;
  kinds["edges"] += t.edges.size(), kinds["faces"] += t.faces.size();
  kinds["tetrahedra"] += t.tets.size(), kinds["cones"] += t.cones.size();
  kinds["components"] += level.components.size(), kinds["distances"] += 1;
}
void count(const CertifiedCurves& kind, Kinds& kinds) {
  kinds["faces"] += kind.faces.size(), kinds["tetrahedra"] += kind.tets.size();
  kinds["curves"] += kind.curves.size(), kinds["no others"] += 1;
}

/// Undecided tetrahedra that reports name.
constexpr std::size_t kMostListed = 100;

/// @param output  the surface, or the polylines
/// @param levels  of it
template <class Output, class Levels>
CertificateReport write_levels(const std::filesystem::path& file, CertificateSubject subject,
                               const ReadResult& read, const Output& output,
                               const std::vector<ArrayHash>& arrays, const Levels& levels) {
  subject.vertices = output.points.size();
  for (const ArrayHash& array : arrays)
    subject.arrays.push_back({array.of, array.name, array.components, array.sha256});
  const auto encoding =
      lower_extension(file) == ".cbor" ? CertificateEncoding::cbor : CertificateEncoding::json;
  const std::string bytes = certificate_bytes(subject, levels, read.mesh, encoding);
  write_text(file, bytes);

  CertificateReport report;
  report.path = file;
  report.bytes = bytes.size();
  for (const auto& level : levels) {
    report.certified += level.claims();
    count(level, report.kinds);
    report.undecided_cells += level.undecided.size();
    for (const auto& cell : level.undecided) {
      ++report.undecided[cell.reason];
      if (report.listed.size() < kMostListed)
        report.listed.emplace_back(read.mesh.cell_ids[as_size(cell.tet)], cell.reason);
    }
  }
  return report;
}

}  // namespace

CertificateSubject subject_of(const ReadResult& read) {
  CertificateSubject subject;
  subject.tensor = read.report.tensor_name;
  subject.components = name_of(read.report.components.order);
  subject.points = read.mesh.points.size();
  subject.tetrahedra = read.mesh.tets.size();
  subject.field_sha256 = field_sha256(read.mesh);
  return subject;
}

void require_certifiable(const ReadOptions& options, const std::filesystem::path& output,
                         const std::filesystem::path& certificate) {
  const std::string encoding = lower_extension(certificate);
  if (encoding != ".json" && encoding != ".cbor")
    throw UsageError(certificate.string() +
                     ": a certificate's name (--certify) must end in .json or .cbor");
  if (lower_extension(output) != ".vtp")
    throw UsageError(
        "--certify: the certificate names vertices and tetrahedra of the surface, "
        "which only a .vtp keeps; give -o a name in .vtp");
  if (const char* const option = options.making_others())
    throw UsageError(std::string("--certify: the certificate is about the numbers in one file as "
                                 "they are, and ") +
                     option + " makes others; use it with tensortopo convert, and certify that");
}

CertificateReport write_certificate(const std::filesystem::path& file, CertificateSubject subject,
                                    const ReadResult& read, const SurfaceMesh& surface,
                                    const std::vector<CellArray>& more,
                                    const std::vector<CertifiedLevel>& levels) {
  subject.cells = surface.triangles.size();
  subject.output_sha256 = surface_sha256(surface, read.mesh);
  return write_levels(file, std::move(subject), read, surface, array_hashes(surface, more), levels);
}

CertificateReport write_certificate(const std::filesystem::path& file, CertificateSubject subject,
                                    const ReadResult& read, const CurveMesh& curves,
                                    const std::vector<CellArray>& more,
                                    const std::vector<CertifiedCurves>& kinds) {
  subject.cells = curves.lines.size();
  subject.output_sha256 = curves_sha256(curves, read.mesh);
  return write_levels(file, std::move(subject), read, curves, array_hashes(curves, more), kinds);
}

}  // namespace tensortopo
