// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyDataAlgorithm.h>

#include <functional>
#include <string>
#include <string_view>

#include "TensorTopoFiltersModule.h"

class vtkMultiProcessController;

// VTK's parsers know no nested names here.
namespace tensortopo {
namespace filters {
class Ranks;
struct TensorGrid;
struct WholeMesh;
}  // namespace filters
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
  /// How much the tensors may be in error: "0.5", in their unit, or "1%" of each point's deviator,
  /// in the Frobenius norm. Triangles and lines then have cell arrays `stable`, 1 where surface or
  /// curves have the same topology in the tetrahedron for all fields within it, and `instability`,
  /// 0 there, else the number of the reason. Points have `crossing_stable` and
  /// `crossing_instability`, the same of crossings of the grid's edges, or faces, and -1 elsewhere.
  /// Empty, the default, for none.
  vtkSetStdStringFromCharMacro(Uncertainty);
  vtkGetCharFromStdStringMacro(Uncertainty);
  ///@}
  ///@{
  /// How many tetrahedra the whole mesh has. Another number in the input, of all ranks together, is
  /// an error. 0, the default, where that is not known.
  vtkSetClampMacro(NumberOfCells, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfCells, vtkIdType);
  ///@}
  ///@{
  /// Of the processes that each have a piece of the input; the global controller by default. The
  /// ranks exchange what they must know of each other if it has as many processes as there are
  /// pieces, more than one. Then all have to update the filter, with the same properties.
  virtual void SetController(vtkMultiProcessController*);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}
  ///@{
  /// A certificate is written there, for `tensortopo check`: .json or .cbor. Empty, the default,
  /// for none. On several ranks it is NAME.json, a certificate of parts, each of which is what a rank
  /// owns: `tensortopo check NAME_field.pvtu NAME.pvtp NAME.json`. These files are written too, and
  /// the files of the parts in the folder NAME; all of them or none. It is about one mode, or one
  /// kind of curves. The ranks must have the folder in common.
  vtkSetStdStringFromCharMacro(CertificateFile);
  vtkGetCharFromStdStringMacro(CertificateFile);
  ///@}

 protected:
  vtkTensorTopology();
  ~vtkTensorTopology() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                          vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// What an extraction is about.
  struct Input {
    const tensortopo::filters::TensorGrid& grid;  ///< the piece; without cells where it has none
    const tensortopo::filters::Ranks& ranks;      ///< that have the pieces
    const tensortopo::filters::WholeMesh& whole;  ///< what all of them know
    bool in_pieces;                               ///< also if the others are not known
  };
  /// Fills the outputs, or throws: on all ranks or none.
  virtual void Extract(const Input& input, vtkInformationVector* outputs) = 0;

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
  vtkIdType NumberOfCells = 0;
  vtkMultiProcessController* Controller = nullptr;
  std::string CertificateFile;
};
