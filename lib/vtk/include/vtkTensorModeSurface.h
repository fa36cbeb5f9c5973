// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vtkTensorTopology.h"

/// The mode surfaces of a symmetric tensor field on linear tetrahedra.
///
/// Input: a vtkUnstructuredGrid with point tensors of six or nine components (the array to process;
/// by default the active tensors, else the only candidate). Outputs: 0, the surfaces; 1, the
/// degenerate curves, if asked for; 2, the cells that no proof covers, with their reasons.
///
/// Surfaces have point arrays `mode`, `medium_eigenvector`, `dominant_eigenvector`, `residual` and
/// normals, and cell arrays `tet` and `component`: bit for bit those that `tensortopo extract`
/// writes. Field arrays count each mode's surface: `surface_mode`, `components`,
/// `euler_characteristic`, `boundary_loops`. Modes are exact: "1/2 -0.9".
///
/// With several pieces the input needs a layer of ghost cells and global ids of points and cells;
/// then all samples are kept, and the pieces fit each other bit for bit. If the controller knows
/// the other pieces, `component` and the field arrays are those of the whole surface on all ranks.
/// It is checked that the ranks own each cell once and have all ghosts, that vertices that they
/// share agree, and that sides of triangles between them have partners; what is wrong is an error
/// on all of them. Otherwise components are those of the piece, and there are no field arrays.
/// Output 1 is as output 0 of vtkTensorDegenerateCurves.
class TENSORTOPOFILTERS_EXPORT vtkTensorModeSurface : public vtkTensorTopology {
 public:
  static vtkTensorModeSurface* New();  ///< as of any VTK filter
  vtkTypeMacro(vtkTensorModeSurface, vtkTensorTopology)
  void PrintSelf(std::ostream& os, vtkIndent indent) override;  ///< for debugging

  ///@{
  /// Modes in (-1, 1), exactly: decimals and fractions, separated by spaces, commas or semicolons.
  vtkSetStdStringFromCharMacro(Modes);
  vtkGetCharFromStdStringMacro(Modes);
  ///@}
  ///@{
  /// With this on, the mode is the shortest decimal of ModeNumber, for a slider. Default off.
  vtkSetMacro(UseModeNumber, bool);
  vtkGetMacro(UseModeNumber, bool);
  vtkSetClampMacro(ModeNumber, double, -0.999999, 0.999999);
  vtkGetMacro(ModeNumber, double);
  ///@}
  ///@{
  /// After each mode also the opposite one. Default off.
  vtkSetMacro(Generalized, bool);
  vtkGetMacro(Generalized, bool);
  ///@}
  ///@{
  /// The largest proved distance between triangles and level, in the unit of the points; 0, the
  /// default, for none.
  vtkSetClampMacro(MaximumError, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}
  ///@{
  /// Keep samples that make needles of triangles. Default off.
  vtkSetMacro(AllSamples, bool);
  vtkGetMacro(AllSamples, bool);
  ///@}
  ///@{
  /// Better angles, the same topology. Not on several ranks. Default off.
  vtkSetMacro(ImproveTriangles, bool);
  vtkGetMacro(ImproveTriangles, bool);
  ///@}
  ///@{
  /// Degenerate curves on output 1: 0 none (default), 1 linear, 2 planar, 3 both.
  vtkSetClampMacro(Curves, int, 0, 3);
  vtkGetMacro(Curves, int);
  ///@}

 protected:
  vtkTensorModeSurface();
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Extract(const Input& input, vtkInformationVector* outputs) override;

 private:
  std::string Modes = "0";
  bool UseModeNumber = false;
  double ModeNumber = 0;
  bool Generalized = false;
  double MaximumError = 0;
  bool AllSamples = false;
  bool ImproveTriangles = false;
  int Curves = 0;
};
