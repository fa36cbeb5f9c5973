// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/options/read_options.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "program/options/common_options.hpp"
#include "tensortopo/io/field_formats.hpp"

namespace tensortopo {
std::string field_help() { return "Field of tensors: " + field_extensions(); }

void add_read_options(CLI::App& app, CommonOptions& common, ReadOptions& options) {
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
  app.add_option("--zero-below", options.zero_below,
                 "Take components smaller than E as zero, and tensors with smaller deviators as "
                 "isotropic: rounding next to isotropic points")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double number = 0;
            return CLI::detail::lexical_cast(text, number) && number > 0 && std::isfinite(number)
                       ? std::string()
                       : "'" + text + "' is not a positive number";
          },
          "POSITIVE"))
      ->type_name("E");
  app.add_flag("--cell-to-point", options.cell_to_point,
               "Take tensors on cells, averaged to the vertices");
  app.add_flag("--tetrahedralize", options.tetrahedralize,
               "Split other linear 3D cells into tetrahedra");
  const auto choice = [&app](const char* name, std::vector<std::string> words,
                             std::function<void(std::size_t)> take, const char* help) {
    app.add_option_function<std::string>(
           name,
           [words, take](const std::string& word) {
             take(static_cast<std::size_t>(std::find(words.begin(), words.end(), word) -
                                           words.begin()));
           },
           help)
        ->check(CLI::IsMember(words));
  };
  choice(
      "--cell-values", {"one", "nodes", "points"},
      [&](std::size_t i) { options.cell_values = static_cast<CellValues>(i); },
      "Tensors of an array on cells: one for each cell (default), node or integration point");
  choice(
      "--mean", {"plain", "volume"},
      [&](std::size_t i) { options.mean = static_cast<MeanWeights>(i); },
      "Means over cells, and of points that are merged: plain, or weighted by volume");
  app.add_option("--materials", options.materials,
                 "Array on cells between whose values no means are taken; 'none': over all cells")
      ->type_name("NAME");
  app.add_flag("--merge-points", options.merge_points,
               "Make one of points with the same place and tensor; with --mean, of all in a place");
  app.add_option_function<std::string>(
         "--quadratic",
         [&options](const std::string& what) {
           options.quadratic = what == "split" ? QuadraticCells::split : QuadraticCells::corners;
         },
         "Quadratic cells: split around all nodes (default), or taken by their corners")
      ->check(CLI::IsMember({"split", "corners"}));
  app.add_option("--step", options.step,
                 "Which step of a file that holds several, counted from 1 (default: the last)")
      ->check(whole_number())
      ->type_name("N");
  app.add_option(
         "--where", options.where,
         "Take the cells alone at all whose nodes this holds: an array that is not 0 there, or "
         "an expression as 'anisotropy > 0.2 and z < 5', of arrays of the file, x, y, z, "
         "magnitude, deviator_magnitude, anisotropy and mode")
      ->type_name("EXPRESSION");
  reads(common, app.add_option("--mask", options.mask,
                               "NIfTI image that is not 0 where the input's voxels are taken"))
      ->type_name("FILE");
}

namespace {

const std::initializer_list<const char*> kNames{
    "--tensor",         "--components", "--symmetrize",   "--zero-below", "--cell-to-point",
    "--tetrahedralize", "--quadratic",  "--step",         "--mask",       "--cell-values",
    "--mean",           "--materials",  "--merge-points", "--where"};

}  // namespace

void refuse_read_options(const CLI::App& app, const std::string& why) {
  refuse_given(app, kNames, why);
}

std::vector<std::string> given_read_options(const CLI::App& app) {
  std::vector<std::string> words;
  for (const char* const name : kNames) {
    const CLI::Option& option = *app.get_option(name);
    if (option.count() == 0) continue;
    words.emplace_back(name);
    if (option.get_expected_max() > 0)
      words.insert(words.end(), option.results().begin(), option.results().end());
  }
  return words;
}

}  // namespace tensortopo
