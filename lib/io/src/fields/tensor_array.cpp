// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/tensor_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "bytes/printable.hpp"
#include "fields/solid_cells.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/tensor/component_names.hpp"

namespace tensortopo::detail {
namespace {

using Sources = std::vector<ArraySource>;

[[noreturn]] void refuse(const RawGrid& grid, const std::string& problem) {
  throw IoError(IoError::Kind::invalid, grid.file, problem);
}

bool may_be_tensor(const ArraySource& source) {
  return source.components == 6 || source.components == 9;
}

std::string listed(const Sources& sources, bool candidates_only) {
  std::string text;
  std::size_t shown = 0, all = 0;
  for (const ArraySource& s : sources) {
    if (candidates_only && !may_be_tensor(s)) continue;
    if (++all > 12) continue;
    ++shown;
    text += (text.empty() ? "" : ", ") + std::string("`") + s.name + "` (" +
            std::to_string(s.components) + ")";
  }
  if (all > shown) text += " and " + std::to_string(all - shown) + " more";
  return text.empty() ? "none" : text;
}

std::string inventory(const RawGrid& grid) {
  return "arrays and their component counts: on points " + listed(grid.point_data, false) +
         "; on cells " + listed(grid.cell_data, false);
}

const ArraySource* find(const RawGrid& grid, const Sources& sources, const std::string& name) {
  const ArraySource* found = nullptr;
  for (const ArraySource& s : sources) {
    if (s.name != name) continue;
    if (found != nullptr) refuse(grid, "has several arrays named `" + name + "`");
    found = &s;
  }
  return found;
}

/// The order of the components: what the file says, else the caller, else VTK's.
TensorComponents order_of(const RawGrid& grid, const ArraySource& source,
                          const ReadOptions& options) {
  try {
    const TensorComponents decided =
        decide_order(source.component_names, static_cast<std::size_t>(source.components),
                     options.components, {source.name, "--components"});
    if (decided.source == ComponentSource::assumed && decided.order != ComponentOrder::full &&
        source.has_no_usual_order)
      refuse(grid, "does not say in which order the components of `" + source.name +
                       "` are; say it with --components (mrtrix, fsl, nifti, dipy, vtk, abaqus or "
                       "voigt: what wrote them)");
    return decided;
  } catch (const ComponentNamesError& error) {
    throw IoError(error.contradicts_caller() ? IoError::Kind::inapplicable : IoError::Kind::invalid,
                  grid.file, error.what());
  }
}

TensorChoice accept(const RawGrid& grid, const ArraySource& source, bool on_cells,
                    const ReadOptions& options) {
  if (on_cells && !options.cell_to_point)
    refuse(grid, "the tensors `" + source.name +
                     "` belong to cells; --cell-to-point averages them to the vertices");
  if (options.components && source.components != 6)
    throw IoError(IoError::Kind::inapplicable, grid.file,
                  "--components: is the order of 6 components, and the tensors `" + source.name +
                      "` have " + std::to_string(source.components));
  return {source.name, source.components, on_cells, order_of(grid, source, options)};
}

/// `before{a,b,c}after` stands for several names; else no names.
std::vector<std::string> names_of_pattern(const std::string& pattern) {
  const std::size_t open = pattern.find('{'), close = pattern.find('}', open);
  std::vector<std::string> names;
  if (open == std::string::npos || close == std::string::npos) return names;
  for (std::size_t at = open + 1; at <= close;) {
    const std::size_t end = std::min(pattern.find(',', at), close);
    names.push_back(pattern.substr(0, open) + pattern.substr(at, end - at) +
                    pattern.substr(close + 1));
    at = end + 1;
  }
  return names;
}

/// Joins the arrays of one component that a pattern names into one, if the file has none of the
/// pattern itself as its name.
void join_named(RawGrid& grid, const std::string& pattern) {
  const std::vector<std::string> names = names_of_pattern(pattern);
  if (names.empty()) return;
  if (names.size() != 6 && names.size() != 9)
    refuse(grid, "--tensor: `" + pattern + "` names " + std::to_string(names.size()) +
                     " arrays; a symmetric tensor has 6 or 9 components");
  for (Sources* sources : {&grid.point_data, &grid.cell_data}) {
    std::vector<std::function<std::vector<double>()>> parts;
    for (const std::string& name : names) {
      const ArraySource* source = find(grid, *sources, name);
      if (source == nullptr) break;
      if (source->components != 1)
        refuse(grid, "the array `" + name + "` has " + std::to_string(source->components) +
                         " components; one of each is joined");
      parts.push_back(source->values);
    }
    if (parts.size() < names.size()) continue;
    ArraySource joined{pattern, names.size(), names, {}};
    joined.values = [parts] {
      std::vector<double> all;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const std::vector<double> part = parts[k]();
        all.resize(part.size() * parts.size());
        for (std::size_t i = 0; i < part.size(); ++i) all[i * parts.size() + k] = part[i];
      }
      return all;
    };
    sources->push_back(std::move(joined));
    return;
  }
}

/// Several tensors for each cell, where the caller says that there are.
TensorChoice accept_several(const RawGrid& grid, const ArraySource& source,
                            const ReadOptions& options) {
  const auto unfit = [&](const std::string& why) {
    refuse(grid, "--cell-values: the array `" + source.name + "` has " +
                     std::to_string(source.components) + " components, " + why);
  };
  std::size_t components = 0, tensors = 0;
  if (options.cell_values == CellValues::nodes) {
    const std::vector<std::size_t> cells = solid_cells(grid);
    if (cells.empty()) refuse(grid, "has no cells of dimension 3");
    tensors =
        static_cast<std::size_t>(grid.offsets[cells.front() + 1] - grid.offsets[cells.front()]);
    for (const std::size_t n : {6u, 9u})
      if (source.components == n * tensors) components = n;
    if (components == 0)
      unfit("and cells have " + std::to_string(tensors) + " nodes; 6 or 9 belong to each node");
  } else {
    const bool six = source.components % 6 == 0;
    const bool nine = source.components % 9 == 0 && !options.components;
    if (six == nine)
      unfit(six ? "which may be tensors of 6 or of 9; --components says that they are of 6"
                : "which are no tensors of 6 or 9");
    components = six ? 6 : 9;
    tensors = source.components / components;
  }
  ArraySource part{source.name, components, {}, {}};
  std::optional<TensorComponents> taken;
  for (std::size_t t = 0; t < (are_named(source.component_names) ? tensors : 1); ++t) {
    if (are_named(source.component_names)) {
      const auto first =
          source.component_names.begin() + static_cast<std::ptrdiff_t>(t * components);
      part.component_names.assign(first, first + static_cast<std::ptrdiff_t>(components));
    }
    const TensorComponents order = order_of(grid, part, options);
    if (taken && taken->order != order.order)
      refuse(grid, "names the components of `" + source.name + "` in several orders");
    taken = order;
  }
  return {source.name, components, true, *taken, options.cell_values, tensors};
}

TensorChoice choose_by_name(const RawGrid& grid, const ReadOptions& options) {
  const ArraySource* on_points = find(grid, grid.point_data, options.tensor);
  const ArraySource* on_cells = find(grid, grid.cell_data, options.tensor);
  if (on_points == nullptr && on_cells == nullptr)
    refuse(grid, "has no array `" + options.tensor + "`; " + inventory(grid));
  if (options.cell_values != CellValues::one) {
    if (on_cells == nullptr)
      refuse(grid, "--cell-values: the array `" + options.tensor + "` belongs to points");
    return accept_several(grid, *on_cells, options);
  }
  const bool takes_cells = on_points == nullptr || (options.cell_to_point && on_cells != nullptr);
  const ArraySource& source = takes_cells ? *on_cells : *on_points;
  if (!may_be_tensor(source))
    refuse(grid, "the array `" + source.name + "` has " + std::to_string(source.components) +
                     " components; a symmetric tensor has 6 or 9");
  return accept(grid, source, takes_cells, options);
}

/// The mean of two entries, without overflow; exact where they are equal.
double mean(double a, double b) { return a == b ? a : a / 2 + b / 2; }

/// Whether a pair of entries differs by more than 1e-9 of the norm; scaled against overflow.
bool is_asymmetric(const double* v) {
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(v[i]));
  if (largest == 0) return false;
  double square = 0;
  for (int i = 0; i < 9; ++i) square += (v[i] / largest) * (v[i] / largest);
  const double tolerance = 1e-9 * std::sqrt(square);
  const auto differ = [&](int i, int j) {
    return std::abs(v[i] / largest - v[j] / largest) > tolerance;
  };
  return differ(1, 3) || differ(2, 6) || differ(5, 7);
}

