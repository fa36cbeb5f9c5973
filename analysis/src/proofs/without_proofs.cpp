// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// In the place of proofs_command.cpp if proofs-check is not built.
#include "proofs/proofs_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

ProofsReport run_proofs(const ProofsCommand&) {
  throw UsageError("proofs: this program was built without them (TENSORTOPO_BUILD_PROOFS=OFF)");
}

}  // namespace tensortopo
