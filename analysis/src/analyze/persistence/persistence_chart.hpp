// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo {

/// Persistence diagrams and barcodes, in the mode and in the signed Lode angle, as the bytes of a
/// PNG. Throws std::runtime_error if there is no display (see `DisplayServer`).
std::string persistence_chart(const ModePersistence& persistence);

}  // namespace tensortopo
