// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace tensortopo {

/// A file that cannot be read, means nothing, or cannot be written.
///
/// Laws      what() is one printable line, "FILE: what is wrong (where)".
class IoError : public std::runtime_error {
 public:
  /// What went wrong.
  enum class Kind {
    unreadable,    ///< the operating system gives no bytes
    invalid,       ///< the bytes are not what they should be
    unwritable,    ///< the bytes could not be stored, or the format cannot hold them
    inapplicable,  ///< an option that the caller gave has no effect on this file
  };

  /// Of a file; `problem` is one line without a full stop.
  IoError(Kind kind, std::filesystem::path file, const std::string& problem);

  /// The same of a file that another one names, which the message then says.
  IoError named_by(const std::filesystem::path& index) const;

  /// What went wrong.
  Kind kind() const noexcept { return kind_; }
  /// The file that it is about.
  const std::filesystem::path& file() const noexcept { return file_; }

 private:
  Kind kind_;
  std::filesystem::path file_;
};

}  // namespace tensortopo
