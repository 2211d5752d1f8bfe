// run.xmf: its text, the windows it refers to, the series behind them, and point values averaged over cells.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <span>
#include <vector>

#include "io/results/cell_mean.h"
#include "io/results/h5_read.h"
#include "io/results/h5_series.h"
#include "io/results/h5_window.h"
#include "io/results/xdmf_text.h"

namespace scree::io::xdmf_test {
namespace {

namespace fs = std::filesystem;

// --- words --------------------------------------------------------------------------------------------------------

TEST(XdmfText, mixed_polygons_tell_kind_and_number_of_points_before_the_points) {
  const std::vector<std::int32_t> offsets{0, 3, 7}, connectivity{4, 5, 6, 0, 1, 2, 3};
  EXPECT_EQ(xdmf::mixed_polygons(offsets, connectivity), (std::vector<std::int32_t>{3, 3, 4, 5, 6, 3, 4, 0, 1, 2, 3}));
  EXPECT_TRUE(xdmf::mixed_polygons({}, {}).empty());
}

TEST(XdmfText, item_of_one_number_a_row_has_one_dimension) {
  EXPECT_EQ(xdmf::item({"run.vtkhdf:/xdmf/a/0", 7, 1, true, {}}),
            "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"7\">run.vtkhdf:/xdmf/a/0"
            "</DataItem>\n");
  EXPECT_EQ(xdmf::item({"run.vtkhdf:/xdmf/b/1", 7, 3, false, {}}),
            "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"7 3\">run.vtkhdf:/xdmf/b/1"
            "</DataItem>\n");
}

TEST(XdmfText, item_with_numbers_holds_them_to_the_last_bit) {
  const std::vector<double> numbers{0.1 + 0.2, -0.0, 5e-324, -1.7976931348623157e308, 12.0, 1.0 / 3.0};
  const std::string text = xdmf::item({"", 2, 3, false, numbers});
  EXPECT_TRUE(text.starts_with("<DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"2 3\">"))
      << text;
  const char* at = text.c_str() + text.find('>') + 1;
  for (const double number : numbers) {
    char* end = nullptr;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(at, &end)), std::bit_cast<std::uint64_t>(number)) << text;
    at = end;
  }
  EXPECT_STREQ(at, "</DataItem>\n");
}

TEST(XdmfText, time_of_a_grid_reads_back_to_the_same_bits) {
  const double time = 0.1 + 0.2;
  const std::string text = xdmf::grid(3, "", time);
  const std::string key = "<Time Value=\"";
  EXPECT_EQ(std::strtod(text.c_str() + text.find(key) + key.size(), nullptr), time);
  EXPECT_NE(text.find("frame 3"), std::string::npos);
}

TEST(XdmfText, closing_closes_what_the_opening_opens_around_the_grids) {
  const std::string text = std::string(xdmf::opening()) + "<Grid/>\n" + std::string(xdmf::closing());
  for (const char* tag : {"Xdmf", "Domain", "Grid"}) EXPECT_NE(text.find(std::string("</") + tag + ">"), text.npos);
  EXPECT_LT(text.find("CollectionType=\"Temporal\""), text.find("<Grid/>"));
  EXPECT_TRUE(text.ends_with("</Xdmf>\n"));
}

TEST(XdmfText, times_told_apart_rise_and_keep_the_last_of_equal_ones) {
  for (const double t : {0.0, 1.0, 6.0, 3600.0, 1e7}) {  // 1e7: doubles are 2e-9 apart there
    const std::vector<double> apart = xdmf::told_apart({t - 0.5, t, t, t});
    EXPECT_EQ(apart[0], t - 0.5);
    EXPECT_EQ(apart[3], t);
    EXPECT_LT(apart[0], apart[1]);
    EXPECT_LT(apart[1], apart[2]);
    EXPECT_LT(apart[2], apart[3]);
    EXPECT_LT(apart[3] - apart[1], std::max(3e-12, 1e-14 * t)) << "further than two ticks or roundings";
  }
  EXPECT_EQ(xdmf::told_apart({0.0, 0.5, 1.0}), (std::vector<double>{0.0, 0.5, 1.0}));
  EXPECT_TRUE(xdmf::told_apart({}).empty());
}

