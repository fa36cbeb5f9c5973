// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo {

/// Takes the place of standard streams with which the program was not started, so that no file gets
/// the number of one: what is meant for the stream would be written into that file. Writing to such
/// an output fails, and reading from such an input.
void take_places_of_closed_streams();

}  // namespace tensortopo
