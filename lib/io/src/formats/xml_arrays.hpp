// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "grids/raw_grid.hpp"
#include "vtk/xml_document.hpp"

namespace tensortopo::detail {

/// The arrays of a <PointData> or <CellData> of `tuples` points or cells, not decoded yet.
/// Throws FormatError.
std::vector<ArraySource> list_arrays(const std::shared_ptr<const XmlDocument>& document,
                                     pugi::xml_node parent, std::size_t tuples);

}  // namespace tensortopo::detail