TensorChoice choose_in(const RawGrid& grid, const ReadOptions& options) {
  if (options.cell_values != CellValues::one && options.tensor.empty())
    throw IoError(IoError::Kind::inapplicable, grid.file,
                  "--cell-values: name the array with --tensor; " + inventory(grid));
  if (!options.tensor.empty()) return choose_by_name(grid, options);
  for (const bool on_cells : {options.cell_to_point, !options.cell_to_point}) {
    const Sources& sources = on_cells ? grid.cell_data : grid.point_data;
    const auto candidates = std::count_if(sources.begin(), sources.end(), may_be_tensor);
    if (candidates > 1)
      refuse(grid, "has several arrays that may be the tensor: " + listed(sources, true) +
                       "; choose one with --tensor");
    if (candidates == 1)
      return accept(grid, *std::find_if(sources.begin(), sources.end(), may_be_tensor), on_cells,
                    options);
  }
  refuse(grid,
         "has no array of 6 or 9 components (six of one are joined by --tensor "
         "'NAME_{xx,yy,zz,xy,yz,xz}'); " +
             inventory(grid));
}

}  // namespace

namespace {

/// That the other of points and cells has tensors as well, which a reader might mean; empty if not.
std::string note_of_others(const RawGrid& grid, const TensorChoice& choice,
                           const ReadOptions& options) {
  Sources others;
  for (const ArraySource& source : choice.on_cells ? grid.point_data : grid.cell_data)
    if (may_be_tensor(source) && (options.tensor.empty() || source.name == options.tensor))
      others.push_back(source);
  if (others.empty() || choice.values != CellValues::one) return "";
  return fmt::format("tensor `{}` of {} taken; {} have {} as well{}", choice.name,
                     choice.on_cells ? "cells" : "points", choice.on_cells ? "points" : "cells",
                     listed(others, true), choice.on_cells ? "" : " (--cell-to-point)");
}

}  // namespace

