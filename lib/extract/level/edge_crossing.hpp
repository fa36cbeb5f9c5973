// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo {

/// A point of the level on an edge of the mesh.
template <class Scalar>
struct EdgeCrossing {
  Scalar weight{};      ///< of the second vertex; that of the first is 1 - weight
  bool rising = false;  ///< the mode passes mu upwards from the first vertex to the second
};

}  // namespace tensortopo
