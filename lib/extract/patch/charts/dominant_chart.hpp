// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "extract/patch/charts/manifold_mesher.hpp"

namespace tensortopo {

/// A plane chart of a mode surface by the turning of its frames: how far its dominant eigenvector
/// is around the cone of degenerate directions, and how far the medium one is turned about it.
///
/// The dominant eigenvectors e of degenerate tensors lie on the cone e N e = 0 of the
/// characteristic tensor N, once around its axis for the whole degenerate curve; around each of
/// them the medium eigenvector turns by half a turn. Both angles stay apart on the tube of a level
/// next to mode 1 or -1 however thin it is, and along the singular lines of planes of symmetry,
/// where the medium eigenvector alone does not tell the place. (The surface as a torus: Theorem 5.)
/// If N is neutral, or next to it, the cone is a pair of planes, and a tube follows one of them
/// across the other.
class DominantChart {
 public:
  using Point = std::array<double, 2>;

  /// Around what dominant eigenvectors turn: the axis of the cone, or the normal of a plane.
  enum class About { cone, first_plane, second_plane };

  /// Angles in radians.
  struct Place {
    double around;  ///< of the dominant eigenvector about the axis
    double turn;    ///< twice that of the medium eigenvector about the dominant one
  };

  /// @param mode of the level
  DominantChart(const CharacteristicTensor<double>& characteristic,
                const ModeParameter<double>& mode, About about);

  /// A turn of the cone, or half a turn of a plane (e and -e are one place) makes once around.
  double period() const { return period_; }

  /// Of a tensor with these unit eigenvectors, of either sign: from the cut once around.
  Place place(const Vector3<double>& dominant, const Vector3<double>& medium) const;

  /// The field's unit tensor of the mode at a place, up to a factor: of mode +|mu|, as from
  /// `MediumEigenvectorManifold::tensor_at`. Nothing if none is found near the cone.
  std::optional<SymmetricTensor<double>> tensor(const Place& place) const;

  /// Where the chart is cut open: no sheet is there.
  void cut_at(double around) { cut_ = around; }

  /// Places around the axis will be shown, in rows from each of these to the next one. If there is
  /// a turn that no sheet has, it is cut there as well, and how many rows and how much turn it is
  /// are coordinates; else they are polar, the radius growing so much that chords of one ring do
  /// not meet those of another.
  /// @param rows   ascending
  /// @param height of a row in the chart
  void lay_out(std::vector<double> rows, double height, const std::optional<double>& turn_cut);

  Point point(const Place& place) const;
  /// Its inverse.
  Place place_at(const Point& point) const;
  /// In the chart, what an eigenvector's turn by this angle makes, about, at a place.
  double length_of(double turn, const Point& at) const;

 private:
  /// A unit vector at these angles around the axis and above the plane across it, and the
  /// directions in which they grow; along the characteristic eigenvectors.
  struct Frame {
    Vector3<double> e, up, along;
  };
  Frame frame_at(double around, double elevation) const;
  double along(double around) const;
  double around_at(double along) const;

  CharacteristicTensor<double> characteristic_;
  ModeParameter<double> mode_;
  About about_;
  std::array<Vector3<double>, 3> axes_;  ///< the last is turned about; along the eigenvectors
  double period_, cut_ = 0;
  std::vector<double> rows_;
  double height_ = 0;
  std::optional<double> turn_cut_;
};

}  // namespace tensortopo
