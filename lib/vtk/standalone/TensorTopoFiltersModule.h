// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// In a static library nothing is exported. (Built as a module of VTK or ParaView, a header of this
/// name is made.)
#define TENSORTOPOFILTERS_EXPORT
