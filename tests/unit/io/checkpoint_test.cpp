// A run resumed from a checkpoint equals the uninterrupted run bit for bit; an incomplete checkpoint is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <random>
#include <set>

#include "coupling/stages/driver.h"
#include "io/case/read_case.h"
#include "io/checkpoint/archive.h"
#include "io/checkpoint/checkpoints.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::checkpoint_test {
namespace {

bool full() { return std::getenv("SCREE_FULL") != nullptr; }

#ifdef __SANITIZE_ADDRESS__  // ten times as slow, and meant for memory errors, not for bits that differ
constexpr int kEvery = 211, kStops = 3;
#else
constexpr int kEvery = 61, kStops = 8;
#endif

Case resume_case(const std::string& name) {
  const std::vector<std::string> methods{"dda", "nmm"};
  return read_case(fs::path(SCREE_SOURCE_DIR) / "tests/e2e/resume" / (name + ".toml"), {}, methods);
}

RunRecord of_version(const std::string& version) {
  RunRecord run;
  run.version = version;
  return run;
}

/// Writes a checkpoint to a file and reads it back.
coupling::Checkpoint stored(const coupling::Checkpoint& checkpoint, const Scratch& scratch) {
  const fs::path file = scratch.path() / "checkpoint.0.scree";
  write_checkpoint(file, of_version("1"), {}, checkpoint);
  return read_checkpoint(file, "1").checkpoint;
}

/// Keeps a checkpoint every `steps` steps of a run.
class Every final : public coupling::Keeper {
 public:
  explicit Every(std::int64_t steps) : steps_(steps) {}
  bool due(std::int64_t step) override { return steps_ > 0 && step % steps_ == 0; }
  void keep(const coupling::Checkpoint& checkpoint) override { kept.push_back(checkpoint); }
  std::vector<coupling::Checkpoint> kept;

 private:
  std::int64_t steps_;
};

/// Histories and events that a run reports to its sinks, as text.
class Witness final : public coupling::Sink {
 public:
  void history(const coupling::HistoryView& h) override {
    Packer pack([this](std::string_view piece) { text += piece; });
    pack("", h.tick);
    for (const auto& span : {h.position, h.velocity, h.stress})
      for (const double x : span) pack("", x);
    pack("", h.ledger->moved());
    pack.flush();
  }
  void event(const coupling::Event& e) override { text += std::string(coupling::name(e.kind)) + e.text; }
  void topology(const coupling::MeshView& mesh) override { meshes.insert(mesh.id); }
  std::string text;
  std::set<std::uint32_t> meshes;
};

struct Outcome {
  std::uint64_t hash = 0;
  std::int64_t steps = 0, cuts = 0, factorisations = 0;
  std::size_t transfers = 0, travels = 0;
  std::string shown;
  std::set<std::uint32_t> meshes;  // reported to the sink
  auto operator<=>(const Outcome&) const = default;
};

Outcome outcome(const coupling::Driver& driver, const Witness& witness) {
  const coupling::RunStats& s = driver.stats();
  return {coupling::state_hash(driver.state()),
          s.steps,
          s.cuts,
          s.factorisations,
          driver.transfers().size(),
          driver.travels().size(),
          witness.text,
          witness.meshes};
}

Outcome run(const Case& c, coupling::Keeper* keeper) {
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver driver(c.model, c.plan, methods);
  Witness witness;
  driver.add_sink(witness);
  if (keeper != nullptr) driver.set_keeper(*keeper);
  EXPECT_EQ(driver.run().status, coupling::RunEnd::Status::done);
  return outcome(driver, witness);
}

Outcome go_on(const Case& c, coupling::Checkpoint from, coupling::Keeper* keeper = nullptr) {
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver driver(c.model, c.plan, methods);
  Witness witness;
  driver.add_sink(witness);
  if (keeper != nullptr) driver.set_keeper(*keeper);
  driver.continue_from(std::move(from));
  EXPECT_EQ(driver.run().status, coupling::RunEnd::Status::done);
  return outcome(driver, witness);
}

/// Expects the end state and statistics of the whole run, and the last part of its output.
void expect_same_end(const Outcome& part, const Outcome& whole, std::int64_t from_step) {
  EXPECT_TRUE(whole.shown.ends_with(part.shown)) << "from step " << from_step;
  EXPECT_TRUE(std::includes(whole.meshes.begin(), whole.meshes.end(), part.meshes.begin(), part.meshes.end()))
      << "from step " << from_step << ": a mesh that the whole run does not show";
  Outcome other = part;
  other.shown = whole.shown;
  other.meshes = whole.meshes;
  EXPECT_EQ(other.hash, whole.hash) << "from step " << from_step;
  EXPECT_TRUE(other == whole) << "from step " << from_step << ": statistics";
}

class Resume : public testing::TestWithParam<const char*> {};

TEST_P(Resume, from_every_checkpoint_ends_as_the_unbroken_run) {
  const Case c = resume_case(GetParam());
  const Scratch scratch;
  const Outcome whole = run(c, nullptr);
  EXPECT_GT(whole.steps, 100);
  Every often(full() ? 7 : kEvery);
  EXPECT_TRUE(run(c, &often) == whole) << "keeping checkpoints changes the run";
  Every seldom(1000003);
  EXPECT_TRUE(run(c, &seldom) == whole) << "keeping checkpoints changes the run";
  EXPECT_GE(often.kept.size(), c.plan.stages.size() + 1);
  for (const coupling::Checkpoint& checkpoint : often.kept)
    expect_same_end(go_on(c, stored(checkpoint, scratch)), whole, checkpoint.state.step);
}

TEST_P(Resume, twice_over_ends_as_the_unbroken_run) {
  const Case c = resume_case(GetParam());
  const Scratch scratch;
  const Outcome whole = run(c, nullptr);
  Every first(151);
  (void)run(c, &first);
  ASSERT_GE(first.kept.size(), 2U);
  const coupling::Checkpoint& early = first.kept[first.kept.size() / 3];
  Every second(89);
  expect_same_end(go_on(c, stored(early, scratch), &second), whole, early.state.step);
  for (const coupling::Checkpoint& late : second.kept)
    expect_same_end(go_on(c, stored(late, scratch)), whole, late.state.step);
}

/// Stops a run at the n-th poll, which may be in the middle of a step.
class StopAt final : public coupling::Control {
 public:
  explicit StopAt(std::int64_t n) : left_(n) {}
  bool stop_requested() override { return count(); }
  bool give_up_step() override { return count(); }

