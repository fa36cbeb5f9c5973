// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/parse_document.hpp"

#include <charconv>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "files/utf8.hpp"

namespace certificate {
namespace {

using Json = nlohmann::json;

/// Is it UTF-8: no overlong forms, no surrogates, nothing above U+10FFFF?
bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

/// What both readers have alike: where they are, and what the result takes.
class Reader {
 public:
  explicit Reader(std::string_view bytes)
      : rest_(bytes), budget_((std::size_t{1} << 20) + 64 * bytes.size()) {}

 protected:
  [[noreturn]] static void fail(const char* what) { throw Malformed("", what); }

  char take() {
    if (rest_.empty()) fail("not well-formed: ends too early");
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }
  /// Counts memory that the result takes: about what the library allocates.
  void spend(std::size_t bytes) {
    if (bytes > budget_) fail("more parts than its size is worth");
    budget_ -= bytes;
  }
  void deeper() {
    constexpr int kMaxDepth = 16;
    if (++depth_ > kMaxDepth) fail("nested too deeply");
  }
  /// Puts a member of the innermost array aside.
  void add(Json value) {
    spend(2 * sizeof(Json));
    members_.push_back(std::move(value));
  }
  /// The array of the members put aside since there were so many: made at once in its size.
  Json array_from(std::size_t first) {
    const auto begin = members_.begin() + static_cast<std::ptrdiff_t>(first);
    Json::array_t array(std::make_move_iterator(begin), std::make_move_iterator(members_.end()));
    members_.resize(first);
    return array;
  }
  void add(Json& object, std::string key, Json value) {
    spend(96 + key.size());
    if (!object.emplace(std::move(key), std::move(value)).second) fail("a key given twice");
  }
  std::string checked(std::string text) {
    spend(32 + text.size());
    if (!is_utf8(text)) fail("a text that is no UTF-8");
    for (const char c : text)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) fail("a text with control characters");
    return text;
  }

  static constexpr std::size_t kArray = 48;
  std::string_view rest_;
  int depth_ = 0;
  std::vector<Json> members_;  ///< of arrays that are not complete

 private:
  std::size_t budget_;
};

class JsonReader : public Reader {
 public:
  using Reader::Reader;

  Json document() {
    Json result = value();
    skip_space();
    if (!rest_.empty()) fail("not well-formed: goes on behind its end");
    return result;
  }

 private:
  void skip_space() {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
  }
  /// The next character that is no space, which stays.
  char next() {
    skip_space();
    if (rest_.empty()) fail("not well-formed: ends too early");
    return rest_.front();
  }
  void expect(char c) {
    if (next() != c) fail("not well-formed");
    rest_.remove_prefix(1);
  }

