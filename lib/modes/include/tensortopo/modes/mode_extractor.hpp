// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tensortopo/extract/curve_keys.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/stability/stability_run.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

struct Extraction;

/// Told now and then, by one thread at a time, what is going on and how much of it is done, in
/// [0, 1]. What it throws ends the extraction, and reaches the caller.
using ModeProgress = std::function<void(std::string_view stage, double fraction)>;

/// What a certificate calls its field.
struct CertificateNames {
  std::string tensor = "tensor";   ///< the array
  std::string components = "vtk";  ///< the order of its components, as in CertificateSubject
  bool cbor = false;               ///< CBOR instead of JSON
};

/// The mode surfaces of some modes.
struct SurfaceRequest {
  std::vector<ModeValue> modes;  ///< strictly between -1 and 1; repetitions count once
  bool generalized = false;      ///< after each mode its opposite
  /// Samples per radian of turning of the medium eigenvector, > 0 and at most 1000.
  double resolution = 4;
  bool all_samples = false;      ///< keep samples that make needles of triangles
  bool improve = false;          ///< better angles, the same topology; not with `max_error`
  MeshingMethod meshing = MeshingMethod::bisection;  ///< how sheets that turn far are meshed
  double max_error = 0;          ///< proved distance, in the mesh's units; 0 for `resolution` alone
  std::optional<Uncertainty> uncertainty;  ///< say what is the same for all fields within it
  bool certify = false;                    ///< make a certificate
  CertificateNames names;                  ///< what it says of the field
  /// Shown what is extracted of each mode, with what was proved (`ExtractOptions::keep_topology`),
  /// before it goes into the output; may be empty.
  std::function<void(const ModeValue& mode, const Extraction& made)> show;
  ModeProgress progress;                   ///< may be empty
};

/// The degenerate curves: linear ones, planar ones, or first these and then those.
struct CurveRequest {
  /// Which kinds.
  bool linear = true, planar = false;
  /// Samples per radian of turning of the dominant eigenvector, > 0 and at most 1000.
  double resolution = 4;
  std::optional<Uncertainty> uncertainty;  ///< say what is the same for all fields within it
  bool certify = false;  ///< make a certificate
  CertificateNames names;  ///< what it says of the field
  /// Shown what is extracted of each kind, before it goes into the output; may be empty.
  std::function<void(const ModeValue& mode, const KeyedCurves& made)> show;
  ModeProgress progress;  ///< may be empty
};

/// A tetrahedron that an output leaves out.
struct LeftOut {
  TetMesh::Index tet = -1;  ///< position in the mesh
  std::string reason;  ///< the name that reports use
  ModeValue mode;  ///< of the output that it is missing in
};

/// One mode's part of an output: its vertices and cells follow those of the part before.
struct ModePart {
  ModeValue mode;  ///< of this part
  /// How many; cells are triangles, or lines.
  std::size_t vertices = 0, cells = 0;
  SurfaceInvariants invariants;         ///< of a surface; `component` is left empty
  CurveInvariants curve_invariants;     ///< of curves
  std::optional<double> distance_bound;  ///< of a surface, to the level, both ways, if proved
  std::size_t tets_farther = 0;          ///< tetrahedra without the distance that was asked for
  std::vector<TetMesh::Index> not_embedded;  ///< of a surface: see `Extraction`
  std::optional<StabilitySummary> stability;  ///< of an uncertain field
  std::vector<std::pair<std::string, double>> statistics;  ///< what the extraction counted
};

/// Surfaces of several modes, as one output.
struct ModeSurfaces {
  SurfaceMesh surface;  ///< all of them
  std::vector<CellArray> more;     ///< of an uncertain field: see `StabilityRun::arrays`
  std::vector<ModePart> parts;     ///< one for each mode, in order
  std::vector<LeftOut> unresolved;  ///< by mode, then tetrahedron
  std::string certificate;         ///< the bytes of a file, if asked for
  std::size_t claims = 0;          ///< that it makes
  std::size_t undecided = 0;       ///< tetrahedra about which it makes none, of all modes
};

/// Degenerate curves, as one output.
struct DegenerateCurves {
  CurveMesh curves;  ///< all of them
  std::vector<CellArray> more;  ///< of an uncertain field: see `StabilityRun::arrays`
  std::vector<ModePart> parts;  ///< linear ones first
  std::vector<CurveKeys> keys;  ///< of each part, for curves of a mesh in pieces
  std::vector<LeftOut> unresolved;  ///< by kind, then tetrahedron
  std::string certificate;  ///< the bytes of a file, if asked for
  std::size_t claims = 0;  ///< that it makes
  std::size_t undecided = 0;  ///< tetrahedra about which it makes none, of both kinds
};

/// Mode surfaces and degenerate curves of one mesh, as one output with its certificate. What the
/// modes have in common is computed once, at the first request.
///
/// Laws      (1) outputs depend on the mesh and the request only, not on threads or on what was
///           asked for before; (2) they are those that `tensortopo extract` writes, bit for bit.
/// May be used by several threads at a time.
class ModeExtractor {
 public:
  /// @param mesh  valid (see `validate`); must live as long
  explicit ModeExtractor(const TetMesh& mesh);
  ~ModeExtractor();
  ModeExtractor(const ModeExtractor&) = delete;
  ModeExtractor& operator=(const ModeExtractor&) = delete;

  /// Throws std::invalid_argument for requests that make no sense, with the reason.
  ModeSurfaces surfaces(const SurfaceRequest& request) const;
  /// As `surfaces`.
  DegenerateCurves curves(const CurveRequest& request) const;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

/// A mode for surfaces, or 1 or -1 for curves: throws std::invalid_argument as ModeValue::parse
/// does, and for other modes that no double tells from 1 or -1.
ModeValue parse_surface_mode(std::string_view text);

}  // namespace tensortopo
