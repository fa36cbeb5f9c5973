// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/level_count.hpp"

#include <cstddef>

#include "tensortopo/scalar/interval.hpp"

namespace tensortopo {

namespace {

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

 private:
  Interval mode_;
  std::optional<Interval> from_;
  int side_;
  LevelCount result_;
};

std::optional<LevelCount> counted(Count count, const CellCriticalPoints& points) {
  for (std::size_t dimension = 0; dimension < 4; ++dimension)
    for (const CriticalPoint& point : points.of_dimension[dimension])
      if (!count.add(point, static_cast<int>(dimension))) return std::nullopt;
  return count.result();
}

}  // namespace

std::optional<LevelCount> count_level(const CellCriticalPoints& points, const ModeValue& mode,
                                      int side) {
  return counted(Count(mode, side), points);
}

std::optional<LevelCount> count_change(const CellCriticalPoints& points, const ModeValue& from,
                                       const ModeValue& mode, int side) {
  return counted(Count(mode, side, &from), points);
}

}  // namespace tensortopo
