// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// gmp.h first: FLINT declares its functions on GMP numbers only if it is there.
#include <gmpxx.h>

#include <flint/fmpq.h>

namespace proofs {

/// FLINT's rational number, to and from GMP's.
class FlintRational {
 public:
  FlintRational() { fmpq_init(value_); }
  explicit FlintRational(const mpq_class& value) : FlintRational() {
    fmpq_set_mpq(value_, value.get_mpq_t());
  }
  ~FlintRational() { fmpq_clear(value_); }
  FlintRational(const FlintRational&) = delete;
  FlintRational& operator=(const FlintRational&) = delete;

  fmpq* get() { return value_; }
  mpq_class rational() const {
    mpq_class result;
    fmpq_get_mpq(result.get_mpq_t(), value_);
    return result;
  }

 private:
  fmpq_t value_;
};

}  // namespace proofs
