// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "tensortopo/persistence/merge_tree.hpp"

namespace tensortopo {

TetMesh opposite(TetMesh mesh) {
  for (auto& tensor : mesh.tensors) tensor = -1.0 * tensor;
  return mesh;
}

MeshCriticalValues opposite(MeshCriticalValues values) {
  const auto turn = [](double& low, double& high) {
    std::swap(low, high);
    low = -low, high = -high;
  };
  for (MeshCriticalPoint& point : values.points) {
    turn(point.low, point.high);
    for (std::size_t i = 0; i < 5; ++i) turn(point.deviator.low[i], point.deviator.high[i]);
    point.index = point.dimension - point.index;
    for (Verdict& sign : point.link.signs) {
      if (sign == Verdict::positive)
        sign = Verdict::negative;
      else if (sign == Verdict::negative)
        sign = Verdict::positive;
    }
    point.effect = local_effect(point.link);
  }
  return values;
}

}  // namespace tensortopo