// --- windows ------------------------------------------------------------------------------------------------------

/// A separate file for each test, removed at its end.
class Window : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "scree-window-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    file_ = h5::File::create(folder_ / "a.h5");
  }
  void TearDown() override {
    file_.close();
    std::error_code ignored;  // a folder that remains is not a failure of the test
    fs::remove_all(folder_, ignored);
  }
  fs::path folder_;
  h5::File file_;
};

TEST_F(Window, shows_its_rows_with_type_and_label) {
  std::vector<double> rows(30);
  std::iota(rows.begin(), rows.end(), 0.0);
  h5::write<double>(file_, "/table", 3, rows, {"m", "table"});
  h5::window(file_, "/view/deep/0", {"/table", 4, 2, 3}, {"m", "two rows"});
  EXPECT_EQ(h5::read<double>(file_, "/view/deep/0"), (std::vector<double>{12, 13, 14, 15, 16, 17}));
  EXPECT_EQ(h5::extent(file_, "/view/deep/0").width, 3);
  EXPECT_EQ(h5::text_attribute(file_, "/view/deep/0", "units"), "m");
  EXPECT_EQ(h5::text_attribute(file_, "/view/deep/0", "long_name"), "two rows");
}

TEST_F(Window, shows_rows_that_are_written_after_it_was_made) {
  h5::Series<std::int32_t> series(file_, "/numbers", 1, {"1", "numbers"});
  series.append(7);
  series.flush();
  series.append(8);  // in the buffer only
  h5::window(file_, "/view", {"/numbers", 1, 2, 1, true}, {"1", "later numbers"});
  series.append(9);
  series.close();
  file_.flush();
  EXPECT_EQ(h5::read<std::int32_t>(file_, "/view"), (std::vector<std::int32_t>{8, 9}));
}

TEST_F(Window, of_a_file_that_moved_still_finds_its_rows) {
  h5::write<double>(file_, "/table", 1, std::vector<double>{1.0, 2.0, 3.0}, {"m", "table"});
  h5::window(file_, "/view", {"/table", 2, 1}, {"m", "view"});
  file_.close();
  fs::rename(folder_ / "a.h5", folder_ / "b.h5");
  file_ = h5::File::open(folder_ / "b.h5");
  EXPECT_EQ(h5::read<double>(file_, "/view"), (std::vector<double>{3.0}));
}

TEST_F(Window, made_before_its_dataset_shows_zeros_and_then_its_rows) {
  h5::window(file_, "/view", {"/later", 1, 2}, {"m", "view"});
  EXPECT_EQ(h5::read<double>(file_, "/view"), (std::vector<double>{0.0, 0.0}));
  h5::write<double>(file_, "/later", 1, std::vector<double>{1.0, 2.0, 3.0}, {"m", "later"});
  EXPECT_EQ(h5::read<double>(file_, "/view"), (std::vector<double>{2.0, 3.0}));
}

TEST_F(Window, of_a_name_that_is_taken_gives_file_error) {
  h5::write<double>(file_, "/table", 1, std::vector<double>{1.0}, {"m", "table"});
  EXPECT_THROW(h5::window(file_, "/table", {"/other", 0, 1}, {"m", "view"}), FileError);
}

// --- series -------------------------------------------------------------------------------------------------------

struct Chunk {
  haddr_t address = 0;
  hsize_t bytes = 0;
  unsigned skipped = 0;  // filters, one bit each
};
Chunk chunk_of(const h5::File& file, const char* name, hsize_t number) {
  Chunk c;
  hsize_t at = 0;
  const h5::Handle dataset(H5Dopen2(file.id(), name, H5P_DEFAULT), H5Dclose);
  const h5::Handle space(H5Dget_space(dataset.get()), H5Sclose);
  EXPECT_GE(H5Dget_chunk_info(dataset.get(), space.get(), number, &at, &c.skipped, &c.address, &c.bytes), 0);
  return c;
}

