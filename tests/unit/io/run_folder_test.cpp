// The run folder: summary, files that may be replaced, and failures.
#include <cairo/cairo.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "io/pictures/snapshot.h"
#include "io/pictures/ticks.h"
#include "io/results/h5_read.h"
#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "io/results/sha256.h"
#include "io/results/summary.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::run_folder_test {
namespace {

using namespace test;

TEST_F(Results, summary_is_valid_json_with_what_was_asked) {
  const std::string text = text_of(run / "summary.json");
  EXPECT_TRUE(nlohmann::json::accept(text)) << text;
  for (const char* part : {"\"status\": \"done\"", "\"title\": \"A \\\"small\\\" run\\\\\"", "\"final_time\": 2",
                           "\"kinetic_before\": 12.5", "\"case_sha256\": \"", "\"state_hash\": \"",
                           "\"relative_closure\": ", "\"scheme_share\": 0", "\"method\": \"dda\"",
                           "\"peak_memory_bytes\": ", "\"energy_error\": 1e-15"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  // The block moved by (0.2, 0.4), the base not at all.
  const double moved = std::strtod(text.c_str() + text.rfind("\"displacement\": ") + 16, nullptr);
  EXPECT_NEAR(moved, std::hypot(0.2, 0.4), 1e-15);
}

TEST(Summary, numbers_and_texts_read_back_and_none_steers_a_terminal) {
  SmallRun small;
  small.use_triangles();
  const double third = 0.1 + 0.2;
  const std::string texts = "a\"b\\c\nd\te\x01\x7f ä \u009b\u202e\u2028";
  Provenance provenance;
  provenance.overrides = {texts, "\xff\xc0\xaf\xed\xa0\x80", ""};  // the second is not UTF-8 in any byte
  Summary summary(small.model, provenance);
  summary.event({coupling::EventKind::warning, third, texts});
  summary.event({coupling::EventKind::warning, 4e300, ""});
  const std::string text = summary.text({}, small.frame(5e-324, 0, 0.0, 0.0, 0.0));
  for (const char* bad : {"\t", "\x01", "\x7f", "\u009b", "\u202e", "\u2028", "\xff", "\xc0", "\xaf"})
    EXPECT_EQ(text.find(bad), std::string::npos) << bad;
  EXPECT_NE(text.find(" ä \\u009B\\u202E\\u2028\""), std::string::npos) << "letters stay as they are";
  const nlohmann::json json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("set").at(0), texts);
  EXPECT_EQ(json.at("set").at(1), "\ufffd\ufffd\ufffd\ufffd\ufffd\ufffd");
  EXPECT_EQ(json.at("set").at(2), "");
  EXPECT_EQ(json.at("warnings").at(0).at("text"), texts);
  EXPECT_EQ(json.at("warnings").at(0).at("time").get<double>(), third);
  EXPECT_EQ(json.at("warnings").at(1).at("time").get<double>(), 4e300);
  EXPECT_EQ(json.at("final_time").get<double>(), 5e-324);
}

// --- SHA-256 ------------------------------------------------------------------------------------------------------

TEST(Sha256, published_vectors_match) {  // all but the first: FIPS 180-2, appendix B
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// --- folders and failures -----------------------------------------------------------------------------------------

TEST(RunFolder, folder_with_other_files_is_refused_and_untouched) {
  const Scratch scratch;
  for (const char* name : {"notes.txt", "summary.json"}) std::ofstream(scratch.path() / name) << "mine";
  EXPECT_THROW((void)RunFolder::create(scratch.path(), true), FileError);
  EXPECT_EQ(text_of(scratch.path() / "notes.txt") + text_of(scratch.path() / "summary.json"), "minemine");
}

TEST(RunFolder, earlier_run_is_replaced_only_when_allowed) {
  const Scratch scratch;
  const fs::path run = scratch.path() / "deep/run";
  {
    ResultsSink sink(RunFolder::create(run, false), provenance());
    SmallRun().play(sink);
  }
  std::ofstream(run / "notes.txt") << "mine";
  EXPECT_THROW((void)RunFolder::create(run, false), FileError);
  EXPECT_TRUE(fs::exists(run / "run.vtkhdf"));
  (void)RunFolder::create(run, true);
  EXPECT_FALSE(fs::exists(run / "run.vtkhdf"));
  EXPECT_TRUE(fs::exists(run / "notes.txt"));
}

TEST(RunFolder, file_in_its_place_is_refused_with_path_and_reason) {
  const Scratch scratch;
  std::ofstream(scratch.path() / "run") << "mine";
  try {
    (void)RunFolder::create(scratch.path() / "run", true);
    FAIL() << "no FileError";
  } catch (const FileError& e) {
    EXPECT_EQ(e.path, scratch.path() / "run");
    EXPECT_NE(e.reason.find("not a folder"), std::string::npos);
  }
  EXPECT_EQ(text_of(scratch.path() / "run"), "mine");
}

TEST(ResultsSinkFailure, folder_that_vanished_gives_file_error) {
  const Scratch scratch;
  SmallRun small;
  ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
  fs::remove_all(scratch.path() / "run");
  try {
    sink.begin(small.model, small.plan);
    FAIL() << "no FileError";
  } catch (const FileError& e) {
    EXPECT_EQ(e.path, scratch.path() / "run/run.vtkhdf");
    EXPECT_NE(e.reason.find("No such file"), std::string::npos) << e.reason;
  }
}

TEST(ResultsSinkFailure, full_disk_gives_file_error_at_a_frame) {
  const Scratch scratch;
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  SmallRun small;
  const RunFolder folder = RunFolder::create(scratch.path() / "run", false);
  fs::create_symlink("/dev/full", folder.history());  // path of the table
  ResultsSink sink(folder, provenance());
  EXPECT_THROW(small.play(sink), FileError);
}

/// Limits the size of files during its lifetime: writes fail as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST(ResultsSinkFailure, results_file_that_cannot_grow_gives_file_error) {
  const Scratch scratch;
  SmallRun small;
  ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
  sink.begin(small.model, small.plan);
  const FileSizeLimit limit(fs::file_size(scratch.path() / "run/run.vtkhdf") + 4096);
  small.use_triangles();
  try {
    for (int i = 0; i < 1000; ++i) sink.frame(small.frame(0.001 * i, 0, 0.1 * i, 1.0, 1e6 * i));
    FAIL() << "no FileError";
  } catch (const FileError& e) {
    EXPECT_EQ(e.path, scratch.path() / "run/run.vtkhdf");
    EXPECT_NE(e.reason.find("File too large"), std::string::npos) << e.reason;
  }
}

TEST(RunReaderFailure, file_that_is_no_run_gives_file_error) {
  const Scratch scratch;
  EXPECT_THROW(RunReader{scratch.path()}, FileError);
  std::ofstream(scratch.path() / "run.vtkhdf") << "not HDF5";
  EXPECT_THROW(RunReader{scratch.path()}, FileError);
}

}  // namespace
}  // namespace scree::io::run_folder_test