 private:
  bool count() { return --left_ <= 0; }
  std::int64_t left_;
};

/// Runs until the control stops the run.   @return the last checkpoint; nothing if the run was done before
std::optional<coupling::Checkpoint> last_of_stopped(const Case& c, coupling::Control& control,
                                                    coupling::Sink* sink = nullptr) {
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver driver(c.model, c.plan, methods);
  Every keeper(0);
  if (sink != nullptr) driver.add_sink(*sink);
  driver.set_control(control);
  driver.set_keeper(keeper);
  if (driver.run().status == coupling::RunEnd::Status::done) return std::nullopt;
  return keeper.kept.back();
}

TEST_P(Resume, after_a_stop_at_any_moment_ends_as_the_unbroken_run) {
  const Case c = resume_case(GetParam());
  const Scratch scratch;
  const Outcome whole = run(c, nullptr);
  std::mt19937 random(7);
  int stops = 0;
  for (int i = 0; i < (full() ? 60 : kStops); ++i) {
    StopAt control(1 + static_cast<std::int64_t>(random() % 1200));
    const auto last = last_of_stopped(c, control);
    if (!last) continue;
    ++stops;
    expect_same_end(go_on(c, stored(*last, scratch)), whole, last->state.step);
  }
  EXPECT_GE(stops, kStops / 3);
}

/// Stops a run in the step before which the n-th block changes its method by a rule.
class StopAtChange final : public coupling::Control, public coupling::Sink {
 public:
  explicit StopAtChange(int n) : left_(n) {}
  void event(const coupling::Event& e) override {
    if (e.transfer != nullptr && e.transfer->by_rule) --left_;
  }
  bool stop_requested() override { return left_ <= 0; }
  bool give_up_step() override { return left_ <= 0; }

