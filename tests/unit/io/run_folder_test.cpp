// The run folder: summary, what may be replaced, what fails and how.
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
#include <set>
#include <sstream>

#include "io/pictures/snapshot.h"
#include "io/pictures/ticks.h"
#include "io/results/h5_read.h"
#include "io/results/json.h"
#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "io/results/sha256.h"
#include "tests/unit/io/results_run.h"

namespace scree::io {
namespace {

using namespace test;

/// Accepts exactly JSON (RFC 8259); returns where it ends, or npos.
class JsonCheck {
 public:
  explicit JsonCheck(const std::string& text) : text_(text) {}
  bool valid() {
    if (!value()) return false;
    space();
    return at_ == text_.size();
  }

 private:
  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void space() {
    while (now() == ' ' || now() == '\n' || now() == '\t' || now() == '\r') ++at_;
  }
  bool take(char c) { return now() == c ? (++at_, true) : false; }
  bool word(const std::string& w) { return text_.compare(at_, w.size(), w) == 0 ? (at_ += w.size(), true) : false; }
  bool string() {
    if (!take('"')) return false;
    while (at_ < text_.size() && now() != '"') {
      if (static_cast<unsigned char>(now()) < 0x20) return false;
      if (take('\\') && std::string("\"\\/bfnrtu").find(now()) == std::string::npos) return false;
      ++at_;
    }
    return take('"');
  }
  bool digits() {
    const std::size_t from = at_;
    while (std::isdigit(static_cast<unsigned char>(now()))) ++at_;
    return at_ > from;
  }
  bool number() {
    take('-');
    if (!take('0') && !digits()) return false;
    if (take('.') && !digits()) return false;
    if (take('e') || take('E')) return (take('+') || take('-') || true) && digits();
    return true;
  }
  bool members(char end, bool keys) {
    space();
    if (take(end)) return true;
    do {
      space();
      if (keys && !(string() && (space(), take(':')))) return false;
      if (!value()) return false;
      space();
    } while (take(','));
    return take(end);
  }
  bool value() {
    space();
    if (take('{')) return members('}', true);
    if (take('[')) return members(']', false);
    return now() == '"' ? string() : word("true") || word("false") || word("null") || number();
  }
  const std::string& text_;
  std::size_t at_ = 0;
};

TEST_F(Results, summary_is_valid_json_with_what_was_asked) {
  const std::string text = text_of(run / "summary.json");
  EXPECT_TRUE(JsonCheck(text).valid()) << text;
  for (const char* part : {"\"status\": \"done\"", "\"title\": \"A \\\"small\\\" run\\\\\"", "\"final_time\": 2",
                           "\"kinetic_before\": 12.5", "\"case_sha256\": \"", "\"state_hash\": \"",
                           "\"relative_closure\": ", "\"scheme_share\": 0", "\"method\": \"dda\"",
                           "\"peak_memory_bytes\": ", "\"energy_error\": 1e-15"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  // The block moved by (0.2, 0.4), the base not at all.
  const double moved = std::strtod(text.c_str() + text.rfind("\"displacement\": ") + 16, nullptr);
  EXPECT_NEAR(moved, std::hypot(0.2, 0.4), 1e-15);
}

TEST(Json, text_with_controls_and_bad_bytes_is_escaped) {
  EXPECT_EQ(json_quoted("a\"b\\c\nd\x01\xc3\xa4"), "\"a\\\"b\\\\c\\nd\\u0001\xc3\xa4\"");
  EXPECT_EQ(json_quoted("\xff\xc0\xaf\xed\xa0\x80"),
            "\"\\ufffd\\ufffd\\ufffd\\ufffd\\ufffd\\ufffd\"");  // none is UTF-8
  EXPECT_EQ(json_number(std::nan("")), "null");
  EXPECT_EQ(std::stod(json_number(0.1 + 0.2)), 0.1 + 0.2);
}

// --- SHA-256 ------------------------------------------------------------------------------------------------------

TEST(Sha256, published_vectors_match) {  // FIPS 180-2, appendix B
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
  fs::create_symlink("/dev/full", folder.history());  // the table is opened there
  ResultsSink sink(folder, provenance());
  EXPECT_THROW(small.play(sink), FileError);
}

/// Files may not grow beyond a size while this lives: what a full disk does to a write.
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
}  // namespace scree::io