TensorChoice choose_tensor(std::vector<RawGrid>& grids, const ReadOptions& options) {
  for (RawGrid& each : grids) join_named(each, options.tensor);
  const auto with_points =
      std::find_if(grids.begin(), grids.end(), [](const RawGrid& g) { return g.points() > 0; });
  const RawGrid& grid = with_points != grids.end() ? *with_points : grids.front();
  TensorChoice choice = choose_in(grid, options);
  // Summaries and certificates name it.
  if (printable(choice.name) != choice.name)
    refuse(grid,
           "the name of the array `" + choice.name + "` has control characters; rename the array");
  choice.note = note_of_others(grid, choice, options);
  return choice;
}

namespace {

bool is_not_finite(double x) { return !std::isfinite(x); }

/// How many components are no finite numbers, but for the first.
std::string further_ones(const std::vector<double>& values) {
  const auto count = std::count_if(values.begin(), values.end(), is_not_finite);
  return count > 1 ? fmt::format(", and {} more component{}", count - 1, count == 2 ? "" : "s")
                   : "";
}

}  // namespace

std::vector<SymmetricTensor<double>> read_tensors(const RawGrid& grid, const TensorChoice& choice,
                                                  const ReadOptions& options,
                                                  std::size_t& symmetrized) {
  const ArraySource* source =
      find(grid, choice.on_cells ? grid.cell_data : grid.point_data, choice.name);
  const std::size_t components = choice.components * choice.per_cell;
  if (source == nullptr || source->components != components)
    refuse(grid, "has no array `" + choice.name + "` of " + std::to_string(components) +
                     " components, as other pieces have");
  const TensorComponents taken = choice.values == CellValues::one
                                     ? order_of(grid, *source, options)
                                     : accept_several(grid, *source, options).taken;
  if (taken.order != choice.taken.order)
    refuse(grid, "has the components of `" + choice.name + "` in another order than other pieces");
  const auto places = places_in(choice.taken.order);

  const std::vector<double> values = source->values();
  std::vector<SymmetricTensor<double>> tensors(values.size() / choice.components);
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    const double* v = values.data() + i * choice.components;
    const auto place = [&] {
      return (choice.on_cells ? "cell " : "point ") + std::to_string(i / choice.per_cell) +
             " of `" + choice.name + "`";
    };
    // With `where`, only those count that are taken.
    if (const double* const x = std::find_if(v, v + choice.components, is_not_finite);
        x != v + choice.components) {
      if (options.where.empty())
        refuse(grid, std::string("a tensor component is ") +
                         (std::isnan(*x) ? "not a number" : "infinite") + " (" + place() +
                         further_ones(values) +
                         "); --where 'magnitude < 1e300' takes the cells without");
      tensors[i].xx = *x;
      continue;
    }
    if (choice.components == 6) {
      const auto at = [&](std::size_t k) { return v[places[k]]; };
      tensors[i] = {at(0), at(1), at(2), at(3), at(4), at(5)};
      continue;
    }
    if (!options.symmetrize && is_asymmetric(v))
      refuse(grid,
             "a tensor is not symmetric (" + place() + "); --symmetrize takes its symmetric part");
    symmetrized += v[1] != v[3] || v[2] != v[6] || v[5] != v[7];
    tensors[i] = {v[0], v[4], v[8], mean(v[1], v[3]), mean(v[5], v[7]), mean(v[2], v[6])};
  }
  return tensors;
}

}  // namespace tensortopo::detail
