// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/check_parts.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/document.hpp"
#include "files/files.hpp"
#include "parts/check_part.hpp"
#include "parts/join_curves.hpp"
#include "parts/join_parts.hpp"
#include "parts/part_files.hpp"
#include "run/ledger.hpp"

namespace certificate {
namespace {

/// What was found in a part becomes part of what was found in all.
void add_report(const Report& part, const std::string& name, Report& all) {
  constexpr std::size_t kShown = 10;
  all.certified += part.certified, all.refuted += part.refuted, all.undecided += part.undecided;
  all.by_balls += part.by_balls, all.by_integers += part.by_integers;
  for (const Verdicts& own : part.kinds) {
    const auto known = std::find_if(all.kinds.begin(), all.kinds.end(),
                                    [&](const Verdicts& v) { return v.kind == own.kind; });
    Verdicts& kind = known == all.kinds.end() ? all.kinds.emplace_back() : *known;
    kind.kind = own.kind;
    kind.certified += own.certified, kind.refuted += own.refuted, kind.undecided += own.undecided;
  }
  const auto add = [&](const std::vector<Finding>& from, std::vector<Finding>& to) {
    for (const Finding& finding : from) {
      if (to.size() == kShown) break;
      to.push_back(finding);
      to.back().entity = name + ", " + finding.entity;
    }
  };
  add(part.refutations, all.refutations);
  add(part.open, all.open);
}

/// What the subject of a part adds to that of all.
void add_subject(const Subject& part, bool is_first, Subject& all) {
  if (is_first) {
    const std::string input = all.input, output = all.output;
    all = part;
    all.input = input, all.output = output, all.sha256.clear();
    return;
  }
  all.points += part.points, all.tetrahedra += part.tetrahedra;
  all.isotropic += part.isotropic;
  all.other_cells += part.other_cells, all.flat_cells += part.flat_cells;
  all.doubled_points += part.doubled_points;
  all.symmetrized += part.symmetrized;
  // Names of any part that do not spell the order are shown.
  if (!part.names.empty() && !part.names_say_order && (all.names.empty() || all.names_say_order))
    all.names = part.names, all.names_say_order = false;
  all.vertices += part.vertices, all.cells += part.cells;
  for (const std::string& name : part.bound_only)
    if (std::find(all.bound_only.begin(), all.bound_only.end(), name) == all.bound_only.end())
      all.bound_only.push_back(name);
}

class Parts {
 public:
  Parts(const std::string& input, const std::string& surface, const std::string& certificate)
      : input_(input), surface_(surface), certificate_(certificate), ledger_(report_) {
    report_.subject.input = input, report_.subject.output = surface;
  }

  Report check(const Progress& progress) {
    const Json document = read_parts_document(read_file(certificate_));
    of_curves_ = is_of_curves(document);
    report_.subject.of_curves = of_curves_;
    const char* const output = of_curves_ ? "polylines" : "surface";
    const Json& parts = document["parts"];
    const auto inputs = piece_names(input_, "UnstructuredGrid");
    const auto surfaces = piece_names(surface_, "PolyData");
    ledger_.begin("files");
    const std::string count = std::to_string(parts.size());
    ledger_.settle(inputs.size() == parts.size(), "pieces of the field", count,
                   std::to_string(inputs.size()));
    ledger_.settle(surfaces.size() == parts.size(), std::string("pieces of the ") + output, count,
                   std::to_string(surfaces.size()));
    std::set<std::string> hashes;
    for (const Json& part : parts)
      if (!hashes.insert(part["input"]["sha256"].get<std::string>()).second)
        ledger_.refute("pieces of the field", "different files", "one file twice");
    if (ledger_.has_refuted()) return report_;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const std::string name = "part " + std::to_string(p);
      ledger_.begin("files");
      const File input = read_file(beside(input_, inputs[p])),
                 surface = read_file(beside(surface_, surfaces[p]));
      const std::string named = parts[p]["certificate"]["file"].get<std::string>();
      const File certificate = read_file(beside(certificate_, named));
      const bool are_files =
          compare_file(name + "'s field", parts[p]["input"], inputs[p], input) &
          compare_file(name + "'s " + output, parts[p][output], surfaces[p], surface) &
          compare_file(name + "'s certificate", parts[p]["certificate"], named, certificate);
      if (!are_files) continue;  // of other files nothing need be derived
      const Progress own = !progress ? progress : [&, p](std::string_view what, double done) {
        progress(what, (static_cast<double>(p) + done) / static_cast<double>(parts.size()));
      };
      const std::string mode = document["mode"].get<std::string>();
      if (of_curves_) {
        CheckedCurves part = check_curve_part(input, surface, certificate, own);
        add(name, part.report, part.curves.whole_is_elsewhere, mode);
        curves_.push_back(std::move(part.curves));
      } else {
        CheckedPart part = check_part(input, surface, certificate, own);
        add(name, part.report, part.border.whole_is_elsewhere, mode);
        if (!part.border.is_complete && incomplete_.empty()) incomplete_ = name;
        borders_.push_back(std::move(part.border));
      }
    }
    join(document["whole"]);
    return report_;
  }

