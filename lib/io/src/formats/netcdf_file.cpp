// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/netcdf_file.hpp"

#include <bit>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"

namespace tensortopo::detail {
namespace {

constexpr int text_type = 2;

std::optional<ElementType> element_of(int type) {
  constexpr ElementType elements[]{ElementType::i8,  ElementType::u8,  ElementType::i16,
                                   ElementType::i32, ElementType::f32, ElementType::f64,
                                   ElementType::u8,  ElementType::u16, ElementType::u32,
                                   ElementType::i64, ElementType::u64};
  if (type < 1 || type > 11) return std::nullopt;
  return elements[type - 1];
}

constexpr std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

}  // namespace

/// Reads the header.
class NetcdfHeader {
 public:
  NetcdfHeader(NetcdfFile& file, std::string_view bytes) : file_(file), rest_(bytes) {}

  void read() {
    const std::string_view magic = take(4);
    version_ = static_cast<unsigned char>(magic[3]);
    if (!magic.starts_with("CDF") || (version_ != 1 && version_ != 2 && version_ != 5))
      throw FormatError("is no NetCDF file of a classic format");
    const std::uint64_t records = count();
    if (records == (version_ == 5 ? UINT64_MAX : UINT32_MAX))
      throw FormatError("does not say how many records it has");
    file_.records_ = records;
    for (std::uint64_t i = list(10, 8); i > 0; --i) {
      const std::string name = text();
      const std::uint64_t length = count();
      if (!file_.dimensions_.emplace(name, length == 0 ? records : length).second)
        throw FormatError("has the dimension " + name + " twice");
      lengths_.push_back(length);
    }
    file_.texts_ = attributes();
    for (std::uint64_t i = list(11, 24); i > 0; --i) variable();
    // One variable alone is not padded.
    std::size_t with_records = 0;
    for (auto& [name, v] : file_.variables_) {
      if (!v.has_records) continue;
      ++with_records;
      file_.record_bytes_ += padded(v.bytes);
    }
    if (with_records == 1)
      for (auto& [name, v] : file_.variables_)
        if (v.has_records) file_.record_bytes_ = v.bytes;
  }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) throw FormatError("ends within its header");
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return found;
  }
  std::uint64_t word(std::size_t size) {
    std::uint64_t value = 0;
    for (const char c : take(size)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
  }
  std::uint64_t count() { return word(version_ == 5 ? 8 : 4); }

  std::string text() {
    const std::uint64_t size = count();
    if (size > rest_.size()) throw FormatError("ends within its header");
    const std::string found(take(size));
    take(padded(size) - size);
    return found;
  }

  /// How many elements a list has, of `least` bytes each.
  std::uint64_t list(std::uint64_t tag, std::uint64_t least) {
    const std::uint64_t is = word(4), elements = count();
    if (is != tag && (is != 0 || elements != 0))
      throw FormatError("has a list of another kind in its header");
    if (elements > rest_.size() / least) throw FormatError("ends within a list of its header");
    return elements;
  }

  std::map<std::string, std::string> attributes() {
    std::map<std::string, std::string> texts;
    for (std::uint64_t i = list(12, 12); i > 0; --i) {
      const std::string name = text();
      const auto type = static_cast<int>(word(4));
      const auto element = element_of(type);
      const std::uint64_t values = count();
      if (!element || values > rest_.size()) throw FormatError("has a senseless attribute");
      const std::uint64_t size = values * size_of(*element);
      const std::string_view bytes = take(size);
      take(padded(size) - size);
      if (type == text_type) texts.emplace(name, std::string(bytes));
    }
    return texts;
  }

  void variable() {
    NetcdfFile::Variable v;
    v.name = text();
    const std::uint64_t dimensions = count();
    if (dimensions > 16) throw FormatError("has a variable of too many dimensions");
    std::uint64_t values = 1;
    for (std::uint64_t d = 0; d < dimensions; ++d) {
      const std::uint64_t id = count();
      if (id >= lengths_.size())
        throw FormatError("has a variable of a dimension that is not there");
      if (lengths_[id] == 0) {
        if (d != 0) throw FormatError("has records that are not the first dimension");
        v.has_records = true;
        continue;
      }
      if (lengths_[id] > INT64_MAX / 16 / values) throw FormatError("has too large a variable");
      values *= lengths_[id];
      v.sizes.push_back(lengths_[id]);
    }
    v.texts = attributes();
    v.type = static_cast<int>(word(4));
    const auto element = element_of(v.type);
    if (!element) throw FormatError(fmt::format("has a variable of the unknown type {}", v.type));
    v.bytes = values * size_of(*element);
    count();  // the padded size, which is known
    v.begin = word(version_ == 1 ? 4 : 8);
    const std::string name = v.name;
    if (!file_.variables_.emplace(name, std::move(v)).second)
      throw FormatError("has the variable " + name.substr(0, 40) + " twice");
  }

  NetcdfFile& file_;
  std::string_view rest_;
  unsigned version_ = 0;
  std::vector<std::uint64_t> lengths_;
};

