// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/known_simple.hpp"

#include <algorithm>

namespace tensortopo {

std::size_t KnownSimple::slot_of(std::uint64_t key) const {
  auto at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32) & (slots_.size() - 1);
  while (slots_[at].round == round_ && slots_[at].key != key) at = (at + 1) & (slots_.size() - 1);
  return at;
}

signed char& KnownSimple::operator[](std::uint64_t key) {
  if (2 * (used_ + 1) > slots_.size()) {
    std::vector<Slot> old(std::max<std::size_t>(64, 2 * slots_.size()));
    old.swap(slots_);
    for (const auto& slot : old)
      if (slot.round == round_) slots_[slot_of(slot.key)] = slot;
  }
  Slot& slot = slots_[slot_of(key)];
  if (slot.round != round_) {
    slot = {key, round_, 0};
    ++used_;
  }
  return slot.simple;
}

void KnownSimple::clear() {
  used_ = 0;
  if (++round_ == 0) {
    slots_.clear();
    round_ = 1;
  }
}

}  // namespace tensortopo
