// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_drawing.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "extractor_scalars.hpp"
#include "sheet_check.hpp"
#include "split_triangles.hpp"

namespace tensortopo {

template <class Scalar>
bool SheetDrawing<Scalar>::triangulate() {
  ChartTriangulation triangulation;
  const auto points = points_;  // `grid_samples` adds to the images
  if (!triangulation.build(points, segments_,
                           [&](const auto& clearance) { return grid_samples(clearance); }))
    return false;
  triangles_ = std::move(triangulation.triangles);
  return true;
}

template <class Scalar>
bool SheetDrawing<Scalar>::split_diagonals() {
  std::set<std::pair<std::int32_t, std::int32_t>> rim;
  for (const auto& loop : rims_)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto a = loop[i].id, b = loop[(i + 1) % loop.size()].id;
      rim.emplace(std::min(a, b), std::max(a, b));
    }
  std::map<UndirectedEdge, std::vector<std::size_t>> apexes;  // of the diagonals
  for (const auto& t : triangles_)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      const auto &p = images_[a], &q = images_[b];
      if ((p.faces & q.faces) == 0) continue;
      if (rim.contains({std::min(p.corner, q.corner), std::max(p.corner, q.corner)})) continue;
      apexes[std::minmax(a, b)].push_back(t[(i + 2) % 3]);
    }
  std::map<UndirectedEdge, std::size_t> middle;
  for (const auto& [e, tips] : apexes) {
    std::optional<std::size_t> image;
    for (const double lean : {0.0, 0.2, 0.5, 0.8, 2.0, 5.0})
      for (const auto tip : tips)
        if (!image)
          image = add_inner_image(images_[e.first].v + images_[e.second].v +
                                  lean * images_[tip].v);
    if (!image) return false;
    middle[e] = *image;
  }
  triangles_ = split_triangles(triangles_, middle);
  return true;
}

template <class Scalar>
bool SheetDrawing<Scalar>::raise_flat_triangles() {
  const std::size_t count = triangles_.size();
  for (std::size_t t = 0; t < count; ++t) {
    const auto [a, b, c] = triangles_[t];
    const auto &p = images_[a], &q = images_[b], &r = images_[c];
    if ((p.faces & q.faces & r.faces) == 0) continue;
    std::optional<std::size_t> image;
    for (const double lean : {1.0, 0.5, 0.2})
      for (int turn = 0; turn < 3; ++turn)
        if (!image)
          image = add_inner_image((turn == 0 ? 1 : lean) * p.v + (turn == 1 ? 1 : lean) * q.v +
                                  (turn == 2 ? 1 : lean) * r.v);
    if (!image) return false;
    triangles_[t][2] = *image;
    triangles_.push_back({b, c, *image});
    triangles_.push_back({c, a, *image});
  }
  return true;
}

template <class Scalar>
bool SheetDrawing<Scalar>::emit() {
  std::set<std::pair<std::int32_t, std::int32_t>> rim;
  for (const auto& loop : rims_)
    for (std::size_t i = 0; i < loop.size(); ++i)
      rim.emplace(loop[i].id, loop[(i + 1) % loop.size()].id);
  bool along = false, against = false;
  std::vector<std::array<std::int32_t, 3>> triangles;
  for (const auto& t : triangles_) {
    triangles.push_back({images_[t[0]].corner, images_[t[1]].corner, images_[t[2]].corner});
    for (std::size_t i = 0; i < 3; ++i) {
      along |= rim.contains({triangles.back()[i], triangles.back()[(i + 1) % 3]});
      against |= rim.contains({triangles.back()[(i + 1) % 3], triangles.back()[i]});
    }
  }
  if (along == against) return false;
  if (against)
    for (auto& t : triangles) std::swap(t[1], t[2]);
  if (!are_planned_sheets(triangles, rims_, plan_.sheets)) return false;
  out_.triangles.insert(out_.triangles.end(), triangles.begin(), triangles.end());
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class SheetDrawing<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