 private:
  int left_;
};

TEST(ResumeCases, that_stop_between_a_change_of_method_and_its_step_end_as_the_unbroken_run) {
  const Case c = resume_case("rules");
  const Scratch scratch;
  const Outcome whole = run(c, nullptr);
  int stops = 0;
  for (int n = 1; n < 20; ++n) {
    StopAtChange control(n);
    const auto last = last_of_stopped(c, control, &control);
    if (!last) break;
    ++stops;
    expect_same_end(go_on(c, stored(*last, scratch)), whole, last->state.step);
  }
  EXPECT_GE(stops, 3);
}

INSTANTIATE_TEST_SUITE_P(Cases, Resume,
                         testing::Values("staged", "kept", "motion", "sides", "divided", "rules", "digging", "tangent",
                                         "sleep"),
                         [](const auto& of) { return std::string(of.param); });

TEST(ResumeCases, pass_through_all_that_is_remembered) {
  // Premise of the tests above: a field that is not stored is found only if the cases give it a value.
  Every keeper(20);
  const Outcome whole = run(resume_case("staged"), &keeper);
  EXPECT_GT(whole.cuts, 10);
  EXPECT_GT(whole.transfers, 0U);
  Every often(3);
  (void)run(resume_case("kept"), &often);
  keeper.kept.insert(keeper.kept.end(), often.kept.begin(), often.kept.end());
  std::set<std::string> seen;
  for (const coupling::Checkpoint& at : keeper.kept) {
    const coupling::State& s = at.state;
    for (const coupling::ContactMemory& m : s.contacts) {
      if (m.status == coupling::ContactStatus::slip) seen.insert("slip");
      if (m.status == coupling::ContactStatus::stick) seen.insert("stick");
      if (m.bonded != 0) seen.insert("bond");
      if (m.failed != 0) seen.insert("failed");
      if (m.gap0 != 0.0 && m.slip > 0.0) seen.insert("dilated");
      if (m.water != 0.0) seen.insert("water");
      if (m.fd != 0.0 || m.fdt != 0.0) seen.insert("contact damping");
      if (m.key.block_p == m.key.block_e) seen.insert("crack");
    }
    if (!s.a.empty()) seen.insert("acceleration");
    if (!s.v_before.empty()) seen.insert("lagging velocity");
    if (!s.damping.empty()) seen.insert("damping");
    if (!s.factored.value.empty()) seen.insert("factor");
    if (s.factored.choice.block_work > 0.0) seen.insert("choice of the solver");
    if (s.relaxing > 0.0) seen.insert("relaxing");
    if (!s.rest.empty()) seen.insert("reservoir");
    if (at.largest_step > 0 && !at.integrator.bound.empty()) seen.insert("step within an interval");
  }
  const std::set<std::string> all{"slip",
                                  "stick",
                                  "bond",
                                  "failed",
                                  "dilated",
                                  "water",
                                  "contact damping",
                                  "crack",
                                  "acceleration",
                                  "lagging velocity",
                                  "damping",
                                  "factor",
                                  "choice of the solver",
                                  "relaxing",
                                  "reservoir",
                                  "step within an interval"};
  for (const std::string& wanted : all) EXPECT_TRUE(seen.contains(wanted)) << wanted;
}

TEST(ResumeCases, have_blocks_that_change_sides_both_ways) {
  Every keeper(1);
  (void)run(resume_case("sides"), &keeper);
  int to_explicit = 0, to_implicit = 0;
  for (std::size_t k = 1; k < keeper.kept.size(); ++k) {
    const coupling::State &before = keeper.kept[k - 1].state, &after = keeper.kept[k].state;
    if (before.stage != after.stage) continue;
    for (std::size_t b = 0; b < after.explicit_side.size(); ++b) {
      to_explicit += before.explicit_side[b] < after.explicit_side[b];
      to_implicit += before.explicit_side[b] > after.explicit_side[b];
    }
  }
  EXPECT_GE(to_explicit, 3);
  EXPECT_GE(to_implicit, 2);
}

TEST(ResumeCases, have_stages_and_methods_that_rules_decide) {
  const Case c = resume_case("rules");
  Every keeper(1);
  const Outcome whole = run(c, &keeper);
  const coupling::Checkpoint& last = keeper.kept.back();
  std::map<std::string, int> changes;  // number of changes to each method
  for (const coupling::TransferRow& row : last.transfers)
    if (row.by_rule) ++changes[row.to];
  EXPECT_GE(changes["dda"], 2);
  EXPECT_GE(changes["nmm"], 1);
  std::size_t ends = 0;
  for (std::size_t at = 0; (at = whole.shown.find(" ends by a rule: ", at)) != std::string::npos; ++at) ++ends;
  EXPECT_EQ(ends, c.plan.stages.size());
  std::set<std::string> seen;
  for (const coupling::Checkpoint& at : keeper.kept) {
    const coupling::RuleMemory& m = at.state.rules;
    if (m.peak > 0.0) seen.insert("peak");
    if (m.slow_since >= 0) seen.insert("slow");
    if (m.balanced_since >= 0) seen.insert("balanced");
    if (!m.slips.empty()) seen.insert("slips");
    for (const Tick t : m.calm_since) seen.insert(t >= 0 ? "calm" : "not calm");
    for (const char other : m.other_method) seen.insert(other != 0 ? "other" : "own");
    if (!at.state.anchors.empty()) seen.insert("anchors");
  }
  for (const char* wanted : {"peak", "slow", "balanced", "slips", "calm", "not calm", "other", "own", "anchors"})
    EXPECT_TRUE(seen.contains(wanted)) << wanted;
}

TEST(ResumeCases, name_their_files) {
  EXPECT_EQ(resume_case("staged").files,
            std::vector<fs::path>{fs::path(SCREE_SOURCE_DIR) / "tests/e2e/resume" / "pulse.csv"});
  EXPECT_TRUE(resume_case("kept").files.empty());
  const std::vector<std::string> methods{"dda", "nmm"};
  const Case all = read_case(fs::path(SCREE_SOURCE_DIR) / "tests/unit/io/full_case.toml", {}, methods);
  EXPECT_EQ(all.files.size(), 5U);  // a record, traces, an outline, loads and a drawing
}

// --- files ---

coupling::Checkpoint small_checkpoint() {
  const Case c = resume_case("kept");
  Every keeper(50);
  (void)run(c, &keeper);
  return keeper.kept[keeper.kept.size() / 2];
}

std::string refusal(const fs::path& file, const std::string& version = "1") {
  try {
    (void)read_checkpoint(file, version);
  } catch (const FileError& e) {
    EXPECT_EQ(e.path, file);
    return e.what();
  }
  return {};
}

void put(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

TEST(CheckpointFile, keeps_every_bit) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "c";
  StoredCheckpoint written{of_version("1"), {}, small_checkpoint()};
  written.run.overrides = {"a=1", ""};
  written.run.audit = true;
  written.run.until = 0.25;
  written.results.frames = {{3, 1}, {4, 15}};
  written.results.tables = {{{15, 7}, {92, 8}}};
  write_checkpoint(file, written.run, written.results, written.checkpoint);
  const StoredCheckpoint read = read_checkpoint(file, "1");
  EXPECT_EQ(read.run.overrides, written.run.overrides);
  EXPECT_TRUE(read.run.audit);
  EXPECT_EQ(read.run.until, 0.25);
  EXPECT_EQ(read.results.frames, written.results.frames);
  EXPECT_EQ(read.results.tables, written.results.tables);
  const fs::path again = scratch.path() / "again";
  write_checkpoint(again, read.run, read.results, read.checkpoint);
  EXPECT_EQ(text_of(again), text_of(file));
}

TEST(CheckpointFile, cut_or_flipped_anywhere_is_refused) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "checkpoint.3.scree";
  write_checkpoint(file, of_version("1"), {}, small_checkpoint());
  const std::string whole = text_of(file);
  std::mt19937 random(11);
  const auto expect_refused = [&](const std::string& bytes, const std::string& what) {
    put(file, bytes);
    const std::string why = refusal(file);
    EXPECT_NE(why.find("cannot go on from this checkpoint: it "), std::string::npos) << what << ": " << why;
  };
  for (int i = 0; i < (full() ? 100 : 40); ++i) {
    const std::size_t at = i < 32 ? static_cast<std::size_t>(i) : random() % whole.size();
    expect_refused(whole.substr(0, at), "cut at " + std::to_string(at));
  }
  expect_refused(whole + '\0', "a byte more");
  for (int i = 0; i < (full() ? 1000 : 200); ++i) {
    const std::size_t at = i < 32 ? static_cast<std::size_t>(i) : random() % whole.size();
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (random() % 8)));
    expect_refused(flipped, "flipped at " + std::to_string(at));
  }
  put(file, whole);
  EXPECT_EQ(refusal(file), "");
}

