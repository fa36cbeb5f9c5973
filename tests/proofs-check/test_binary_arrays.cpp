// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Bytes in a file that other readers take for other numbers than the checker would.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "files/files.hpp"
#include "support/folder.hpp"

namespace tensortopo::test {
namespace {

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k > 0 && i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63u];
  }
  return text;
}

template <class Number>
std::string bytes_of(Number x, bool highest_first = false) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &x, sizeof(Number));
  return highest_first ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// A zlib stream of one part that is stored as it is.
std::string stored(const std::string& bytes) {
  const auto size = static_cast<std::uint16_t>(bytes.size());
  unsigned a = 1, b = 0;
  for (const char c : bytes) a = (a + static_cast<unsigned char>(c)) % 65521, b = (b + a) % 65521;
  return std::string("\x78\x01\x01", 3) + bytes_of(size) + bytes_of(static_cast<std::uint16_t>(~size)) +
         bytes + bytes_of(b << 16 | a, true);
}

/// One tetrahedron, of which the points are given as they are stored.
class BinaryArrays : public testing::Test {
 protected:
  static std::string points(bool highest_first) {
    std::string bytes;
    for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.})
      bytes += bytes_of(x, highest_first);
    return bytes;
  }
  /// Whether the checker reads a field with these points.
  bool is_read(const std::string& points, const std::string& attributes) const {
    const std::string name = folder_ / "field.vtu";
    const auto array = [](const char* type, const char* of, const char* count, const char* numbers) {
      return std::string("<DataArray type=\"") + type + "\" Name=\"" + of +
             "\" NumberOfComponents=\"" + count + "\" format=\"ascii\">" + numbers + "</DataArray>";
    };
    std::ofstream(name)
        << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" header_type=\"UInt32\" " << attributes
        << "><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray "
           "type=\"Float64\" Name=\"p\" NumberOfComponents=\"3\" format=\"binary\">"
        << points << "</DataArray></Points><Cells>" << array("Int64", "connectivity", "1", "0 1 2 3")
        << array("Int64", "offsets", "1", "4") << array("UInt8", "types", "1", "10")
        << "</Cells><PointData>"
        << array("Float64", "stress", "6", "1 2 3 4 5 6 6 5 4 3 2 1 1 0 0 0 0 1 0 0 1 1 0 0")
        << "</PointData></Piece></UnstructuredGrid></VTKFile>";
    try {
      const auto input = certificate::read_input(certificate::read_file(name), "stress", "vtk");
      EXPECT_EQ(input.points[1][0], 1.0);
      return true;
    } catch (const certificate::Malformed&) {
      return false;
    }
  }

 private:
  Folder folder_;
};

/// Some readers stop at a sign of the end, or do not look at bits that stand for nothing.
TEST_F(BinaryArrays, HaveOneFormOfBase64) {
  const std::string little = "byte_order=\"LittleEndian\"";
  const std::string text = base64(bytes_of(std::uint32_t{96}) + points(false));
  ASSERT_TRUE(text.ends_with("=="));
  EXPECT_TRUE(is_read(text, little));
  std::size_t refused = 0;
  for (std::size_t i = 8; i + 4 < text.size(); i += 4) {  // after the number of bytes
    std::string other = text;
    if (other.substr(i, 4) != "AAAA") continue;
    other.replace(i + 2, 2, "==");
    refused += !is_read(other, little);
  }
  EXPECT_GT(refused, 10u);
  std::string bits = text;
  ++bits[bits.size() - 3];
  EXPECT_FALSE(is_read(bits, little));
  EXPECT_FALSE(is_read(text.substr(0, text.size() - 2) + "AA", little));
}

/// Others turn the bytes of each number in each part by itself.
TEST_F(BinaryArrays, AreCompressedInPartsOfWholeNumbers) {
  std::size_t read = 0, refused = 0;
  for (const bool highest_first : {false, true})
    for (const std::uint32_t size : {8u, 16u, 24u, 96u, 12u, 4u, 1u}) {
      const std::string bytes = points(highest_first);
      std::vector<std::uint32_t> header{96 / size, size, 0};
      std::string packed, head;
      for (std::size_t at = 0; at < 96; at += size) {
        const std::string part = stored(bytes.substr(at, size));
        header.push_back(static_cast<std::uint32_t>(part.size()));
        packed += part;
      }
      for (const std::uint32_t x : header) head += bytes_of(x, highest_first);
      const bool is_whole = size % 8 == 0;
      EXPECT_EQ(is_read(base64(head) + base64(packed),
                        std::string("compressor=\"vtkZLibDataCompressor\" byte_order=\"") +
                            (highest_first ? "BigEndian\"" : "LittleEndian\"")),
                is_whole)
          << size;
      ++(is_whole ? read : refused);
    }
  EXPECT_EQ(read, 8u);
  EXPECT_EQ(refused, 6u);
}

}  // namespace
}  // namespace tensortopo::test
