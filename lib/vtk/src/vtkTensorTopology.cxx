// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtkTensorTopology.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "ranks.hpp"
#include "tensor_grid.hpp"
#include "tensortopo/modes/watched_run.hpp"
#include "whole_mesh.hpp"

using Pipeline = vtkStreamingDemandDrivenPipeline;
using tensortopo::filters::Aborted;
using tensortopo::filters::Ranks;

vtkCxxSetObjectMacro(vtkTensorTopology, Controller, vtkMultiProcessController);

vtkTensorTopology::vtkTensorTopology() {
  SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                         vtkDataSetAttributes::TENSORS);
  SetController(vtkMultiProcessController::GetGlobalController());
}

vtkTensorTopology::~vtkTensorTopology() { SetController(nullptr); }

int vtkTensorTopology::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkTensorTopology::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                           vtkInformationVector*) {
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  if (info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
              std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  return 1;
}

int vtkTensorTopology::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs) {
  auto* grid = vtkUnstructuredGrid::GetData(inputs[0]);
  const bool has_cells = grid != nullptr && grid->GetNumberOfCells() > 0;
  const int pieces = outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  const bool on_ranks =
      pieces > 1 && Controller != nullptr && Controller->GetNumberOfProcesses() == pieces;
  const Ranks ranks(on_ranks ? Controller : nullptr);
  // Of pieces that others have it is not known how many cells there are.
  const vtkIdType expected = pieces > 1 && !on_ranks ? 0 : NumberOfCells;
  if (!has_cells && !on_ranks && expected == 0) return 1;
  try {
    tensortopo::filters::TensorGrid field;
    ranks.together([&] {
      if (pieces > 1 && !on_ranks && IsCertifying())
        throw std::runtime_error(
            "a certificate is of a field in one piece, or of pieces on as many ranks; give the "
            "filter the controller of these");
      if (!has_cells) return;
      vtkDataArray* tensors = GetInputArrayToProcess(0, inputs);
      if (tensors == nullptr) tensors = tensortopo::filters::only_tensors(grid);
      field = tensortopo::filters::tensor_grid(grid, tensors, ComponentOrder);
    });
    const auto whole = tensortopo::filters::require_whole_mesh(field, ranks, expected);
    Extract({field, ranks, whole, pieces > 1}, outputs);
  } catch (const Aborted&) {
    return 1;
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkTensorTopology::Run(const std::function<void(const Report&)>& work) {
  tensortopo::watched_run(work, [this](bool fresh, const std::string& stage, double fraction) {
    if (fresh) {
      SetProgressText(stage.c_str());
      UpdateProgress(fraction);
    }
    if (GetAbortExecute()) throw Aborted{};
  });
}

bool vtkTensorTopology::IsCertificateCbor() const {
  return std::filesystem::path(CertificateFile).extension() == ".cbor";
}

void vtkTensorTopology::WriteCertificate(const std::string& bytes) const {
  const std::string part = CertificateFile + ".part";
  {
    std::ofstream stream(part, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (stream) {
      std::error_code error;
      std::filesystem::rename(part, CertificateFile, error);
      if (!error) return;
    }
  }
  std::remove(part.c_str());
  throw std::runtime_error(CertificateFile + ": cannot be written");
}

void vtkTensorTopology::PrintSelf(std::ostream& os, vtkIndent indent) {
  Superclass::PrintSelf(os, indent);
  os << indent << "ComponentOrder: " << ComponentOrder << '\n'
     << indent << "Sampling: " << Sampling << '\n'
     << indent << "Uncertainty: " << Uncertainty << '\n'
     << indent << "NumberOfCells: " << NumberOfCells << '\n'
     << indent << "Controller: " << Controller << '\n'
     << indent << "CertificateFile: " << CertificateFile << '\n';
}
