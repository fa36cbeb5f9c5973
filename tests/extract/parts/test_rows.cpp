// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <vector>

#include "extract/surface/boundary/rows.hpp"

namespace tensortopo {
namespace {

using List = std::optional<std::vector<int>>;

std::vector<List> some_lists(std::size_t count) {
  const auto value = rc::gen::inRange(0, 1000);
  const auto list =
      rc::gen::oneOf(rc::gen::just(List()), rc::gen::just(List(std::in_place)),
                     rc::gen::map(value, [](int x) { return List(std::vector{x}); }),
                     rc::gen::map(rc::gen::container<std::vector<int>>(value),
                                  [](std::vector<int> x) { return List(std::move(x)); }));
  return *rc::gen::container<std::vector<List>>(count, list);
}

Rows<int> rows_of(const std::vector<List>& lists) {
  const auto at_once = *rc::gen::inRange<std::size_t>(1, 100);
  return make_rows<int>({}, "lists", lists.size(), at_once,
                        [&](std::size_t begin, std::size_t end, RowBlock<int>& block) {
                          for (std::size_t i = begin; i < end; ++i) {
                            if (lists[i] && lists[i]->empty())
                              block.append_empty();
                            else if (lists[i] && lists[i]->size() == 1)
                              block.append_one(int(lists[i]->front()));
                            else
                              block.append(List(lists[i]));
                          }
                        });
}

void require_equal(const Rows<int>& rows, const std::vector<List>& lists) {
  RC_ASSERT(rows.size() == lists.size());
  std::size_t first = 0;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    RC_ASSERT(rows.is_known(i) == lists[i].has_value());
    RC_ASSERT(rows.first(i) == first);
    const std::vector<int> list(rows[i].begin(), rows[i].end());
    RC_ASSERT(list == lists[i].value_or(std::vector<int>()));
    first += list.size();
  }
  RC_ASSERT(rows.count() == first);
}

// Up to three blocks, the last one full or not.
RC_GTEST_PROP(Rows, HoldTheListsThatTheyAreMadeOf, ()) {
  const auto lists = some_lists(*rc::gen::inRange<std::size_t>(0, 3 * kRowsInBlock));
  require_equal(rows_of(lists), lists);
}

RC_GTEST_PROP(Rows, AreMergedListByList, ()) {
  const auto here = some_lists(*rc::gen::inRange<std::size_t>(1, 2 * kRowsInBlock));
  const auto there = some_lists(*rc::gen::inRange<std::size_t>(0, kRowsInBlock));
  // Each list is moved from once at most, so each of `there` is taken once at most.
  std::vector<std::int32_t> from_there(here.size(), -1);
  auto merged = here;
  for (std::size_t k = 0; k < there.size(); ++k) {
    const auto i = *rc::gen::inRange<std::size_t>(0, here.size());
    if (from_there[i] >= 0) continue;
    from_there[i] = static_cast<std::int32_t>(k);
    merged[i] = there[k];
  }
  require_equal(Rows<int>(rows_of(here), rows_of(there), from_there), merged);
}

}  // namespace
}  // namespace tensortopo
