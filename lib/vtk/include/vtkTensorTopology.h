// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyDataAlgorithm.h>

#include <functional>
#include <string>
#include <string_view>

#include "TensorTopoFiltersModule.h"

// VTK's parsers know no nested names here.
namespace tensortopo {
namespace filters {
struct TensorGrid;
}
}  // namespace tensortopo

/// What the filters of this library have in common: the input and its tensors, sampling,
/// certificates, progress and abort.
class TENSORTOPOFILTERS_EXPORT vtkTensorTopology : public vtkPolyDataAlgorithm {
 public:
  vtkTypeMacro(vtkTensorTopology, vtkPolyDataAlgorithm)
  void PrintSelf(std::ostream& os, vtkIndent indent) override;  ///< for debugging

  ///@{
  /// The order of six components: 0 as the array names them, else VTK's (default); 1 VTK's (XX YY
  /// ZZ XY YZ XZ), 2 Voigt's (XX YY ZZ YZ XZ XY), 3 Abaqus' and MRtrix' (XX YY ZZ XY XZ YZ), 4
  /// NIfTI's and DIPY's (XX XY YY XZ YZ ZZ), 5 FSL's (XX XY XZ YY YZ ZZ).
  vtkSetClampMacro(ComponentOrder, int, 0, 5);
  vtkGetMacro(ComponentOrder, int);
  ///@}
  ///@{
  /// Samples per radian of turning of an eigenvector. Default 4.
  vtkSetClampMacro(Sampling, double, 0.01, 1000);
  vtkGetMacro(Sampling, double);
  ///@}
  ///@{
  /// How much the tensors may be in error: "0.5", in their unit, or "1%" of each point's deviator, in
  /// the Frobenius norm. Triangles and lines then have cell arrays `stable`, 1 where surface or
  /// curves have the same topology in the tetrahedron for all fields within it, and `instability`,
  /// 0 there, else the number of the reason. Points have `crossing_stable` and
  /// `crossing_instability`, the same of crossings of the grid's edges, or faces, and -1 elsewhere.
  /// Empty, the default, for none.
  vtkSetStdStringFromCharMacro(Uncertainty);
  vtkGetCharFromStdStringMacro(Uncertainty);
  ///@}
  ///@{
  /// A certificate is written there, for `tensortopo check`: .json or .cbor. Empty, the default,
  /// for none. Not with several pieces.
  vtkSetStdStringFromCharMacro(CertificateFile);
  vtkGetCharFromStdStringMacro(CertificateFile);
  ///@}

 protected:
  vtkTensorTopology();
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                          vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// Fills the outputs, or throws.
  virtual void Extract(const tensortopo::filters::TensorGrid& grid, bool in_pieces,
                       vtkInformationVector* outputs) = 0;

  using Report = std::function<void(std::string_view stage, double fraction)>;
  /// Runs work in a thread of its own. This one meanwhile tells the application of progress, and
  /// ends the work if it is asked to.
  void Run(const std::function<void(const Report&)>& work);

  bool IsCertifying() const { return !CertificateFile.empty(); }
  bool IsCertificateCbor() const;
  void WriteCertificate(const std::string& bytes) const;

 private:
  int ComponentOrder = 0;
  double Sampling = 4;
  std::string Uncertainty;
  std::string CertificateFile;
};
