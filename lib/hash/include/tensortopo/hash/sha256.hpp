// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace tensortopo {

/// SHA-256 of bytes given in pieces.
class Sha256 {
 public:
  Sha256();
  /// Appends bytes to what is hashed.
  void add(std::string_view bytes);
  /// In hexadecimal; ends the sum.
  std::string hex();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

}  // namespace tensortopo
