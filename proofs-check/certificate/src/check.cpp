// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <future>
#include <memory>
#include <set>

#include "check_level.hpp"
#include "claims/compare_arrays.hpp"
#include "claims/compare_curves.hpp"
#include "claims/compare_level.hpp"
#include "claims/left_out.hpp"
#include "parts/check_part.hpp"
#include "parts/check_parts.hpp"
#include "run/parallel.hpp"
#include "run/work_limit.hpp"
#include "surface/compare_stability.hpp"
#include "vertices/residual.hpp"

namespace certificate {
namespace {

void check_curves(const Json& claims, const RadiiByArray& radii, const Input& input,
                  const Field& field, const Polylines& curves, Ledger& ledger,
                  const Progress& progress, PartCurves* part) {
  ledger.begin_level(level_name_of(claims));
  std::vector<bool> left_out(input.tets.size());
  ledger.begin("left out");
  if (!mark_left_out(claims, input, curve_reason_of, left_out, ledger)) return;
  const std::size_t left_open = ledger.open();
  const CurveTopology topology =
      derive_curves(input, field, kind_of(claims["mode"]), left_out, progress);
  const CurveCase c{input, field, curves, claims, range_of(claims["vertices"]),
                    range_of(claims["lines"]), left_out, topology};
  ledger.begin("faces");
  const PointVertices vertices = compare_face_points(c, ledger);
  ledger.begin("tetrahedra");
  compare_pieces(c, vertices, ledger);
  ledger.begin("curves");
  compare_polylines(c, ledger);
  ledger.of_level().residual = residual_bound(c);
  if (part != nullptr && !ledger.has_refuted() && ledger.open() == 0) add_curves(c, *part);
  ledger.begin("stability");
  if (claims.contains("stability"))
    compare_stability(c, radii, !ledger.has_refuted() && ledger.open() == left_open, progress,
                      ledger);
  ledger.count(topology.by_balls, topology.by_integers);
}

/// Do the levels' ranges follow each other, to the end?
/// @return what is wrong; empty if nothing is
std::string disorder_of(const Json& levels, const char* key, Number all) {
  Number next = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const Range range = range_of(levels[l][key]);
    if (range.first != next || range.count > all - next)
      return std::string(key) + " of level " + std::to_string(l) + " are " +
             levels[l][key].dump() + " (first, count), next is " + std::to_string(next) + " of " +
             std::to_string(all);
    next += range.count;
  }
  if (next == all) return {};
  return std::string(key) + ": " + std::to_string(next) + " in all levels, " +
         std::to_string(all) + " in the file";
}

/// Is a level listed twice, so that its surface is, too?
std::string repetition_of(const Json& levels) {
  std::set<std::string> names;
  for (const Json& claims : levels)
    if (!names.insert(level_name_of(claims)).second) return level_name_of(claims) + " is listed twice";
  return {};
}

/// Tetrahedra in which the deviator vanishes.
std::size_t count_isotropic(const InputFile& input) {
  const auto is_isotropic = [&](std::uint32_t v) {
    const auto& [xx, yy, zz, xy, yz, xz] = input.tensors[v];
    return xx == yy && yy == zz && xy == 0 && yz == 0 && xz == 0;
  };
  return static_cast<std::size_t>(
      std::count_if(input.tets.begin(), input.tets.end(), [&](const auto& tet) {
        return std::all_of(tet.begin(), tet.end(), is_isotropic);
      }));
}

Subject subject_of(const std::string& file, const std::string& tensor, const std::string& order,
                   const InputFile& input) {
  Subject s;
  s.input = file, s.tensor = tensor, s.order = order;
  s.listing = listing_of(order), s.names = input.names;
  s.names_say_order = input.names_say_order;
  s.points = input.points.size(), s.tetrahedra = input.tets.size();
  s.isotropic = count_isotropic(input);
  s.other_cells = input.other_cells, s.flat_cells = input.flat_cells;
  s.symmetrized = input.symmetrized;
  s.doubled_points = input.doubled_points;
  s.sha256 = input.sha256();
  return s;
}

/// A certificate's files, and what it claims of them.
class Checking {
 public:
  /// @param bytes  of all files
  Checking(const File& input, const Json& certificate, std::size_t bytes, const Progress& progress)
      : certificate_(certificate),
        progress_(progress),
        input_(read_input(input, certificate["input"]["tensor"],
                          certificate["input"]["components"])),
        limit_(WorkLimit::of_files(bytes)),
        ledger_(report_) {
    report_.subject = subject_of(input.name, certificate["input"]["tensor"],
                                 certificate["input"]["components"], input_);
    for (const Json& level : certificate["levels"])
      if (level.contains("stability") && level["stability"].contains("array")) {
        const std::string array = level["stability"]["array"].get<std::string>();
        if (!radii_.contains(array))
          radii_[array] = read_radii(input, array, input_.points.size());
      }
  }

