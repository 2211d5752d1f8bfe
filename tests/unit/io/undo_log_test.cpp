// The undo log restores the content of a file, whenever the later writes were interrupted.
#include "io/results/undo_log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "io/results/h5_read.h"
#include "io/results/h5_series.h"
#include "tests/unit/io/results_run.h"

namespace scree::test::undo_log_test {
namespace {

namespace fs = std::filesystem;
using io::UndoLog;

void put(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// A file of some pages that is overwritten here and there, and grows.
class OverwrittenFile : public testing::Test {
 protected:
  io::test::Scratch folder_;
  fs::path file_ = folder_.path() / "file", log_ = UndoLog::path_of(file_), copy_ = folder_.path() / "copy";
  std::string before_;
  std::mt19937 random_{7};

  void SetUp() override {
    for (int i = 0; i < 41'000; ++i) before_ += static_cast<char>(random_());
    put(file_, before_);
  }
  void overwrite(UndoLog& undo, int fd, std::uint64_t at, std::size_t size) {
    std::string other;
    for (std::size_t i = 0; i < size; ++i) other += static_cast<char>(random_());
    undo.save(at, size);
    ASSERT_EQ(::pwrite(fd, other.data(), size, static_cast<off_t>(at)), static_cast<ssize_t>(size));
  }
};

TEST_F(OverwrittenFile, is_as_it_was) {
  const int fd = ::open(file_.c_str(), O_RDWR);
  UndoLog undo(file_);
  undo.start(fd);
  for (int i = 0; i < 30; ++i) {
    overwrite(undo, fd, random_() % 60'000, 1 + random_() % 9'000);
    put(copy_, io::test::text_of(file_)), put(UndoLog::path_of(copy_), io::test::text_of(log_));
    EXPECT_TRUE(UndoLog::roll_back(copy_));
    EXPECT_EQ(io::test::text_of(copy_), before_);
    EXPECT_FALSE(fs::exists(UndoLog::path_of(copy_)));
  }
  EXPECT_LT(fs::file_size(log_), 41'000U + 12 * 32 + 100) << "every page once";
  ::close(fd);
}

TEST_F(OverwrittenFile, stretch_that_was_not_stored_whole_was_not_overwritten) {
  const int fd = ::open(file_.c_str(), O_RDWR);
  UndoLog undo(file_);
  undo.start(fd);
  overwrite(undo, fd, 100, 50);
  const std::string now = io::test::text_of(file_);
  const auto size = fs::file_size(log_);
  undo.save(9'000, 10);  // killed during this write
  const std::string logged = io::test::text_of(log_);
  for (std::size_t n = size; n < logged.size(); n += 97) {
    put(file_, now), put(log_, logged.substr(0, n));
    EXPECT_TRUE(UndoLog::roll_back(file_));
    EXPECT_EQ(io::test::text_of(file_), before_) << n;
  }
  ::close(fd);
}

TEST_F(OverwrittenFile, log_of_a_later_start_holds_for_that_one) {
  const int fd = ::open(file_.c_str(), O_RDWR);
  UndoLog undo(file_);
  undo.start(fd);
  overwrite(undo, fd, 5'000, 50'000);
  undo.start(fd);
  const std::string later = io::test::text_of(file_);
  overwrite(undo, fd, 100, 10);
  EXPECT_TRUE(UndoLog::roll_back(file_));
  EXPECT_EQ(io::test::text_of(file_), later);
  EXPECT_FALSE(UndoLog::roll_back(file_)) << "there is none any more";
  EXPECT_EQ(io::test::text_of(file_), later);
  ::close(fd);
}

TEST_F(OverwrittenFile, is_as_it_was_where_it_has_become_shorter_since) {
  const int fd = ::open(file_.c_str(), O_RDWR);
  UndoLog undo(file_);
  undo.start(fd);
  overwrite(undo, fd, 38'000, 10);  // a page of the end is stored already
  overwrite(undo, fd, 200, 10);
  for (const std::uint64_t end : {40'990U, 36'900U, 20'480U, 1U}) {
    undo.save(end, 41'000 - end);
    ASSERT_EQ(::ftruncate(fd, static_cast<off_t>(end)), 0);
    put(copy_, io::test::text_of(file_)), put(UndoLog::path_of(copy_), io::test::text_of(log_));
    EXPECT_TRUE(UndoLog::roll_back(copy_));
    EXPECT_TRUE(io::test::text_of(copy_) == before_) << end;
  }
  ::close(fd);
}

TEST_F(OverwrittenFile, is_left_alone_where_it_lacks_more_than_the_log_has) {
  const int fd = ::open(file_.c_str(), O_RDWR);
  UndoLog undo(file_);
  undo.start(fd);
  overwrite(undo, fd, 200, 10);
  undo.save(40'970, 30);
  ::close(fd);
  put(file_, before_.substr(0, 36'000));  // by another program
  EXPECT_TRUE(UndoLog::roll_back(file_));
  EXPECT_TRUE(io::test::text_of(file_) == before_.substr(0, 36'000));
}

TEST_F(OverwrittenFile, log_that_says_nothing_is_not_followed) {
  for (const std::string& text : {std::string(), std::string("SCRUNDO1"), std::string(24, 'x')}) {
    put(log_, text);
    EXPECT_TRUE(UndoLog::roll_back(file_));
    EXPECT_EQ(io::test::text_of(file_), before_);
  }
}

/// Results of a run killed at any instant: the copies equal the files of a killed program.
TEST(KeptResults, rows_up_to_the_instant_are_there_whatever_was_written_since) {
  const io::test::Scratch folder;
  const fs::path path = folder.path() / "run.vtkhdf", copy = folder.path() / "copy.vtkhdf";
  io::h5::File file = io::h5::File::create(path);
  io::h5::Series<double> series(file, "/group/numbers", 3, {"m", "numbers"});
  io::h5::TextSeries texts(file, "/group/texts", {"none", "texts"});
  double next = 0.0;
  const auto grow = [&](int rows) {
    for (int i = 0; i < rows; ++i, next += 1.0) series.append(std::array{next, -next, 0.5});
    texts.append(std::string(static_cast<std::size_t>(rows % 500), 'a'));
    file.group("/of/" + std::to_string(static_cast<int>(next)));
    series.flush(), texts.flush();
    file.flush();
  };
  for (int k = 0; k < 40; ++k) {
    grow(700);
    file.keep();
    const std::string kept = io::test::text_of(path);
    const io::SeriesMark mark = series.mark(), words = texts.mark();
    grow(k % 2 == 0 ? 90 : 9'000);
    grow(10);
    fs::copy_file(path, copy, fs::copy_options::overwrite_existing);
    fs::copy_file(UndoLog::path_of(path), UndoLog::path_of(copy), fs::copy_options::overwrite_existing);
    ASSERT_NE(io::test::text_of(copy), kept);
    ASSERT_TRUE(UndoLog::roll_back(copy));
    ASSERT_EQ(io::test::text_of(copy), kept);
    // The restored file is valid and contains the rows.
    io::h5::File other = io::h5::File::create(folder.path() / "other.vtkhdf");
    io::h5::Series<double> taken(other, "/group/numbers", 3, {"m", "numbers"});
    io::h5::TextSeries taken_texts(other, "/group/texts", {"none", "texts"});
    const io::h5::File old = io::h5::File::open(copy);
    ASSERT_NO_THROW(taken.take(old, mark));
    ASSERT_NO_THROW(taken_texts.take(old, words));
  }
  series.close(), texts.close();
  file.close();
  EXPECT_FALSE(fs::exists(UndoLog::path_of(path)));
}

}  // namespace
}  // namespace scree::test::undo_log_test