  Json value() {
    switch (next()) {
      case '{': return object();
      case '[': return array();
      case '"': return text();
      case 't': return word("true", true);
      case 'f': return word("false", false);
      case 'n': return word("null", nullptr);
      default: return number();
    }
  }
  Json word(std::string_view name, Json result) {
    if (!rest_.starts_with(name)) fail("not well-formed");
    rest_.remove_prefix(name.size());
    return result;
  }
  Json object() {
    deeper();
    spend(kArray);
    Json result = Json::object();
    expect('{');
    for (bool is_first = true; next() != '}'; is_first = false) {
      if (!is_first) expect(',');
      if (next() != '"') fail("not well-formed");
      std::string key = text();
      expect(':');
      add(result, std::move(key), value());
    }
    rest_.remove_prefix(1), --depth_;
    return result;
  }
  Json array() {
    deeper();
    spend(kArray);
    expect('[');
    const std::size_t first = members_.size();
    for (bool is_first = true; next() != ']'; is_first = false) {
      if (!is_first) expect(',');
      add(value());
    }
    rest_.remove_prefix(1), --depth_;
    return array_from(first);
  }
  Json number() {
    const bool negative = rest_.front() == '-';
    const std::size_t first = negative ? 1 : 0;
    std::size_t end = first;
    while (end < rest_.size() && rest_[end] >= '0' && rest_[end] <= '9') ++end;
    if (end == first) fail("not well-formed");
    if (rest_[first] == '0' && end > first + 1) fail("a number that begins with zero");
    if (end < rest_.size() && std::string_view(".eE").find(rest_[end]) != rest_.npos)
      fail("a number that is no integer");
    const auto read = [&](auto x) -> Json {
      if (std::from_chars(rest_.data(), rest_.data() + end, x).ec != std::errc())
        fail("a number that is too large");
      rest_.remove_prefix(end);
      return x;
    };
    return negative ? read(std::int64_t{}) : read(std::uint64_t{});
  }
  unsigned hex4() {
    unsigned code = 0;
    const std::size_t size = std::min<std::size_t>(4, rest_.size());
    const char* const end = rest_.data() + size;
    if (size < 4 || std::from_chars(rest_.data(), end, code, 16).ptr != end)
      fail("not well-formed");
    rest_.remove_prefix(4);
    return code;
  }
  void append(unsigned code, std::string& out) {
    if (code >= 0xd800 && code < 0xdc00) {
      if (take() != '\\' || take() != 'u') fail("half a character");
      const unsigned low = hex4();
      if (low < 0xdc00 || low >= 0xe000) fail("half a character");
      code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
    }
    const int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr unsigned kFirst[] = {0, 0xc0, 0xe0, 0xf0};
    out += static_cast<char>(kFirst[more] | code >> 6 * more);
    for (int k = more; k-- > 0;) out += static_cast<char>(0x80U | (code >> 6 * k & 0x3fU));
  }
  std::string text() {
    take();
    std::string result;
    for (char c = take(); c != '"'; c = take()) {
      if (static_cast<unsigned char>(c) < ' ') fail("a text with a control character");
      if (c != '\\') {
        result += c;
        continue;
      }
      constexpr std::string_view kNames = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
      const char escaped = take();
      if (const std::size_t i = kNames.find(escaped); i != kNames.npos)
        result += kMeanings[i];
      else if (escaped == 'u')
        append(hex4(), result);
      else
        fail("not well-formed");
    }
    return checked(std::move(result));
  }
};

class CborReader : public Reader {
 public:
  using Reader::Reader;

  Json document() {
    Json result = value();
    if (!rest_.empty()) fail("not well-formed: goes on behind its end");
    return result;
  }

 private:
  /// The number in, or behind, an item's first byte.
  std::uint64_t argument(unsigned info) {
    if (info < 24) return info;
    if (info > 27) fail("an item of indefinite length, or none");
    std::uint64_t result = 0;
    for (unsigned k = 0; k < 1U << (info - 24); ++k)
      result = result << 8 | static_cast<unsigned char>(take());
    return result;
  }
  /// A count of what takes a byte each at least.
  std::size_t count(unsigned info) {
    const std::uint64_t result = argument(info);
    if (result > rest_.size()) fail("not well-formed: ends too early");
    return static_cast<std::size_t>(result);
  }
  std::string text(unsigned info) {
    const std::size_t size = count(info);
    std::string result(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return checked(std::move(result));
  }
  Json value() {
    const auto first = static_cast<unsigned char>(take());
    const unsigned info = first & 31U;
    switch (first >> 5) {
      case 0: return argument(info);
      case 1: {
        const std::uint64_t n = argument(info);
        if (n > INT64_MAX) fail("a number that is too large");
        return -1 - static_cast<std::int64_t>(n);
      }
      case 3: return text(info);
      case 4: {
        deeper();
        spend(kArray);
        const std::size_t begin = members_.size();
        for (std::size_t left = count(info); left > 0; --left) add(value());
        return --depth_, array_from(begin);
      }
      case 5: {
        deeper();
        spend(kArray);
        Json result = Json::object();
        for (std::size_t left = count(info); left > 0; --left) {
          const auto key = static_cast<unsigned char>(take());
          if (key >> 5 != 3) fail("a key that is no text");
          std::string name = text(key & 31U);
          add(result, std::move(name), value());
        }
        --depth_;
        return result;
      }
      case 7:
        if (info == 20 || info == 21) return info == 21;
        if (info == 22) return nullptr;
        [[fallthrough]];
      default: fail("an item of a type that certificates do not have");
    }
  }
};

}  // namespace

Json parse_json(std::string_view bytes) { return JsonReader(bytes).document(); }
Json parse_cbor(std::string_view bytes) { return CborReader(bytes).document(); }

}  // namespace certificate