  /// @param border  of a part: gets what is needed to put it together with others
  Report of_surface(const std::string& file, const Triangles& surface,
                    PartBorder* border = nullptr) {
    const Json& levels = certificate_["levels"];
    report_.subject.output = file;
    if (!compare_files(surface, "surface", "triangles", surface.triangles.size())) return report_;
    if (border != nullptr) {
      static_cast<MeshBorder&>(*border) = border_of(input_);
      if (levels.size() != 1) return report_;
    }
    check_levels(surface, border);
    std::erase_if(report_.subject.bound_only, [&](const std::string& name) {
      return !report_.levels.empty() &&
             std::all_of(report_.levels.begin(), report_.levels.end(), [&](const LevelReport& l) {
               return l.vectors.contains(name);
             });
    });
    return report_;
  }

  /// @param part  as `border`
  Report of_curves(const File& file, PartCurves* part = nullptr) {
    const Polylines curves = read_polylines(file);
    report_.subject.output = file.name, report_.subject.of_curves = true;
    if (!compare_files(curves, "polylines", "lines", curves.lines.size())) return report_;
    if (part != nullptr) {
      static_cast<MeshBorder&>(*part) = border_of(input_);
      if (certificate_["levels"].size() != 1) return report_;
    }
    const Field field(input_, Multiples{}, in_parallel({}));
    for (const Json& claims : certificate_["levels"])
      check_curves(claims, radii_, input_, field, curves, ledger_, progress_, part);
    return report_;
  }

 private:
  /// A level's claims are compared while the next level's topology is derived, which is done in
  /// order, as the limit of work is that of all. The last one's are compared by this thread, which
  /// tells how much is done.
  void check_levels(const Triangles& surface, PartBorder* border) {
    std::shared_ptr<const Field> field;  // levels mostly are about the same tensors
    std::unique_ptr<CheckedLevel> derived;
    std::future<void> compared;
    const auto finish = [&] {
      if (!derived) return;
      compared.get();
      ledger_.add(std::move(derived->report));
      derived.reset();
    };
    const Json& levels = certificate_["levels"];
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const Multiples multiples = level_of(levels[l]).multiples();
      if (!field || !(field->multiples() == multiples))
        field = std::make_shared<const Field>(input_, multiples, in_parallel({}));
      auto next = std::make_unique<CheckedLevel>(levels[l], field);
      derive_level(*next, input_, limit_, progress_);
      finish();
      derived = std::move(next);
      const bool is_last = l + 1 == levels.size();
      compared = std::async(is_last ? std::launch::deferred : std::launch::async,
                            [this, &surface, border, &level = *derived, is_last] {
                              compare_level(level, radii_, input_, surface,
                                            is_last ? progress_ : Progress{}, border);
                            });
    }
    finish();
  }