TEST(Chunks, hold_a_quarter_of_what_is_expected_within_bounds) {
  EXPECT_EQ(h5::rows_of_chunk(0.0, 8), 32u);       // 256 bytes
  EXPECT_EQ(h5::rows_of_chunk(101.0, 8), 32u);     // 808 bytes in all
  EXPECT_EQ(h5::rows_of_chunk(1000.0, 8), 256u);   // 2 KiB of 8
  EXPECT_EQ(h5::rows_of_chunk(1e12, 8), 8192u);    // 64 KiB
  EXPECT_EQ(h5::rows_of_chunk(1e12, 24), 4096u);   // 96 KiB: the first power of two rows that reaches 64
  EXPECT_EQ(h5::rows_of_chunk(1.0, 1 << 20), 1u);  // at least one row
}

TEST_F(Window, file_that_holds_its_tables_reads_as_of_its_flush) {
  std::vector<h5::Series<double>> series;
  for (int i = 0; i < 60; ++i)
    series.emplace_back(file_, "/numbers/" + std::to_string(i), 1, h5::Label{"1", "numbers"});
  const auto add = [&](double value) {
    for (h5::Series<double>& s : series) s.append(std::vector<double>(40, value));  // more than a chunk
  };
  add(1.0);
  for (h5::Series<double>& s : series) s.flush();
  file_.flush();
  file_.hold(true);
  for (const double value : {2.0, 3.0, 4.0}) add(value);
  for (int i = 0; i < 60; ++i) h5::window(file_, "/view/" + std::to_string(i), {"/numbers/0", i, 1}, {"1", "window"});
  fs::copy_file(folder_ / "a.h5", folder_ / "copy.h5");
  const h5::File copy = h5::File::open(folder_ / "copy.h5");
  for (int i = 0; i < 60; ++i) EXPECT_EQ(h5::extent(copy, "/numbers/" + std::to_string(i)).rows, 40);
  EXPECT_FALSE(copy.has("/view"));
  file_.hold(false);
  for (h5::Series<double>& s : series) s.close();
  file_.flush();
  EXPECT_EQ(h5::extent(file_, "/numbers/59").rows, 160);
  EXPECT_EQ(h5::read<double>(file_, "/view/59"), (std::vector<double>{2.0}));
}

TEST_F(Window, a_small_file_has_room_for_many_chunks_all_the_same) {
  std::vector<double> rows(32 * 5000);
  std::iota(rows.begin(), rows.end(), 0.0);
  h5::Series<double> series(file_, "/numbers", 1, {"1", "numbers"});
  for (std::size_t at = 0; at < rows.size(); at += 100) series.append(std::span<const double>(rows).subspan(at, 100));
  series.close();
  EXPECT_EQ(h5::read<double>(file_, "/numbers"), rows);
}

TEST_F(Window, series_keeps_its_last_chunk_in_place_until_it_is_full) {
  h5::Series<double> series(h5::Growing(file_, 1e6), "/numbers", 1, {"1", "numbers"});
  constexpr std::int64_t kChunk = 8192;  // 64 KiB of doubles
  std::vector<double> expected;
  const auto add = [&](std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) expected.push_back(std::sqrt(2.0 + static_cast<double>(expected.size())));
    series.append(std::span<const double>(expected).last(static_cast<std::size_t>(count)));
    series.flush();
    file_.flush();
    EXPECT_EQ(series.rows(), static_cast<std::int64_t>(expected.size()));
    // The copy equals the file that another process reads, or that remains after a kill.
    fs::copy_file(folder_ / "a.h5", folder_ / "copy.h5", fs::copy_options::overwrite_existing);
    EXPECT_EQ(h5::read<double>(h5::File::open(folder_ / "copy.h5"), "/numbers"), expected);
  };
  add(5);
  const Chunk first = chunk_of(file_, "/numbers", 0);
  EXPECT_EQ(first.skipped, 3u);
  EXPECT_EQ(first.bytes, 8u * kChunk);
  add(1000);
  EXPECT_EQ(chunk_of(file_, "/numbers", 0).address, first.address);
  EXPECT_EQ(chunk_of(file_, "/numbers", 0).bytes, first.bytes);
  add(kChunk);                                                   // over the end of the first chunk
  add(3 * kChunk - static_cast<std::int64_t>(expected.size()));  // to the very end of the third
  add(1);
  series.close();
  file_.flush();
  EXPECT_EQ(h5::read<double>(file_, "/numbers"), expected);
  for (hsize_t i = 0; i < 4; ++i) EXPECT_EQ(chunk_of(file_, "/numbers", i).skipped, 0u) << "not deflated: " << i;
}

