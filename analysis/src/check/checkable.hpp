// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <future>
#include <string>

#include "extract/certificate.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// Why the independent checker does not read a field's file as a certificate's subject says, in
/// words; empty if it does, or if this program was built without it. It reads the file anew, by its
/// own reader.
std::string why_not_checkable(const std::filesystem::path& input,
                              const CertificateSubject& subject);

/// Throws IoError (inapplicable), with a remedy, for a file that the checker does not read as a
/// certificate's subject says.
void require_checkable(const std::filesystem::path& input, const CertificateSubject& subject);

/// The same beside other work.
class CheckableInput {
 public:
  /// Begins to read the file, in a thread if there can be one.
  CheckableInput(const std::filesystem::path& input, const ReadResult& read)
      : subject_(subject_of(read)) {
    const auto require = [input, subject = subject_] { require_checkable(input, subject); };
    // Copied from where it is, not moved: it is needed again if no thread can be started.
    done_ = std::async(std::launch::async | std::launch::deferred, require);
  }

  const CertificateSubject& subject() const { return subject_; }

  /// Throws what is to be thrown, if that is known by now.
  void look() {
    if (done_.valid() && done_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
      done_.get();
  }
  /// The same, once it is known.
  void require() {
    if (done_.valid()) done_.get();
  }

 private:
  CertificateSubject subject_;
  std::future<void> done_;
};

}  // namespace tensortopo