  /// Are these the files that the certificate is about?
  /// @param key  of the claims about the output
  /// @param kind  of the output's cells
  template <class Output>
  bool compare_files(const Output& output, const char* key, const char* kind, std::size_t cells) {
    const Json &input_claims = certificate_["input"], &claims = certificate_[key];
    const auto compare = [&](const std::string& what, const Json& claimed, const Json& derived) {
      ledger_.settle(claimed == derived, what, claimed.dump(), derived.dump());
    };
    ledger_.begin("files");
    compare("points", input_claims["points"], input_.points.size());
    compare("tetrahedra", input_claims["tetrahedra"], input_.tets.size());
    Subject& s = report_.subject;
    s.vertices = output.points.size(), s.cells = cells;
    for (const Array& array : output.arrays)
      if (array.name != "mode" && array.name != "value" && array.name != "component")
        s.bound_only.push_back(array.name);
    compare("input's sha256", input_claims["sha256"], s.sha256);
    compare("vertices", claims["vertices"], output.points.size());
    compare(kind, claims[kind], cells);
    compare(std::string(key) + (*key == 's' ? "'s sha256" : "' sha256"), claims["sha256"],
            output.sha256());
    const Json& levels = certificate_["levels"];
    std::string disorder = disorder_of(levels, "vertices", output.points.size());
    if (disorder.empty()) disorder = disorder_of(levels, kind, cells);
    if (disorder.empty()) disorder = repetition_of(levels);
    const bool are_levels_of_output = disorder.empty();
    ledger_.settle(are_levels_of_output, "levels", "all of the file, one after the other",
                   disorder);
    if (levels.empty())
      ledger_.leave_open("levels", "the certificate claims nothing about any level");
    ledger_.begin("arrays");
    compare_hashes(claims, output.arrays, ledger_);
    if (are_levels_of_output) compare_arrays(levels, output, ledger_);
    return report_.refuted == 0;  // of another field or file nothing need be derived
  }

  const Json& certificate_;
  const Progress& progress_;
  InputFile input_;
  RadiiByArray radii_;
  Report report_;
  WorkLimit limit_;
  Ledger ledger_;
};

}  // namespace

Subject read_subject(const std::string& input, const std::string& tensor, const std::string& order) {
  return subject_of(input, tensor, order, read_input(read_file(input), tensor, order));
}

namespace {

/// @param check  check(checking): what a part's certificate comes to
template <class Check>
void check_document(const File& input, const File& output, const File& certificate, bool of_curves,
                    const Progress& progress, const Check& check) {
  const Json document = read_document(certificate);
  if (document.contains("polylines") != of_curves)
    throw Malformed(certificate.name, of_curves ? "is of a surface, not of a part of curves"
                                                : "is of curves, not of a part of a surface");
  try {
    const std::size_t bytes = input.bytes.size() + output.bytes.size() + certificate.bytes.size();
    Checking checking(input, document, bytes, progress);
    check(checking);
  } catch (const Malformed& error) {
    throw Malformed(error.file().empty() ? certificate.name : error.file(), error.problem());
  }
}

}  // namespace

CheckedPart check_part(const File& input, const File& surface, const File& certificate,
                       const Progress& progress) {
  CheckedPart part;
  check_document(input, surface, certificate, false, progress, [&](Checking& checking) {
    part.report = checking.of_surface(surface.name, read_triangles(surface), &part.border);
  });
  return part;
}

CheckedCurves check_curve_part(const File& input, const File& polylines, const File& certificate,
                               const Progress& progress) {
  CheckedCurves part;
  check_document(input, polylines, certificate, true, progress, [&](Checking& checking) {
    part.report = checking.of_curves(polylines, &part.curves);
  });
  return part;
}

Report check_certificate(const std::string& input, const std::string& surface,
                         const std::string& certificate, const Progress& progress) {
  if (File{surface, {}}.has_extension(".pvtp"))
    return check_parts(input, surface, certificate, progress);
  File text = read_file(certificate), output = read_file(surface);
  // Mostly it is a surface, which then is read at the same time.
  auto triangles = std::async(std::launch::async, [&] { return read_triangles(output); });
  const Json document = read_document(text);
  try {
    File field = read_file(input);
    const std::size_t bytes = field.bytes.size() + output.bytes.size() + text.bytes.size();
    text.forget();
    Checking checking(field, document, bytes, progress);
    field.forget();
    if (document.contains("polylines")) return checking.of_curves(output);
    const Triangles read = triangles.get();
    output.forget();
    return checking.of_surface(surface, read);
  } catch (const Malformed& error) {
    throw Malformed(error.file().empty() ? certificate : error.file(), error.problem());
  }
}

}  // namespace certificate