TEST_F(Window, rows_that_do_not_deflate_are_those_that_were_written) {
  // Rows are first flushed unfiltered: a chunk replaced by one of equal length must not get other filters.
  h5::Series<std::uint64_t> series(file_, "/noise", 1, {"1", "noise"});
  std::vector<std::uint64_t> rows;
  std::uint64_t x = 88172645463325252ULL;
  for (int i = 0; i < 70; ++i) {
    x ^= x << 13U, x ^= x >> 7U, x ^= x << 17U;
    rows.push_back(x);
    series.append(x);
    if (i % 10 == 0) series.flush();
  }
  series.close();
  file_.flush();
  EXPECT_EQ(h5::read<std::uint64_t>(file_, "/noise"), rows);
}

TEST_F(Window, series_never_flushed_is_whole_after_close) {
  h5::Series<std::int32_t> series(file_, "/pairs", 2, {"1", "pairs"});
  series.append(std::vector<std::int32_t>{1, 2, 3, 4, 5, 6});
  series.close();
  h5::Series<std::int32_t> empty(file_, "/empty", 1, {"1", "empty"});
  empty.flush();
  empty.close();
  EXPECT_EQ(h5::read<std::int32_t>(file_, "/pairs"), (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(h5::extent(file_, "/empty").rows, 0);
}

// --- cell means ---------------------------------------------------------------------------------------------------

TEST(CellMean, affine_field_gives_its_value_at_the_centroid_of_any_shape) {
  // An L of unit squares, far from the origin: centroid (5/6, 5/6) from its corner, unlike the mean of the vertices.
  const double x0 = 1e4, y0 = -3e4;
  std::vector<double> place, value;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}}) {
    place.insert(place.end(), {x0 + x, y0 + y});
    value.insert(value.end(), {3.0 + 2.0 * x - y, 0.5 * x + 4.0 * y});
  }
  const std::vector<std::int32_t> offsets{0, 6}, connectivity{0, 1, 2, 3, 4, 5};
  const std::vector<double> mean = cell_mean(place, value, offsets, connectivity);
  ASSERT_EQ(mean.size(), 2u);
  EXPECT_NEAR(mean[0], 3.0 + 5.0 / 6.0, 1e-11);  // 1e-16 of the coordinates times a few operations
  EXPECT_NEAR(mean[1], 4.5 * 5.0 / 6.0, 1e-11);
}

TEST(CellMean, does_not_depend_on_the_sense_of_a_cell) {
  const std::vector<double> place{0, 0, 4, 0, 3, 2, 1, 3}, value{1, 5, -2, 0, 4, 4, 9, -7};
  const std::vector<std::int32_t> offsets{0, 4, 8}, connectivity{0, 1, 2, 3, 0, 3, 2, 1};
  const std::vector<double> mean = cell_mean(place, value, offsets, connectivity);
  EXPECT_DOUBLE_EQ(mean[0], mean[2]);
  EXPECT_DOUBLE_EQ(mean[1], mean[3]);
}

TEST(CellMean, cell_without_area_gives_the_mean_of_its_points) {
  const std::vector<double> place{0, 0, 1, 1, 2, 2}, value{1, 0, 2, 0, 6, 3};
  const std::vector<double> mean =
      cell_mean(place, value, std::vector<std::int32_t>{0, 3}, std::vector<std::int32_t>{0, 1, 2});
  EXPECT_DOUBLE_EQ(mean[0], 3.0);
  EXPECT_DOUBLE_EQ(mean[1], 1.0);
}

}  // namespace
}  // namespace scree::io::xdmf_test
