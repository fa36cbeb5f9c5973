// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "strict_json.hpp"

#include <set>
#include <vector>

#include "certificate_check/check_certificate.hpp"

namespace certificate {
namespace {

using nlohmann::json;

/// Reads events, and stops at the first that a certificate cannot have.
class Guard : public nlohmann::json_sax<json> {
 public:
  std::string problem;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override {
    return fail("a number that is no integer of 64 bits");
  }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return fail("binary data"); }
  bool start_object(std::size_t) override { return deeper(); }
  bool end_object() override { return higher(); }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_array() override { return higher(); }
  bool key(string_t& name) override {
    return keys_.back().insert(name).second || fail("a key given twice");
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception&) override {
    return fail("not well-formed at byte " + std::to_string(position));
  }

 private:
  static constexpr std::size_t kMaxDepth = 16;

  bool fail(std::string what) {
    if (problem.empty()) problem = std::move(what);
    return false;
  }
  bool deeper() {
    keys_.emplace_back();
    return keys_.size() <= kMaxDepth || fail("nested too deeply");
  }
  bool higher() {
    keys_.pop_back();
    return true;
  }
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

json parse_strictly(const std::string& bytes, bool cbor) {
  const auto format = cbor ? json::input_format_t::cbor : json::input_format_t::json;
  Guard guard;
  if (!json::sax_parse(bytes, &guard, format) || !guard.problem.empty())
    throw Malformed("", guard.problem.empty() ? "not well-formed" : guard.problem);
  try {
    return cbor ? json::from_cbor(bytes) : json::parse(bytes);
  } catch (const json::exception& error) {
    throw Malformed("", std::string("not well-formed: ") + error.what());
  }
}

}  // namespace certificate
