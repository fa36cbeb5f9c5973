// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "ranks.hpp"

#include <vtkMultiProcessController.h>
#include <vtkType.h>

#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo::filters {

namespace {

[[noreturn]] void refuse_exchange() {
  throw std::runtime_error("the ranks cannot exchange their data: MPI has failed");
}

/// What has become of a rank's work.
enum Outcome : std::int64_t { done, failed, aborted };

}  // namespace

int Ranks::count() const {
  return controller_ != nullptr ? controller_->GetNumberOfProcesses() : 1;
}
int Ranks::own() const { return controller_ != nullptr ? controller_->GetLocalProcessId() : 0; }

std::vector<std::vector<std::int64_t>> Ranks::gather(
    const std::vector<std::int64_t>& numbers) const {
  static_assert(sizeof(long long) == sizeof(std::int64_t));
  if (!are_several()) return {numbers};
  const auto ranks = as_size(count());
  const auto own_size = static_cast<vtkIdType>(numbers.size());
  std::vector<vtkIdType> sizes(ranks), offsets(ranks, 0);
  if (controller_->AllGather(&own_size, sizes.data(), 1) == 0) refuse_exchange();
  std::partial_sum(sizes.begin(), sizes.end() - 1, offsets.begin() + 1);
  const vtkIdType all = offsets.back() + sizes.back();
  if (all > std::numeric_limits<int>::max())
    throw std::runtime_error("the ranks have " + std::to_string(all) +
                             " numbers for each other, more than one message of MPI holds; "
                             "use fewer ranks");
  const std::vector<long long> sent(numbers.begin(), numbers.end());
  std::vector<long long> received(static_cast<std::size_t>(all));
  if (controller_->AllGatherV(sent.data(), received.data(), own_size, sizes.data(),
                              offsets.data()) == 0)
    refuse_exchange();
  std::vector<std::vector<std::int64_t>> result;
  for (std::size_t r = 0; r < ranks; ++r) {
    const auto first = received.begin() + offsets[r];
    result.emplace_back(first, first + sizes[r]);
  }
  return result;
}

std::vector<std::string> Ranks::gather(const std::string& text) const {
  std::vector<std::string> result;
  for (const auto& letters : gather(std::vector<std::int64_t>(text.begin(), text.end()))) {
    std::string& of_rank = result.emplace_back();
    for (const std::int64_t letter : letters) of_rank += static_cast<char>(letter);
  }
  return result;
}

void Ranks::together(const std::function<void()>& work) const {
  if (!are_several()) return work();
  std::vector<std::int64_t> outcome{done};
  try {
    work();
  } catch (const std::exception& error) {
    outcome = {failed};
    for (const char letter : std::string(error.what())) outcome.push_back(letter);
  } catch (const Aborted&) {
    outcome = {aborted};
  }
  const auto outcomes = gather(outcome);
  for (std::size_t r = 0; r < outcomes.size(); ++r) {
    if (outcomes[r].front() != failed) continue;
    std::string text = "rank " + std::to_string(r) + ": ";
    for (auto letter = outcomes[r].begin() + 1; letter != outcomes[r].end(); ++letter)
      text += static_cast<char>(*letter);
    throw std::runtime_error(text);
  }
  for (const auto& other : outcomes)
    if (other.front() == aborted) throw Aborted{};
}

}  // namespace tensortopo::filters
