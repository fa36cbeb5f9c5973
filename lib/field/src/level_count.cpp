// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/level_count.hpp"

#include <cstddef>
#include <vector>

#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/scalar/interval.hpp"

namespace tensortopo {

namespace {

using Tensors = std::array<SymmetricTensor<double>, 4>;

class Count {
 public:
  Count(const ModeValue& mode, int side, const ModeValue* from = nullptr)
      : mode_(to_scalar<Interval>(mode)), side_(side) {
    if (from != nullptr) from_ = to_scalar<Interval>(*from);
  }

  const LevelCount& result() const { return result_; }

  /// @param dimension  of the stratum of the point
  /// @return false if what the point adds is not certain
  bool add(const CriticalPoint& point, int dimension) {
    const bool is_larger = point.low > mode_.sup(), is_smaller = point.high < mode_.inf();
    if (side_ > 0 ? is_smaller : is_larger) return true;
    if (from_ && (side_ > 0 ? point.low > from_->sup() : point.high < from_->inf())) return true;
    const bool may_be_beyond =
        from_ && !(side_ > 0 ? point.high < from_->inf() : point.low > from_->sup());
    std::size_t up = 0, down = 0;
    for (const Verdict v : point.towards) {
      up += v == (side_ > 0 ? Verdict::positive : Verdict::negative);
      down += v == (side_ > 0 ? Verdict::negative : Verdict::positive);
    }
    if (up > 0 && down > 0) return true;  // nothing changes there
    if (!(side_ > 0 ? is_larger : is_smaller) || may_be_beyond || !point.is_certain ||
        up + down < point.towards.size())
      return false;
    const int growing = side_ > 0 ? dimension - point.index : point.index;
    const int cell = growing % 2 == 0 ? 1 : -1;  // its Euler characteristic
    const int of_boundary = dimension == 3 ? 0 : up == 0 ? cell : dimension == 2 ? cell
                                                              : dimension == 1  ? -cell
                                                                                : 1;
    const int of_inside = up == 0 ? cell : 0;
    result_.inside += of_inside;
    result_.boundary += of_boundary;
    result_.bridges += up == 0 && growing == 1 ? 1 : 0;
    return true;
  }

  bool add(const std::vector<CriticalPoint>& points, int dimension) {
    for (const auto& point : points)
      if (!add(point, dimension)) return false;
    return true;
  }

 private:
  Interval mode_;
  std::optional<Interval> from_;
  int side_;
  LevelCount result_;
};

std::optional<LevelCount> counted(Count count, const Tensors& t) {
  for (std::size_t i = 0; i < 4; ++i)
    if (!count.add(
            critical_vertex(t[i], std::array{t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}), 0))
      return std::nullopt;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      std::array<SymmetricTensor<double>, 2> around;
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != i && k != j) around[n++] = t[k];
      if (!count.add(critical_points_on_edge({t[i], t[j]}, around), 1)) return std::nullopt;
    }
  for (std::size_t i = 0; i < 4; ++i)
    if (!count.add(critical_points_on_face({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]},
                                           std::array{t[i]}),
                   2))
      return std::nullopt;
  if (!count.add(critical_points_in_tet(t), 3)) return std::nullopt;
  return count.result();
}

}  // namespace

std::optional<LevelCount> count_level(const Tensors& t, const ModeValue& mode, int side) {
  return counted(Count(mode, side), t);
}

std::optional<LevelCount> count_change(const Tensors& t, const ModeValue& from,
                                       const ModeValue& mode, int side) {
  return counted(Count(mode, side, &from), t);
}

}  // namespace tensortopo
