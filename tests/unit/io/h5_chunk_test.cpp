// Packed chunks are what the filters of HDF5 unpack, and depend on the numbers alone.
#include "io/results/h5_chunk.h"

#include <gtest/gtest.h>
#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>

namespace scree::test::h5_chunk_test {
namespace {

using io::h5::ChunkPacker;
using Bytes = std::vector<unsigned char>;

Bytes bytes_of(const std::vector<double>& numbers) {
  Bytes out(numbers.size() * sizeof(double));
  std::memcpy(out.data(), numbers.data(), out.size());
  return out;
}

/// Inverse of deflate by zlib, then of the grouping of bytes.
Bytes unpacked(std::span<const unsigned char> packed, std::size_t size, std::size_t number) {
  Bytes grouped(size), out(size);
  uLongf length = size;
  EXPECT_EQ(::uncompress(grouped.data(), &length, packed.data(), packed.size()), Z_OK);
  EXPECT_EQ(length, size);
  const std::size_t count = size / number;
  for (std::size_t b = 0; b < number; ++b)
    for (std::size_t i = 0; i < count; ++i) out[i * number + b] = grouped[b * count + i];
  return out;
}

std::vector<double> smooth(std::size_t count) {
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = 1.0 + 1e-3 * std::sin(0.01 * static_cast<double>(i));
  return out;
}

TEST(ChunkPacker, zlib_unpacks_what_it_packs) {
  ChunkPacker packer;
  for (const std::size_t count : {64UL, 1000UL, 8192UL}) {
    const Bytes bytes = bytes_of(smooth(count));
    const ChunkPacker::Packed packed = packer.pack(bytes, sizeof(double));
    EXPECT_EQ(packed.skipped, 0U);
    EXPECT_LT(packed.bytes.size(), bytes.size());
    EXPECT_EQ(unpacked(packed.bytes, bytes.size(), sizeof(double)), bytes) << count;
  }
}

TEST(ChunkPacker, numbers_without_order_stay_as_they_are) {
  std::mt19937_64 random(7);
  Bytes bytes(4096);
  for (unsigned char& b : bytes) b = static_cast<unsigned char>(random());
  ChunkPacker packer;
  const ChunkPacker::Packed packed = packer.pack(bytes, sizeof(double));
  EXPECT_EQ(packed.skipped, io::h5::kFilters);
  EXPECT_TRUE(std::equal(packed.bytes.begin(), packed.bytes.end(), bytes.begin(), bytes.end()));
}

TEST(ChunkPacker, its_bytes_do_not_depend_on_what_memory_held_before) {
  const Bytes bytes = bytes_of(smooth(8192));
  ChunkPacker clean;
  const auto expected = clean.pack(bytes, sizeof(double)).bytes;
  EXPECT_EQ(expected[0], 0x78);  // deflate with a window of 32 KiB
  // Sizes of a window, in the field that the library's initialisation leaves as it is.
  for (const std::uint16_t value : std::array<std::uint16_t, 3>{1, 5, 9}) {
    // The packer's stream takes the place of this one.
    auto before = std::make_unique<isal_zstream>();
    std::array<std::uint16_t, sizeof(isal_zstream) / 2> numbers{};
    numbers.fill(value);
    std::memcpy(static_cast<void*>(before.get()), numbers.data(), sizeof(numbers));
    const Bytes above(sizeof(isal_zstream));  // or the memory would be returned to the system
    before.reset();
    ChunkPacker packer;
    const auto packed = packer.pack(bytes, sizeof(double)).bytes;
    EXPECT_TRUE(std::equal(packed.begin(), packed.end(), expected.begin(), expected.end())) << value;
  }
}

}  // namespace
}  // namespace scree::test::h5_chunk_test