 private:
  /// Is it the file that is claimed, by name and bytes?
  bool compare_file(const std::string& what, const Json& claim, const std::string& name,
                    const File& file) {
    const std::string claimed = claim["file"].get<std::string>();
    if (claimed != name) return ledger_.refute(what, claimed, name), false;
    const std::string sha256 = sha256_of(file.bytes);
    ledger_.settle(claim["sha256"] == sha256, what + "'s sha256", claim["sha256"].dump(), sha256);
    return claim["sha256"] == sha256;
  }

  /// @param whole_is_elsewhere  the array `whole_component` is of another shape
  void add(const std::string& name, const Report& part, bool whole_is_elsewhere,
           const std::string& mode) {
    const bool is_first = !std::exchange(has_part_, true);
    add_report(part, name, report_);
    add_subject(part.subject, is_first, report_.subject);
    if (is_first) tensor_ = part.subject.tensor, order_ = part.subject.order;
    ledger_.begin("files");
    ledger_.settle(part.subject.tensor == tensor_, name + "'s tensor", tensor_,
                   part.subject.tensor);
    ledger_.settle(part.subject.order == order_, name + "'s components", order_,
                   part.subject.order);
    const std::string own =
        part.levels.size() == 1 ? part.levels[0].name : "no level, or not only one";
    if (!part.levels.empty() || part.refuted == 0)
      ledger_.settle(own == "mode " + mode, name + "'s level", "mode " + mode, own);
    if (level_.name.empty()) level_.name = "mode " + mode;
    for (const LevelReport& l : part.levels) {
      for (const auto& [reason, tets] : l.left_out) {
        auto& list = level_.left_out[reason];
        list.insert(list.end(), tets.begin(), tets.end());
      }
      if (l.residual && (is_first || level_.residual))
        level_.residual = std::max(level_.residual.value_or(0), *l.residual);
      else
        level_.residual.reset();
      level_.vertices += l.vertices;
      for (const auto& [array, shown] : l.vectors) level_.vectors[array] += shown;
    }
    ledger_.begin("arrays");
    if (whole_is_elsewhere)
      ledger_.refute(name + "'s whole_component", "of points, or of several components",
                     std::string("one number of each ") + (of_curves_ ? "line" : "triangle"));
  }

  void join(const Json& claims) {
    if (!ledger_.has_refuted()) {
      const bool is_open = report_.undecided > 0;
      if (is_open || !incomplete_.empty()) {
        ledger_.begin("whole");
        ledger_.leave_open(
            "whole", is_open
                         ? "a claim of a part is undecided"
                         : incomplete_ + " ends at an edge between vertices with zero deviator");
      } else if (of_curves_) {
        if (const auto whole = join_curves(curves_, ledger_)) compare_whole(claims, *whole);
      } else {
        if (const auto whole = join_parts(borders_, ledger_)) compare_whole(claims, *whole);
      }
    }
    level_.certified = report_.certified, level_.refuted = report_.refuted;
    level_.undecided = report_.undecided;
    report_.levels.push_back(level_);
  }

  void compare(const Json& claims, const char* key, const Json& derived) {
    ledger_.settle(claims[key] == derived, std::string("whole, ") + key, claims[key].dump(),
                   derived.dump());
  }

  void compare_whole(const Json& claims, const JoinedSurface& whole) {
    begin_whole(claims, whole);
    compare(claims, "triangles", whole.triangles);
    compare(claims, "components", whole.components.size());
    compare(claims, "euler_characteristic", whole.euler_characteristic);
    compare(claims, "boundary_loops", whole.boundary_loops);
  }

  void compare_whole(const Json& claims, const JoinedCurves& whole) {
    begin_whole(claims, whole);
    compare(claims, "lines", whole.lines);
    compare(claims, "components", whole.components.size());
    compare(claims, "closed_components", whole.closed);
  }

  /// @param whole  a surface or curves
  template <class Whole>
  void begin_whole(const Json& claims, const Whole& whole) {
    ledger_.begin("whole");
    compare(claims, "tetrahedra", report_.subject.tetrahedra);
    compare(claims, "vertices", whole.vertices);
    report_.subject.vertices = whole.vertices;
    level_.components = whole.components;
    if (whole.has_numbers) std::erase(report_.subject.bound_only, "whole_component");
  }

  const std::string &input_, &surface_, &certificate_;
  Report report_;
  Ledger ledger_;
  LevelReport level_;
  std::string tensor_, order_;
  std::string incomplete_;  ///< a part with edges that are on no face of its border
  bool of_curves_ = false, has_part_ = false;
  std::vector<PartBorder> borders_;  ///< of surfaces
  std::vector<PartCurves> curves_;
};

}  // namespace

Report check_parts(const std::string& input, const std::string& surface,
                   const std::string& certificate, const Progress& progress) {
  return Parts(input, surface, certificate).check(progress);
}

}  // namespace certificate
