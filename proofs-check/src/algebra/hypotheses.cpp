// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/hypotheses.hpp"

#include <utility>

namespace proofs {
namespace {

Hypotheses* current = nullptr;

}  // namespace

Hypotheses::Hypotheses(std::string dropped) : dropped_(std::move(dropped)) { current = this; }
Hypotheses::~Hypotheses() { current = nullptr; }

bool Hypotheses::use(const std::string& name) {
  if (current == nullptr) return true;
  current->used_.insert(name);
  return name != current->dropped_;
}

}  // namespace proofs
