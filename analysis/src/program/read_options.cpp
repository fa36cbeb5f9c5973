// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/read_options.hpp"

#include <map>

#include "program/common_options.hpp"

namespace tensortopo {
namespace {

const std::map<std::string, ComponentOrder>& orders() {
  static const std::map<std::string, ComponentOrder> known{{"vtk", ComponentOrder::vtk},
                                                           {"voigt", ComponentOrder::voigt},
                                                           {"abaqus", ComponentOrder::abaqus}};
  return known;
}

}  // namespace

void add_read_options(CLI::App& app, ReadOptions& options) {
  app.add_option("--tensor", options.tensor, "Name of the mesh's tensor array")->type_name("NAME");
  app.add_option_function<std::string>(
         "--components",
         [&options](const std::string& name) { options.components = orders().at(name); },
         "Order of six components (default: vtk)")
      ->check(CLI::IsMember({"vtk", "voigt", "abaqus"}));
  app.add_flag("--symmetrize", options.symmetrize, "Take the symmetric part of 3x3 tensors");
  app.add_flag("--cell-to-point", options.cell_to_point,
               "Average tensors on cells to the vertices");
  app.add_flag("--tetrahedralize", options.tetrahedralize,
               "Split other linear 3D cells into tetrahedra");
}

void refuse_read_options(const CLI::App& app, const std::string& why) {
  refuse_given(app,
               {"--tensor", "--components", "--symmetrize", "--cell-to-point", "--tetrahedralize"},
               why);
}

}  // namespace tensortopo
