// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vtkTensorTopology.h"

/// The curves of degenerate points of a symmetric tensor field on linear tetrahedra.
///
/// Input as of vtkTensorModeSurface. Outputs: 0, the curves, with point arrays `mode`,
/// `dominant_eigenvector`, `residual` and `separation`, and cell arrays `tet` and `component`; 1,
/// the cells that no proof covers, with their reasons. Field arrays of output 0, one number for each
/// kind: `curve_mode`, `components` and `closed_components` of the whole curves. On several ranks
/// components are those of the whole curves; of pieces without ranks, those of the piece.
class TENSORTOPOFILTERS_EXPORT vtkTensorDegenerateCurves : public vtkTensorTopology {
 public:
  static vtkTensorDegenerateCurves* New();  ///< as of any VTK filter
  vtkTypeMacro(vtkTensorDegenerateCurves, vtkTensorTopology)
  void PrintSelf(std::ostream& os, vtkIndent indent) override;  ///< for debugging

  ///@{
  /// 1 linear, 2 planar, 3 both (default).
  vtkSetClampMacro(Curves, int, 1, 3);
  vtkGetMacro(Curves, int);
  ///@}

 protected:
  vtkTensorDegenerateCurves();
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Extract(const Input& input, vtkInformationVector* outputs) override;

 private:
  int Curves = 3;
};
