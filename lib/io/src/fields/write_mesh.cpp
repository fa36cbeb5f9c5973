// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/write_mesh.hpp"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "output/atomic_file.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "vtk/xml_output.hpp"

namespace tensortopo {

namespace {

void require_extension(const std::filesystem::path& file, const char* extension) {
  if (lower_extension(file) != extension)
    throw IoError(IoError::Kind::unwritable, file,
                  std::string("the name must end in ") + extension);
}

}  // namespace

void write_mesh(const TetMesh& mesh, const std::filesystem::path& file,
                const std::string& tensor_name, const std::vector<PointArray>& more) {
  require_extension(file, ".vtu");
  if (mesh.tensors.size() != mesh.points.size())
    throw std::invalid_argument("write_mesh: the tensors are not one for each point");
  for (const PointArray& array : more)
    if (array.values.size() != mesh.points.size())
      throw std::invalid_argument("write_mesh: an array is not one for each point");
  for (const auto& tet : mesh.tets)
    for (const auto v : tet)
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.points.size())
        throw std::invalid_argument("write_mesh: a tetrahedron names a point that does not exist");

  std::vector<double> components;
  components.reserve(6 * mesh.tensors.size());
  for (const auto& t : mesh.tensors)
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) components.push_back(x);
  constexpr std::uint8_t tetrahedron = 10;  // VTK's number
  const std::vector<std::uint8_t> types(mesh.tets.size(), tetrahedron);

  detail::OutputFile output(file);
  detail::XmlOutput out("UnstructuredGrid", output);
  out.open("UnstructuredGrid");
  out.open("Piece", {{"NumberOfPoints", std::to_string(mesh.points.size())},
                     {"NumberOfCells", std::to_string(mesh.tets.size())}});
  out.open("PointData", {{"Tensors", tensor_name}});
  out.array(tensor_name, components, detail::Patterns::some, 6,
            {{"ComponentName0", "XX"},
             {"ComponentName1", "YY"},
             {"ComponentName2", "ZZ"},
             {"ComponentName3", "XY"},
             {"ComponentName4", "YZ"},
             {"ComponentName5", "XZ"}});
  for (const PointArray& array : more)
    out.array(array.name, array.values, detail::Patterns::none);
  out.close("PointData");
  out.open("Points");
  out.array("Points", mesh.points, detail::Patterns::some);
  out.close("Points");
  out.open("Cells");
  out.corners(std::span(mesh.tets));
  out.array("types", types);
  out.close("Cells");
  out.close("Piece");
  out.close("UnstructuredGrid");
  out.finish();
}

void write_piece_list(const std::vector<std::filesystem::path>& pieces,
                      const std::filesystem::path& file, const std::string& tensor_name) {
  require_extension(file, ".pvtu");
  detail::OutputFile output(file);
  detail::XmlOutput out("PUnstructuredGrid", output);
  const auto element = [&](std::string_view name, const detail::XmlOutput::Attributes& attributes) {
    out.open(name, attributes);
    out.close(name);
  };
  out.open("PUnstructuredGrid", {{"GhostLevel", "0"}});
  out.open("PPointData", {{"Tensors", tensor_name}});
  element("PDataArray", {{"type", "Float64"}, {"Name", tensor_name}, {"NumberOfComponents", "6"}});
  out.close("PPointData");
  out.open("PPoints");
  element("PDataArray", {{"type", "Float64"}, {"Name", "Points"}, {"NumberOfComponents", "3"}});
  out.close("PPoints");
  for (const auto& piece : pieces) element("Piece", {{"Source", piece.filename().string()}});
  out.close("PUnstructuredGrid");
  out.finish();
}

}  // namespace tensortopo
