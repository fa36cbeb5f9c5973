// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "extract/patch/quality/cell_patch.hpp"

namespace tensortopo {

/// A triangle is a needle if the sine of its least angle is no larger.
inline constexpr double kSineOfNeedle = 0.26;

/// A curve of a face, as vertices in a row.
struct CurveChain {
  std::vector<CellPatch::Id> vertices;  ///< with its ends, unless it is closed
  bool is_closed = false;
  std::size_t least = 0;  ///< how many samples stay
  /// How far the level may be from where a sample was taken out, see `CellPatch::offset_after`.
  double flatness = 0;
  double least_cosine = 0;      ///< see `CellPatch::least_sine_after`
  bool stays_embedded = false;  ///< whether `CellPatch::is_embedded_after` has to hold
  Vector3<double> area{};       ///< twice that of a closed one; kept while samples are taken out
};

/// The samples at which a triangle is a needle, ascending.
std::vector<CellPatch::Id> samples_at_needles(const CellPatch& patch,
                                              const std::vector<CurveChain>& chains);

/// What one tetrahedron says about samples that might be taken out.
struct ThinningProposal {
  std::vector<CellPatch::Id> accepted;  ///< it can do without all of these; ascending
  std::vector<CellPatch::Id> wanted;    ///< of these, those that made needles when their turn came
};

/// Takes samples out of a patch, in passes along the curves until none is left to take. Each makes
/// the least angle around larger, or leaves it no needle.
/// @param candidates  the samples that may be taken out; ascending
ThinningProposal propose_thinning(CellPatch& patch, std::vector<CurveChain> chains,
                                  const std::vector<CellPatch::Id>& candidates);

/// Takes out the samples given, whatever the angles are, unless sheets would change their topology,
/// touch a face, turn over or, if asked for, not be embedded.
/// @param samples  ascending
/// @return those that stay
std::vector<CellPatch::Id> take_out(CellPatch& patch, std::vector<CurveChain> chains,
                                    const std::vector<CellPatch::Id>& samples);

}  // namespace tensortopo
