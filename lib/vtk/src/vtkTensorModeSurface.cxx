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
#include <optional>
#include <stdexcept>

#include "output_data.hpp"
#include "parts/write_parts.hpp"
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

/// A certificate of parts is about one level.
void require_one_level(const SurfaceRequest& request) {
  for (const ModeValue& mode : request.modes)
    if (mode != request.modes.front() || (request.generalized && mode != mode.opposite()))
      throw std::invalid_argument(
          "CertificateFile: on several ranks a certificate is about one mode; give one");
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
  const bool in_parts = IsCertifying() && input.ranks.are_several();
  surfaces.certify = IsCertifying() && !in_parts;
  surfaces.names = {grid.tensor, grid.components, IsCertificateCbor()};
  CurveRequest curves;
  curves.linear = (Curves & 1) != 0, curves.planar = (Curves & 2) != 0;
  curves.resolution = GetSampling();

  ModeSurfaces surface;
  DegenerateCurves lines;
  PieceSurface proved;
  std::optional<filters::PartsFiles> files;
  if (in_parts)
    surfaces.show = [&](const ModeValue& mode, const Extraction& made) {
      proved = owned_surface(grid.piece, mode, made, true);
    };
  input.ranks.together([&] {
    surfaces.modes = modes_of(UseModeNumber ? shortest(ModeNumber) : Modes);
    surfaces.uncertainty = curves.uncertainty = filters::uncertainty_of(GetUncertainty());
    if (ImproveTriangles && input.ranks.are_several())
      throw std::invalid_argument(
          "ImproveTriangles: moves vertices that ranks share; switch it off on several ranks");
    if (in_parts) {
      require_one_level(surfaces);
      files = filters::require_parts_files(GetCertificateFile(), input.ranks, input.whole);
    }
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
  std::vector<filters::WholeSurface> surface_counts = filters::counted(surface);
  std::vector<filters::WholeCurves> curve_counts = filters::counted(lines);
  if (input.ranks.are_several()) {
    surface_counts = filters::number_components(surface, grid, input.ranks, input.whole);
    if (Curves != 0)
      curve_counts = filters::number_components(lines, grid, input.ranks, input.whole);
  }
  if (in_parts) {
    const ModeValue& mode = surfaces.modes.front();
    const auto certify_part = [&] {
      filters::PartBytes part;
      Run([&](const Report& report) {
        report("certificate", 0);
        part = filters::part_bytes(grid, proved, mode,
                                   filters::of_own_cells(grid.piece, surface.surface.tet,
                                                         surface.surface.component));
      });
      return part;
    };
    filters::write_parts(input.ranks, input.whole, *files,
                         filters::whole_output(mode, surface_counts.front()), grid, certify_part);
  } else if (IsCertifying()) {
    WriteCertificate(surface.certificate);
  }

  const bool is_whole = input.ranks.are_several() || !input.in_pieces;
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  if (is_whole) filters::fill(output, surface_counts);
  filters::fill(output, surface.surface, grid, surface.more);
  if (Curves != 0) {
    vtkPolyData* of_curves = vtkPolyData::GetData(outputs, 1);
    if (is_whole) filters::fill(of_curves, curve_counts);
    filters::fill(of_curves, lines.curves, grid, lines.more);
    surface.unresolved.insert(surface.unresolved.end(), lines.unresolved.begin(),
                              lines.unresolved.end());
  }
  filters::fill(vtkUnstructuredGrid::GetData(outputs, 2), surface.unresolved, grid);
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
