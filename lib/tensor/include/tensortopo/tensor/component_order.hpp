// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tensortopo {

/// The order in which a file lists the components of a symmetric tensor.
enum class ComponentOrder : std::uint8_t {
  vtk,     ///< XX YY ZZ XY YZ XZ
  voigt,   ///< XX YY ZZ YZ XZ XY
  abaqus,  ///< XX YY ZZ XY XZ YZ; MRtrix' too
  nifti,   ///< XX XY YY XZ YZ ZZ, the lower triangle row by row; DIPY's too
  fsl,     ///< XX XY XZ YY YZ ZZ, the upper triangle row by row
  full,    ///< the nine of a 3x3 matrix, row by row
};

/// How the order is known.
enum class ComponentSource : std::uint8_t {
  assumed,  ///< nobody says: VTK's of six, row by row of nine
  given,    ///< by the caller
  named,    ///< by the file: it names the components
};

/// What was taken for the components of a tensor, and why.
struct TensorComponents {
  ComponentOrder order = ComponentOrder::vtk;         ///< in which they were taken
  ComponentSource source = ComponentSource::assumed;  ///< who said so

  /// "XX YY ZZ XY XZ YZ (abaqus, named in the file)"
  std::string text() const;
};

/// "vtk", ...
std::string_view name_of(ComponentOrder order);

/// "XX YY ZZ XY YZ XZ", ...
std::string_view listing_of(ComponentOrder order);

/// An order of six components by its name, or by an alias (`mrtrix`, `dipy`); empty if unknown.
std::optional<ComponentOrder> component_order(std::string_view name);

/// All names that `component_order` knows.
const std::vector<std::string_view>& component_order_names();

/// Where the components XX YY ZZ XY YZ XZ are among those that the order lists.
std::array<std::uint8_t, 6> places_in(ComponentOrder order);

}  // namespace tensortopo
