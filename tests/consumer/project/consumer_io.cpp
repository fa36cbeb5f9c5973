// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_mesh.hpp"

/// Reading what is not there is refused by name.
int main() {
  try {
    tensortopo::read_mesh("no_such_file.vtu");
  } catch (const tensortopo::IoError& error) {
    std::puts(error.what());
    return 0;
  }
  return 1;
}
