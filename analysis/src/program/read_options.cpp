// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/read_options.hpp"

#include <string>
#include <vector>

#include "program/common_options.hpp"

namespace tensortopo {
void add_read_options(CLI::App& app, ReadOptions& options) {
  app.add_option("--tensor", options.tensor,
                 "Name of the mesh's tensor array, or of six scalars: 'S_{xx,yy,zz,xy,yz,xz}'")
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--components",
         [&options](const std::string& name) { options.components = component_order(name); },
         "Order of six components that the file does not name (default: vtk)")
      ->check(CLI::IsMember(std::vector<std::string>(component_order_names().begin(),
                                                     component_order_names().end())));
  app.add_flag("--symmetrize", options.symmetrize, "Take the symmetric part of 3x3 tensors");
  app.add_flag("--cell-to-point", options.cell_to_point,
               "Average tensors on cells to the vertices");
  app.add_flag("--tetrahedralize", options.tetrahedralize,
               "Split other linear 3D cells into tetrahedra");
  app.add_option_function<std::string>(
         "--quadratic",
         [&options](const std::string& what) {
           options.quadratic =
               what == "split" ? QuadraticCells::split : QuadraticCells::corners;
         },
         "Quadratic cells: split around all nodes (default), or taken by their corners")
      ->check(CLI::IsMember({"split", "corners"}));
}

void refuse_read_options(const CLI::App& app, const std::string& why) {
  refuse_given(app,
               {"--tensor", "--components", "--symmetrize", "--cell-to-point", "--tetrahedralize",
                "--quadratic"},
               why);
}

}  // namespace tensortopo