NetcdfFile::NetcdfFile(std::string_view bytes) : bytes_(bytes) {
  if (bytes.starts_with("\x89HDF"))
    throw FormatError(
        "is a NetCDF-4 file (HDF5); nccopy -k cdf5 IN OUT (netcdf-bin) makes a classic "
        "one, which is read");
  NetcdfHeader(*this, bytes).read();
}

std::string NetcdfFile::text(const std::string& name) const {
  const auto found = texts_.find(name);
  return found != texts_.end() ? found->second : std::string();
}

std::size_t NetcdfFile::dimension(const std::string& name) const {
  const auto found = dimensions_.find(name);
  return found == dimensions_.end() ? 0 : found->second;
}

const NetcdfFile::Variable* NetcdfFile::find(const std::string& name) const {
  const auto found = variables_.find(name);
  return found == variables_.end() ? nullptr : &found->second;
}

const NetcdfFile::Variable& NetcdfFile::variable(const std::string& name,
                                                 const std::vector<std::size_t>& sizes) const {
  const Variable* const found = find(name);
  if (found == nullptr) throw FormatError("has no variable " + name);
  if (found->sizes != sizes) throw FormatError("has the variable " + name + " in another size");
  return *found;
}

std::string_view NetcdfFile::bytes_of(const Variable& variable, std::size_t record) const {
  const auto ends = [&] {
    return FormatError("ends within the values of " + variable.name.substr(0, 40));
  };
  if (variable.begin > bytes_.size()) throw ends();
  std::uint64_t room = bytes_.size() - variable.begin;
  std::uint64_t begin = variable.begin;
  if (variable.has_records) {
    if (record >= records_) throw FormatError("has no record " + std::to_string(record));
    if (record != 0 && record_bytes_ > room / record) throw ends();
    begin += record * record_bytes_;
    room -= record * record_bytes_;
  }
  if (variable.bytes > room) throw ends();
  return bytes_.substr(begin, variable.bytes);
}

template <class Value>
std::vector<Value> NetcdfFile::values(const Variable& variable, std::size_t record) const {
  return from_bytes<Value>(bytes_of(variable, record), *element_of(variable.type),
                           std::endian::big);
}
template std::vector<double> NetcdfFile::values(const Variable&, std::size_t) const;
template std::vector<std::int64_t> NetcdfFile::values(const Variable&, std::size_t) const;

std::vector<std::string> NetcdfFile::rows(const Variable& variable) const {
  if (variable.type != text_type || variable.sizes.size() != 2)
    throw FormatError("has names that are no text: " + variable.name.substr(0, 40));
  std::string_view text = bytes_of(variable, 0);
  std::vector<std::string> rows;
  const std::size_t length = variable.sizes[1];
  for (; !text.empty(); text.remove_prefix(length)) {
    std::string_view row = text.substr(0, length);
    row = row.substr(0, row.find('\0'));
    while (!row.empty() && row.back() == ' ') row.remove_suffix(1);
    rows.emplace_back(row);
  }
  return rows;
}

}  // namespace tensortopo::detail
