// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/field_format.hpp"

namespace tensortopo::detail {

/// The mesh of a result file of CalculiX (.frd), text or binary, and the nodal results of one step:
/// each result block of 6 components is an array of its name (`STRESS`, `TOSTRAIN`), with the names
/// of the components that the file gives. Text is rounded once to double, float32 is widened.
///
/// A step is a load case, increment or eigenmode: blocks that follow each other with the same
/// number and value. Nodes that no element has and that have no values are left out. The cell array
/// `material` has the number of each element's material.
/// Throws IoError, also for a step without results of 6 components and for nodes without values.
/// Source  CalculiX CrunchiX GraphiX manual (cgx), "Result Format".
std::vector<RawGrid> read_frd(const FieldSource& source);

/// What each of its steps is.
std::vector<std::string> frd_steps(const std::shared_ptr<const InputFile>& file);

}  // namespace tensortopo::detail
