// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtkTensorDegenerateCurves.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <optional>
#include <stdexcept>

#include "output_data.hpp"
#include "parts/write_parts.hpp"
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
  const bool in_parts = IsCertifying() && input.ranks.are_several();
  request.certify = IsCertifying() && !in_parts;
  request.names = {grid.tensor, grid.components, IsCertificateCbor()};
  DegenerateCurves made;
  PieceCurves proved;
  std::optional<filters::PartsFiles> files;
  const ModeValue mode = ModeValue::parse(request.linear ? "1" : "-1");
  if (in_parts)
    request.show = [&](const ModeValue&, const KeyedCurves& of_piece) {
      const Degeneracy kind = request.linear ? Degeneracy::linear : Degeneracy::planar;
      proved = owned_curves(grid.piece, kind, of_piece);
    };
  input.ranks.together([&] {
    request.uncertainty = filters::uncertainty_of(GetUncertainty());
    if (in_parts) {
      if (request.linear && request.planar)
        throw std::invalid_argument(
            "CertificateFile: on several ranks a certificate is about one kind of curves; choose "
            "linear or planar");
      files = filters::require_parts_files(GetCertificateFile(), input.ranks, input.whole);
    }
    if (grid.cells.empty()) return;
    Run([&](const Report& report) {
      request.progress = report;
      made = ModeExtractor(grid.piece.mesh).curves(request);
    });
  });
  const std::vector<filters::WholeCurves> counts =
      input.ranks.are_several()
          ? filters::number_components(made, grid, input.ranks, input.whole)
          : filters::counted(made);
  const auto certify_part = [&] {
    filters::PartBytes part;
    Run([&](const Report& report) {
      report("certificate", 0);
      part = filters::part_bytes(
          grid, proved,
          filters::of_own_cells(grid.piece, made.curves.tet, made.curves.component));
    });
    return part;
  };
  if (in_parts)
    filters::write_parts(input.ranks, input.whole, *files,
                         filters::whole_output(mode, counts.front()), grid, certify_part);
  else if (IsCertifying())
    WriteCertificate(made.certificate);

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  if (input.ranks.are_several() || !input.in_pieces) filters::fill(output, counts);
  filters::fill(output, made.curves, grid, made.more);
  filters::fill(vtkUnstructuredGrid::GetData(outputs, 1), made.unresolved, grid);
}

void vtkTensorDegenerateCurves::PrintSelf(std::ostream& os, vtkIndent indent) {
  Superclass::PrintSelf(os, indent);
  os << indent << "Curves: " << Curves << '\n';
}
