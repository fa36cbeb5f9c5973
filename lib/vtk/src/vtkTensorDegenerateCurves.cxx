// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtkTensorDegenerateCurves.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include "output_data.hpp"
#include "ranks.hpp"
#include "whole_curves.hpp"

using namespace tensortopo;

vtkStandardNewMacro(vtkTensorDegenerateCurves);

vtkTensorDegenerateCurves::vtkTensorDegenerateCurves() { SetNumberOfOutputPorts(2); }

int vtkTensorDegenerateCurves::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

void vtkTensorDegenerateCurves::Extract(const Input& input, vtkInformationVector* outputs) {
  const filters::TensorGrid& grid = input.grid;
  CurveRequest request;
  request.linear = (Curves & 1) != 0, request.planar = (Curves & 2) != 0;
  request.resolution = GetSampling();
  request.certify = IsCertifying();
  request.names = {grid.tensor, grid.components, IsCertificateCbor()};
  DegenerateCurves made;
  input.ranks.together([&] {
    request.uncertainty = filters::uncertainty_of(GetUncertainty());
    if (grid.cells.empty()) return;
    Run([&](const Report& report) {
      request.progress = report;
      made = ModeExtractor(grid.piece.mesh).curves(request);
    });
  });
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  if (input.ranks.are_several())
    filters::fill(output, filters::number_components(made, grid, input.ranks, input.whole));
  else if (!input.in_pieces)
    filters::fill(output, filters::counted(made));
  filters::fill(output, made.curves, grid, made.more);
  filters::fill(vtkUnstructuredGrid::GetData(outputs, 1), made.unresolved, grid);
  if (IsCertifying()) WriteCertificate(made.certificate);
}

void vtkTensorDegenerateCurves::PrintSelf(std::ostream& os, vtkIndent indent) {
  Superclass::PrintSelf(os, indent);
  os << indent << "Curves: " << Curves << '\n';
}
