// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/mesh_level.hpp"

#include <utility>

#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/boundary/find_crossings.hpp"
#include "extract/surface/boundary/trace_faces.hpp"

namespace tensortopo {

template <class Scalar>
MeshedLevel<Scalar> mesh_level(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                               const TetComplex& cells, StageSeconds& seconds) {
  Stopwatch watch;
  auto crossings = find_crossings(input, sides, cells);
  seconds.edges += watch.lap();
  auto boundary = trace_faces(input, sides, cells, std::move(crossings));
  seconds.faces += watch.lap();
  MeshedLevel<Scalar> result;
  result.proofs = prove_cells(input, sides, cells, boundary);
  result.meshes = mesh_cells(input, sides, cells, std::move(boundary), result.proofs);
  seconds.tets += watch.lap();
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                     \
  template MeshedLevel<Scalar> mesh_level(const SurfaceInput<Scalar>&, const VertexSides&, \
                                          const TetComplex&, StageSeconds&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
