// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtkTensorModeSurface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <charconv>
#include <stdexcept>

#include "output_data.hpp"
#include "ranks.hpp"
#include "whole_curves.hpp"
#include "whole_surface.hpp"

using namespace tensortopo;

vtkStandardNewMacro(vtkTensorModeSurface);

namespace {

std::vector<ModeValue> modes_of(const std::string& text) {
  std::vector<ModeValue> modes;
  const char* const separators = " ,;\t\n";
  for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
    const std::size_t end = text.find_first_of(separators, at);
    modes.push_back(parse_surface_mode(text.substr(at, end - at)));
    at = text.find_first_not_of(separators, std::min(end, text.size()));
  }
  return modes;
}

/// The shortest decimal that reads back as the number.
std::string shortest(double number) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

}  // namespace

vtkTensorModeSurface::vtkTensorModeSurface() { SetNumberOfOutputPorts(3); }

int vtkTensorModeSurface::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

void vtkTensorModeSurface::Extract(const Input& input, vtkInformationVector* outputs) {
  const filters::TensorGrid& grid = input.grid;
  SurfaceRequest surfaces;
  surfaces.generalized = Generalized;
  surfaces.resolution = GetSampling();
  surfaces.max_error = MaximumError;
  // Whether a sample can be done without depends on more than the tetrahedra around it.
  surfaces.all_samples = AllSamples || input.in_pieces;
  surfaces.improve = ImproveTriangles;
  surfaces.certify = IsCertifying();
  surfaces.names = {grid.tensor, grid.components, IsCertificateCbor()};
  CurveRequest curves;
  curves.linear = (Curves & 1) != 0, curves.planar = (Curves & 2) != 0;
  curves.resolution = GetSampling();

  ModeSurfaces surface;
  DegenerateCurves lines;
  input.ranks.together([&] {
    surfaces.modes = modes_of(UseModeNumber ? shortest(ModeNumber) : Modes);
    surfaces.uncertainty = curves.uncertainty = filters::uncertainty_of(GetUncertainty());
    if (ImproveTriangles && input.ranks.are_several())
      throw std::invalid_argument(
          "ImproveTriangles: moves vertices that ranks share; switch it off on several ranks");
    if (grid.cells.empty()) return;
    Run([&](const Report& report) {
      const ModeExtractor extractor(grid.piece.mesh);
      surfaces.progress = report;
      surface = extractor.surfaces(surfaces);
      if (Curves == 0) return;
      curves.progress = report;
      lines = extractor.curves(curves);
    });
  });
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  if (input.ranks.are_several())
    filters::fill(output, filters::number_components(surface, grid, input.ranks, input.whole));
  else if (!input.in_pieces)
    filters::fill(output, filters::counted(surface));
  filters::fill(output, surface.surface, grid, surface.more);
  if (Curves != 0) {
    vtkPolyData* of_curves = vtkPolyData::GetData(outputs, 1);
    if (input.ranks.are_several())
      filters::fill(of_curves, filters::number_components(lines, grid, input.ranks, input.whole));
    else if (!input.in_pieces)
      filters::fill(of_curves, filters::counted(lines));
    filters::fill(of_curves, lines.curves, grid, lines.more);
    surface.unresolved.insert(surface.unresolved.end(), lines.unresolved.begin(),
                              lines.unresolved.end());
  }
  filters::fill(vtkUnstructuredGrid::GetData(outputs, 2), surface.unresolved, grid);
  if (IsCertifying()) WriteCertificate(surface.certificate);
}

void vtkTensorModeSurface::PrintSelf(std::ostream& os, vtkIndent indent) {
  Superclass::PrintSelf(os, indent);
  os << indent << "Modes: " << Modes << '\n'
     << indent << "UseModeNumber: " << UseModeNumber << '\n'
     << indent << "ModeNumber: " << ModeNumber << '\n'
     << indent << "Generalized: " << Generalized << '\n'
     << indent << "MaximumError: " << MaximumError << '\n'
     << indent << "AllSamples: " << AllSamples << '\n'
     << indent << "ImproveTriangles: " << ImproveTriangles << '\n'
     << indent << "Curves: " << Curves << '\n';
}