TEST(CheckpointFile, of_another_version_or_missing_is_refused) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "c";
  write_checkpoint(file, of_version("1"), {}, {});
  EXPECT_NE(refusal(file, "2").find("it is of Scree 1, and this is Scree 2"), std::string::npos);
  EXPECT_NE(refusal(scratch.path() / "none").find("cannot open"), std::string::npos);
}

TEST(CheckpointFile, damaged_newest_gives_way_to_the_one_before) {
  const Scratch scratch;
  const RunFolder folder = RunFolder::create(scratch.path() / "run", false);
  coupling::Checkpoint checkpoint;
  for (const int n : {9, 10}) {
    checkpoint.state.step = n;
    write_checkpoint(folder.path() / ("checkpoint." + std::to_string(n) + ".scree"), of_version("1"), {}, checkpoint);
  }
  put(folder.path() / "checkpoint.11.scree.tmp", "what a killed run left");
  std::vector<std::string> refused;
  const auto find = [&] {
    refused.clear();
    return newest_checkpoint(folder, "1", [&](const std::string& why) { refused.push_back(why); });
  };
  EXPECT_EQ(find().stored.checkpoint.state.step, 10);
  EXPECT_TRUE(refused.empty());
  put(folder.path() / "checkpoint.10.scree", "SCREE-CP");
  EXPECT_EQ(find().stored.checkpoint.state.step, 9);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_NE(refused[0].find("checkpoint.10.scree: cannot go on from this checkpoint: it is cut short"),
            std::string::npos);
  put(folder.path() / "checkpoint.9.scree", "");
  EXPECT_THROW((void)find(), FileError);
  EXPECT_EQ(refused.size(), 2U);
}

TEST(FolderLock, keeps_a_second_run_out) {
  const Scratch scratch;
  const FolderLock first(scratch.path());
  EXPECT_THROW(FolderLock second(scratch.path()), FileError);
}

}  // namespace
}  // namespace scree::io::test::checkpoint_test
