// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/join_curves.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "parts/glued_faces.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using Ends = std::vector<const BorderCurvePoint*>;

class CurveSeams {
 public:
  CurveSeams(const std::vector<PartCurves>& parts, Ledger& ledger)
      : parts_(parts), ledger_(ledger) {
    for (const PartCurves& part : parts) {
      first_component_.push_back(components_);
      components_ += part.components.size();
      glued_.emplace_back(part.component.size(), false);
    }
    is_open_.resize(components_);
  }

  /// False if something is refuted or open.
  bool glue() {
    const std::size_t open = ledger_.open();
    std::vector<const MeshBorder*> meshes;
    for (const PartCurves& part : parts_) meshes.push_back(&part);
    for (const GluedFace& face : glued_faces(meshes, ledger_)) compare(face);
    return !ledger_.has_refuted() && ledger_.open() == open;
  }

  JoinedCurves curves() {
    JoinedCurves whole;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (std::size_t v = 0; v < glued_[p].size(); ++v)
        if (!glued_[p][v] && parts_[p].line_ends[v] == 1)
          is_open_[first_component_[p] + parts_[p].component[v]] = true;
    constexpr auto kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> of_class(components_, kNone);
    std::size_t i = 0;
    for (const PartCurves& part : parts_)
      for (const PartCurve& curve : part.components) {
        std::size_t& known = of_class[classes_.find(i)];
        if (known == kNone) {
          known = whole.components.size();
          whole.components.push_back({0, 0, true, 0});
        }
        number_.push_back(known);
        whole.components[known].cells += curve.lines;
        if (is_open_[i]) whole.components[known].closed = false;
        whole.vertices += curve.vertices, whole.lines += curve.lines;
        ++i;
      }
    whole.vertices -= pairs_;
    for (const Component& own : whole.components) whole.closed += own.closed ? 1 : 0;
    return whole;
  }

  /// See `compare_whole_numbers`; after `curves`.
  bool compare_numbers(std::size_t count) const {
    std::vector<std::vector<SaidNumber>> said;
    for (const PartCurves& part : parts_) {
      auto& own = said.emplace_back();
      for (const PartCurve& curve : part.components) own.push_back(curve.said);
    }
    return compare_whole_numbers(said, number_, count, ledger_);
  }

 private:
  /// The points on a face, by number.
  Ends ends_on(const FaceOfPart& f) const {
    const auto& all = parts_[f.part].ends;
    Ends ends;
    auto end = std::lower_bound(
        all.begin(), all.end(), f.face,
        [](const BorderCurvePoint& e, std::uint32_t face) { return e.face < face; });
    for (; end != all.end() && end->face == f.face; ++end) ends.push_back(&*end);
    std::sort(ends.begin(), ends.end(), [](const BorderCurvePoint* a, const BorderCurvePoint* b) {
      return a->number < b->number;
    });
    return ends;
  }

  void compare(const GluedFace& face) {
    const Ends here = ends_on(face.one), there = ends_on(face.other);
    const auto is_unknown = [](const BorderCurvePoint* end) { return !end->number; };
    if (std::any_of(here.begin(), here.end(), is_unknown) ||
        std::any_of(there.begin(), there.end(), is_unknown))
      return ledger_.leave_open(face.name, "which point is which");
    const auto in_part = [](std::size_t part) { return " in part " + std::to_string(part); };
    if (!std::equal(here.begin(), here.end(), there.begin(), there.end(),
                    [](const auto* a, const auto* b) { return a->number == b->number; }))
      return ledger_.refute(face.name, "the same points on both sides",
                            std::to_string(here.size()) + in_part(face.one.part) + ", " +
                                std::to_string(there.size()) + in_part(face.other.part));
    for (std::size_t n = 0; n < here.size(); ++n)
      if (here[n]->place != there[n]->place)
        return ledger_.refute(face.name, "the same vertices on both sides",
                              place_text(here[n]->place) + in_part(face.one.part) + ", " +
                                  place_text(there[n]->place) + in_part(face.other.part));
    ledger_.certify();
    for (std::size_t n = 0; n < here.size(); ++n)
      glue(face.one.part, here[n]->vertex, face.other.part, there[n]->vertex);
  }

  /// A point is on one face, and a face is glued once: so no other vertex is glued to these.
  void glue(std::size_t p, std::uint32_t v, std::size_t q, std::uint32_t w) {
    const std::size_t one = first_component_[p] + parts_[p].component[v],
                      other = first_component_[q] + parts_[q].component[w];
    classes_.join(one, other);
    glued_[p][v] = glued_[q][w] = true;
    ++pairs_;
    if (parts_[p].line_ends[v] + parts_[q].line_ends[w] == 1) is_open_[one] = true;
  }

  const std::vector<PartCurves>& parts_;
  Ledger& ledger_;
  std::vector<std::size_t> first_component_;  ///< of each part, among those of all
  std::size_t components_ = 0, pairs_ = 0;    ///< of all parts; of glued vertices
  UnionFind classes_;                         ///< of components
  std::vector<std::vector<bool>> glued_;      ///< of each part's vertices
  std::vector<bool> is_open_;                 ///< of components: one line ends somewhere
  std::vector<std::size_t> number_;           ///< of each part's component, in the whole
};

}  // namespace

std::optional<JoinedCurves> join_curves(const std::vector<PartCurves>& parts, Ledger& ledger) {
  ledger.begin("seams");
  CurveSeams seams(parts, ledger);
  if (!seams.glue()) return std::nullopt;
  JoinedCurves whole = seams.curves();
  ledger.begin("arrays");
  whole.has_numbers = seams.compare_numbers(whole.components.size());
  return whole;
}

}  // namespace certificate
