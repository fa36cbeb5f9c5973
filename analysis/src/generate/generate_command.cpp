// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "generate/generate_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "append_format.hpp"
#include "counted.hpp"
#include "require_folder.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/certify/reference_points.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/io/write_text.hpp"
#include "tensortopo/mesh/append_surface.hpp"

namespace tensortopo {

namespace {

using Path = std::filesystem::path;

Path with_suffix(const Path& field, const std::string& suffix) {
  Path name = field;
  return name.replace_extension(suffix);
}

// What goes to the reference files of one field.
struct References {
  SurfaceMesh surface;
  nlohmann::ordered_json points;
};

// A field, and where the vertices of each of its members end if it has several.
struct Sheet {
  FamilyMember all;
  std::vector<TetMesh::Index> ends;
  std::vector<std::string> notes;  // as in FieldTruth

  int member_of(TetMesh::Index vertex) const {
    return static_cast<int>(std::upper_bound(ends.begin(), ends.end(), vertex) - ends.begin());
  }
};

LevelTruth truth_of(const Sheet& sheet, const ModeValue& mode, const GenerateCommand& command,
                    const Path& field, References& references) {
  const TetMesh& mesh = sheet.all.mesh;
  ExtractOptions options;
  options.keep_topology = true;
  options.sampling.resolution = command.resolution;
  Extraction extraction = extract_mode_surface<double>(mesh, mode, options);
  const CertifiedLevel certified = certify(mesh, mode, extraction);
  const bool detailed = mesh.tets.size() <= kLargeMesh;
  std::function<int(const ComponentClaim&)> member_of;
  if (!sheet.ends.empty())
    member_of = [&](const ComponentClaim& c) {
      const auto vertex = static_cast<std::size_t>(c.first_vertex);
      return sheet.member_of(extraction.surface.carrier_vertices[vertex][0]);
    };
  LevelTruth truth = level_truth(certified, detailed, member_of);
  if (command.no_reference || (!detailed && !command.always_reference)) return truth;

  const ReferencePoints points = reference_points(mesh, extraction.surface, mode);
  ReferenceTruth& r = truth.reference.emplace();
  r.surface = with_suffix(field, ".reference.vtp").filename().string();
  r.points = with_suffix(field, ".reference.json").filename().string();
  r.vertices = extraction.surface.points.size();
  r.triangles = extraction.surface.triangles.size();
  r.distance = certified.distance.bound;
  r.coarse_cells = certified.distance.coarse.size();
  r.coarse_distance = certified.distance.coarse_bound;
  r.point_bound = points.bound;
  r.unproved_points = points.unproved.size();
  references.points.push_back({{"mode", mode.text()},
                               {"bound", points.bound},
                               {"unproved", points.unproved},
                               {"vertices", points.coordinates}});
  append_surface(references.surface, std::move(extraction.surface));
  return truth;
}

Generated write_field(const GenerateCommand& command, const Sheet& sheet, const Path& field,
                      FieldTruth truth) {
  const FamilyMember& member = sheet.all;
  const TetMesh& mesh = member.mesh;
  truth.kind = name_of(command.kind);
  truth.note = member.note;
  truth.notes = sheet.notes;
  truth.seed = command.seed;
  truth.field_sha256 = field_sha256(mesh);
  truth.points = mesh.points.size();
  truth.tetrahedra = mesh.tets.size();
  FileGroup files;
  write_mesh(mesh, field, "tensor");
  if (command.field_only) {
    files.commit();
    return {field, {}, std::move(truth), {}};
  }

  References references;
  std::vector<std::string> notes;
  if (mesh.tets.size() > kLargeMesh && !command.no_reference && !command.always_reference)
    notes.push_back(fmt::format(
        "no reference surface and no facts of single edges and faces, for more than {} tetrahedra "
        "({}); --reference writes the surface",
        kLargeMesh, mesh.tets.size()));
  references.points = nlohmann::ordered_json::array();
  const auto modes = modes_to_extract(command.modes.empty() ? member.modes : command.modes, false);
  for (const ModeValue& mode : modes)
    truth.levels.push_back(truth_of(sheet, mode, command, field, references));
  if (!references.points.empty()) {
    write_surface(references.surface, mesh, with_suffix(field, ".reference.vtp"),
                  {.mode_surfaces = true});
    write_text(with_suffix(field, ".reference.json"), references.points.dump(0) + '\n');
  }
  const Path file = with_suffix(field, ".truth.json");
  write_text(file, to_json(truth));
  files.commit();
  return {field, file, std::move(truth), std::move(notes)};
}

/// Whether members are meshes of as many tetrahedra as are asked for.
bool has_mesh(FieldKind kind) {
  switch (kind) {
    case FieldKind::complex:
    case FieldKind::rough:
    case FieldKind::boussinesq:
    case FieldKind::kelvin:
    case FieldKind::helix:
    case FieldKind::block:
      return true;
    default:
      return false;
  }
}

Sheet all_members(const GenerateCommand& command, const FamilyRequest& first) {
  Sheet sheet;
  FamilyMember& all = sheet.all;
  std::vector<TetMesh> meshes;
  for (int i = 0; i < command.count; ++i) {
    FamilyRequest request = first;
    request.member = i;
    FamilyMember member = family_member(command.kind, request);
    for (const ModeValue& mode : member.modes)
      if (std::find(all.modes.begin(), all.modes.end(), mode) == all.modes.end())
        all.modes.push_back(mode);
    const TetMesh::Index first_vertex = sheet.ends.empty() ? 0 : sheet.ends.back();
    sheet.ends.push_back(first_vertex + static_cast<TetMesh::Index>(member.mesh.points.size()));
    meshes.push_back(std::move(member.mesh));
    sheet.notes.push_back(std::move(member.note));
  }
  if (std::equal(sheet.notes.begin() + 1, sheet.notes.end(), sheet.notes.begin()))
    sheet.notes.clear();
  all.note = fmt::format("{} members side by side", command.count);
  all.mesh = side_by_side(meshes);
  return sheet;
}

/// Throws UsageError for what is not written in pieces.
void require_pieces(const GenerateCommand& command) {
  if (command.kind != FieldKind::kelvin || command.count != 1 || !command.field_only)
    throw UsageError("--pieces: only of one field of kind kelvin, with --field-only");
  const int largest = cells_for({1, 1, 1}, std::max<std::size_t>(command.tetrahedra, 1))[0];
  if (command.tetrahedra == 0 || command.pieces > largest)
    throw UsageError("--pieces: needs --tets, and at most one piece for each layer of the lattice");
}

/// The mesh is made slab after slab.
Generated write_pieces(const GenerateCommand& command, FamilyRequest request,
                       const Progress& progress) {
  Generated made{command.output, {}, {}, {}};
  made.truth.kind = name_of(command.kind);
  made.truth.seed = command.seed;
  request.slabs = command.pieces;
  FileGroup files;
  std::vector<Path> pieces;
  for (int s = 0; s < command.pieces; ++s) {
    if (progress) progress("generating", static_cast<double>(s) / command.pieces);
    request.slab = s;
    const FamilyMember slab = family_member(command.kind, request);
    pieces.push_back(command.output);
    pieces.back().replace_filename(fmt::format("{}-{:04}.vtu", command.output.stem().string(), s));
    write_mesh(slab.mesh, pieces.back(), "tensor");
    made.truth.note = slab.note;
    made.truth.tetrahedra += slab.mesh.tets.size();
  }
  write_piece_list(pieces, command.output, "tensor");
  files.commit();
  return made;
}

}  // namespace

GenerateReport run_generate(const GenerateCommand& command, const Progress& progress) {
  const char* const extension = command.pieces > 1 ? ".pvtu" : ".vtu";
  if (lower_extension(command.output) != extension)
    throw UsageError(command.output.string() + ": the name must end in " + extension);
  if (command.pieces > 1) require_pieces(command);
  for (const ModeValue& mode : command.modes)
    if (is_degenerate(mode))
      throw UsageError("--mode " + mode.text() +
                       ": certified truth is about mode surfaces, not degenerate curves");
  if (command.tetrahedra > 0 && !has_mesh(command.kind))
    throw UsageError("--tets: has no effect on kind " + std::string(name_of(command.kind)) +
                     ", whose members are given tetrahedra");
  if (command.count < 1) throw UsageError("--count: must be positive");
  require_folder(command.output);
  FamilyRequest request;
  request.seed = command.seed;
  request.members = command.count;
  request.tetrahedra = command.tetrahedra;

  GenerateReport report;
  report.kind = command.kind;
  FieldTruth truth;
  truth.members = command.count;
  if (command.pieces > 1) {
    report.files.push_back(write_pieces(command, request, progress));
    return report;
  }
  if (command.together && command.count > 1) {
    report.files.push_back(
        write_field(command, all_members(command, request), command.output, truth));
    return report;
  }
  for (int i = 0; i < command.count; ++i) {
    if (progress) progress("generating", static_cast<double>(i) / command.count);
    request.member = truth.member = i;
    Path field = command.output;
    if (command.count > 1)
      field.replace_filename(fmt::format("{}-{:04}.vtu", command.output.stem().string(), i));
    report.files.push_back(
        write_field(command, {family_member(command.kind, request), {}, {}}, field, truth));
  }
  return report;
}

std::string to_json(const GenerateReport& report) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["kind"] = name_of(report.kind);
  json["files"] = Json::array();
  for (const Generated& file : report.files) {
    Json entry{{"field", file.field.string()},
               {"truth", file.truth_file.string()},
               {"sha256", file.truth.field_sha256.empty() ? Json() : Json(file.truth.field_sha256)},
               {"tetrahedra", file.truth.tetrahedra}};
    entry["levels"] = Json::array();
    for (const LevelTruth& level : file.truth.levels)
      entry["levels"].push_back({{"mode", level.mode.text()},
                                 {"components", level.components.size()},
                                 {"undecided", level.undecided.size()}});
    json["files"].push_back(std::move(entry));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const GenerateReport& report) {
  std::string text;
  for (const Generated& file : report.files) {
    append_format(text, "{}: {} ({})\n", file.field.string(), file.truth.note,
                  counted_tets(file.truth.tetrahedra));
    for (const LevelTruth& level : file.truth.levels) {
      long euler = 0;
      std::size_t loops = 0;
      for (const auto& c : level.components)
        euler += c.euler_characteristic, loops += c.boundary_loops;
      append_format(
          text, "  mode {:>9}: components {:>4}, Euler characteristic {:>4}, boundary loops {:>4}",
          short_text(level.mode), level.components.size(), euler, loops);
      if (!level.undecided.empty()) {
        std::map<std::string, int> reasons;
        for (const auto& cell : level.undecided) ++reasons[cell.reason];
        append_format(text, "; undecided:");
        for (const auto& [reason, count] : reasons) append_format(text, " {} {}", count, reason);
      }
      if (level.reference) {
        const auto& r = *level.reference;
        append_format(text, "; within {:.2g}, vertices {:.1g}", r.distance, r.point_bound);
        if (r.coarse_cells > 0)
          append_format(text, " (in {} tetrahedra only {:.2g})", r.coarse_cells, r.coarse_distance);
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace tensortopo
