// Results: a small synthetic run goes through the sink and is read back; pictures; failures.
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

#include "io/results/h5_read.h"
#include "io/results/json.h"
#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "io/results/sha256.h"
#include "io/results/snapshot.h"
#include "io/results/ticks.h"

#if defined(__SANITIZE_ADDRESS__)
/// The font library keeps its cache until the process ends, and says so nowhere.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
#endif

namespace scree::io {
namespace {

namespace fs = std::filesystem;
using coupling::Column;
using coupling::Integrator;

/// A folder of this test's own, removed at its end.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "scree-results-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Scratch() {
    std::error_code ignored;  // a folder left behind is no failure of what is tested
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A wide held base (one cell) and a block on it: two triangles at first, then one rectangle of another method.
struct SmallRun {
  Model model;
  coupling::Plan plan;
  coupling::State state;
  coupling::RunStats stats;
  std::vector<std::int32_t> offsets, connectivity, block, material, method;
  std::vector<double> origin, position, velocity, stress;
  coupling::MeshView mesh;

  SmallRun() {
    model.title = "A \"small\" run\\";
    model.materials.push_back({"rock", 2600.0, 1e9, 0.2});
    for (const auto& [name, box] :
         {std::pair{"base", Box{{0.0, -2.0}, {10.0, 0.0}}}, {"top", Box{{4.0, 0.0}, {6.0, 2.0}}}}) {
      Block b;
      b.name = name;
      b.polygon.outer = {box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}};
      b.material = MaterialId{0};
      model.blocks.push_back(b);
    }
    model.joints.emplace_back();
    model.joints.back().name = "rough";
    model.joint_lines.push_back({{4.0, 1.0}, {6.0, 1.5}, JointId{0}, JointLine::Kind::joint_set, 3});
    model.cracks.push_back({{4.0, 1.0}, {5.0, 1.25}, JointId{0}, BlockId{1}});
    model.block_supports.push_back({BlockId{0}, MotionId{}});
    model.monitors.push_back({"crest, left", BlockId{1}, {4.0, 2.0}});
    model.monitors.push_back({"crest, left", BlockId{1}, {6.0, 2.0}});
    for (const auto& [name, scheme] : {std::pair{"shake", Integrator::explicit_}, {"fall", Integrator::implicit}}) {
      coupling::Stage s;
      s.name = name;
      s.integrator = scheme;
      s.duration = ticks(1.0);
      plan.stages.push_back(s);
    }
    state.ledger.open(std::array{0.0});
  }

  void use_triangles() {
    offsets = {0, 4, 7, 10};
    connectivity = {0, 1, 2, 3, 4, 5, 6, 4, 6, 7};
    block = {0, 1, 1}, material = {0, 0, 0}, method = {1, 0, 0};
    mesh.methods = {"nmm", "dda"};
    use(1);
  }
  void use_rectangle() {
    offsets = {0, 4, 8};
    connectivity = {0, 1, 2, 3, 4, 5, 6, 7};
    block = {0, 1}, material = {0, 0}, method = {0, 0};
    mesh.methods = {"dda"};  // counted anew in each mesh
    use(2);
  }
  void use(std::uint32_t id) {
    origin = {0, -2, 10, -2, 10, 0, 0, 0, 4, 0, 6, 0, 6, 2, 4, 2};
    position = origin;
    velocity.assign(origin.size(), 0.0);
    stress.assign(3 * block.size(), 0.0);
    mesh.id = id;
    mesh.offsets = offsets, mesh.connectivity = connectivity;
    mesh.cell_block = block, mesh.cell_material = material, mesh.cell_method = method;
    mesh.origin = origin;
  }

  /// The block displaced by (d, 2d), moving at (v, 0), every cell under the stress (s, -3 s, 0).
  coupling::FrameView frame(double time, std::int32_t stage, double d, double v, double s) {
    for (std::size_t p = 4; p < 8; ++p) {
      position[2 * p] = origin[2 * p] + d;
      position[2 * p + 1] = origin[2 * p + 1] + 2.0 * d;
      velocity[2 * p] = v;
    }
    for (std::size_t c = 0; c < block.size(); ++c)
      stress[3 * c] = s, stress[3 * c + 1] = -3.0 * s, stress[3 * c + 2] = 0.0;
    state.step += 10;
    state.time = ticks(time);
    stats.steps = state.step;
    coupling::FrameView f;
    f.time = time, f.tick = state.time, f.step = state.step, f.stage = stage;
    f.stage_name = plan.stages[static_cast<std::size_t>(stage)].name;
    f.integrator = plan.stages[static_cast<std::size_t>(stage)].integrator;
    f.end_time = 2.0;
    f.position = position, f.velocity = velocity, f.stress = stress;
    f.mesh = &mesh, f.state = &state, f.stats = &stats;
    return f;
  }

  void history(coupling::Sink& sink, double time) {
    coupling::Ledger& ledger = state.ledger;
    ledger.set(Column::kinetic, 3.0 * time);
    ledger.book(Column::gravity, time);
    ledger.book(Column::friction, 0.25 * time);
    const std::array<double, 4> x{4.0, 2.0 + time, 6.0, 2.0 + time}, u{0.0, time, 0.0, time},
        v{0.1, 0.2, 0.3, 1.0 / 3.0};
    coupling::HistoryView h;
    h.time = time, h.tick = ticks(time);
    h.position = x, h.displacement = u, h.velocity = v;
    h.ledger = &ledger, h.stats = &stats;
    sink.history(h);
  }

  /// Frames at 0, 0.5, 1 on triangles; 1, 2 on the rectangle.
  void play(coupling::Sink& sink) {
    sink.begin(model, plan);
    use_triangles();
    sink.topology(mesh);
    for (const double t : {0.0, 0.5, 1.0}) {
      history(sink, t);
      sink.frame(frame(t, 0, 0.1 * t, 1.0, 1e6 * t));
    }
    coupling::TransferRow row;
    row.time = 1.0, row.block = BlockId{1}, row.from = "nmm", row.to = "dda";
    row.before.kinetic = 12.5, row.energy_error = 1e-15;
    sink.event({coupling::EventKind::transfer, 1.0, "hand-over\n\"top\"", &row});
    use_rectangle();
    sink.topology(mesh);
    for (const double t : {1.0, 2.0}) {
      history(sink, t);
      sink.frame(frame(t, 1, 0.1 * t, 2.0, -2e6 * t));
    }
    sink.end({}, frame(2.0, 1, 0.2, 2.0, -4e6));
  }
};

Provenance provenance() {
  Provenance p;
  p.version = "1.2.3", p.commit = "0123abc", p.case_text = "title = \"ä\"\n", p.command_line = "scree run case.toml",
  p.threads = 3;
  return p;
}

/// The small run in a folder, made once.
class Results : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch = std::make_unique<Scratch>();
    run = scratch->path() / "run";
    ResultsSink sink(RunFolder::create(run, false), provenance());
    SmallRun().play(sink);
  }
  static void TearDownTestSuite() { scratch.reset(); }
  static inline std::unique_ptr<Scratch> scratch;
  static inline fs::path run;
};

// --- run.vtkhdf ---------------------------------------------------------------------------------------------------

TEST_F(Results, frames_read_back_are_those_given) {
  const RunReader reader(run);
  EXPECT_EQ(reader.times(), (std::vector<double>{0.0, 0.5, 1.0, 1.0, 2.0}));
  EXPECT_EQ(reader.title(), "A \"small\" run\\");
  const StoredFrame a = reader.frame(1), b = reader.frame(4);
  EXPECT_EQ(a.cells(), 3u);
  EXPECT_EQ(b.cells(), 2u);
  EXPECT_EQ(a.connectivity, (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 4, 6, 7}));
  EXPECT_EQ(b.offsets, (std::vector<std::int64_t>{0, 4, 8}));
  EXPECT_EQ(a.displacement[8], (4.0 + 0.05) - 4.0);  // position - origin, bit for bit
  EXPECT_EQ(a.displacement[9], 0.1);
  EXPECT_EQ(b.position[8], 4.2);
  EXPECT_EQ(a.velocity[8], 1.0);
  EXPECT_EQ(a.block, (std::vector<std::int32_t>{0, 1, 1}));
  EXPECT_EQ(b.element, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(a.stage, "shake");
  EXPECT_EQ(b.stage, "fall");
  EXPECT_EQ(a.cell_integrator.front(), 0);
  EXPECT_EQ(b.cell_integrator.back(), 1);
  EXPECT_NE(a.state_hash, b.state_hash);
}

TEST_F(Results, methods_of_two_meshes_get_one_numbering) {
  const RunReader reader(run);
  EXPECT_EQ(reader.methods(), (std::vector<std::string>{"nmm", "dda"}));
  EXPECT_EQ(reader.frame(0).method, (std::vector<std::int32_t>{1, 0, 0}));
  EXPECT_EQ(reader.frame(4).method, (std::vector<std::int32_t>{1, 1}));
}

TEST_F(Results, topology_is_stored_once_for_frames_that_share_it) {
  const RunReader reader(run);
  EXPECT_EQ(reader.frame(0).mesh, reader.frame(2).mesh);
  EXPECT_NE(reader.frame(2).mesh, reader.frame(3).mesh);
  std::map<std::string, std::int64_t> rows;
  for (const DatasetNote& d : reader.datasets()) rows[d.name] = d.rows;
  EXPECT_EQ(rows["/VTKHDF/NumberOfCells"], 2);  // meshes
  EXPECT_EQ(rows["/VTKHDF/Connectivity"], 10 + 8);
  EXPECT_EQ(rows["/VTKHDF/CellData/block_id"], 3 + 2);
  EXPECT_EQ(rows["/VTKHDF/CellData/stress"], 3 * 3 + 2 * 2);  // a frame
  EXPECT_EQ(rows["/VTKHDF/Points"], 5 * 8);
}

TEST_F(Results, principal_stress_tension_positive_has_larger_first) {
  const StoredFrame f = RunReader(run).frame(4);  // (s, -3 s, 0), s = -4e6
  EXPECT_DOUBLE_EQ(f.principal[0], 12e6);
  EXPECT_DOUBLE_EQ(f.principal[1], -4e6);
}

TEST_F(Results, lines_and_cracks_of_joints_read_back) {
  const h5::File file = h5::File::open(run / "run.vtkhdf");
  EXPECT_EQ(h5::read_texts(file, "/joints/name"), (std::vector<std::string>{"rough"}));
  EXPECT_EQ(h5::read<double>(file, "/joints/lines/from"), (std::vector<double>{4.0, 1.0}));
  EXPECT_EQ(h5::read<double>(file, "/joints/lines/to"), (std::vector<double>{6.0, 1.5}));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/joints/lines/kind"), (std::vector<std::int32_t>{2}));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/joints/lines/source"), (std::vector<std::int32_t>{3}));
  EXPECT_EQ(h5::read<double>(file, "/joints/cracks/to"), (std::vector<double>{5.0, 1.25}));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/joints/cracks/block"), (std::vector<std::int32_t>{1}));
}

TEST_F(Results, every_dataset_has_units_and_long_name) {
  const std::vector<DatasetNote> notes = RunReader(run).datasets();
  EXPECT_GT(notes.size(), 60u);
  for (const DatasetNote& d : notes) {
    EXPECT_FALSE(d.units.empty()) << d.name;
    EXPECT_FALSE(d.long_name.empty()) << d.name;
  }
}

TEST_F(Results, ledger_columns_add_up_to_closure) {
  const StoredLedger ledger = RunReader(run).ledger();
  ASSERT_EQ(ledger.columns.size(), static_cast<std::size_t>(coupling::kColumns));
  EXPECT_EQ(ledger.columns.front().name, "kinetic");
  for (std::size_t i = 0; i < ledger.time.size(); ++i) {
    double sum = 0.0;  // E_0 = 0
    for (const StoredLedger::Column& c : ledger.columns)
      sum += (c.side == "energy" || c.side == "dissipated" ? 1.0 : -1.0) * c.value[i];
    EXPECT_DOUBLE_EQ(sum, ledger.closure[i]);
  }
}

TEST_F(Results, monitors_of_one_name_are_both_kept) {
  const std::vector<StoredMonitor> monitors = RunReader(run).monitors();
  ASSERT_EQ(monitors.size(), 2u);
  EXPECT_EQ(monitors[0].name, "crest, left");
  EXPECT_EQ(monitors[1].name, "crest, left_2");
  EXPECT_EQ(monitors[1].time.size(), 5u);
  EXPECT_EQ(monitors[1].velocity[1], 1.0 / 3.0);
}

TEST_F(Results, provenance_names_the_case) {
  const RunReader reader(run);
  EXPECT_EQ(reader.provenance("case_sha256"), sha256("title = \"ä\"\n"));
  EXPECT_EQ(reader.provenance("commit"), "0123abc");
  EXPECT_FALSE(reader.provenance("compiler").empty());
}

TEST_F(Results, last_instant_not_yet_a_frame_is_stored_at_the_end) {
  const Scratch other;
  SmallRun small;
  ResultsSink sink(RunFolder::create(other.path() / "r", false), provenance());
  sink.begin(small.model, small.plan);
  small.use_triangles();
  sink.frame(small.frame(0.0, 0, 0.0, 0.0, 0.0));
  sink.end({coupling::RunEnd::Status::interrupted, "stopped"}, small.frame(0.25, 0, 0.1, 0.0, 0.0));
  EXPECT_EQ(RunReader(other.path() / "r").times(), (std::vector<double>{0.0, 0.25}));
}

TEST_F(Results, run_without_end_reads_back_as_of_its_last_frame) {
  const Scratch other;
  const fs::path folder = other.path() / "r";
  SmallRun small;
  ResultsSink sink(RunFolder::create(folder, false), provenance());
  sink.begin(small.model, small.plan);
  small.use_triangles();
  small.history(sink, 0.0);
  sink.frame(small.frame(0.0, 0, 0.0, 0.0, 0.0));
  small.history(sink, 0.1);                     // buffered
  fs::create_directory(other.path() / "copy");  // what a kill would leave
  fs::copy_file(folder / "run.vtkhdf", other.path() / "copy/run.vtkhdf");
  const RunReader reader(other.path() / "copy");
  EXPECT_EQ(reader.times().size(), 1u);
  EXPECT_EQ(reader.frame(0).cells(), 3u);
  EXPECT_EQ(reader.ledger().time.size(), 1u);
}

TEST_F(Results, frame_at_time_is_the_last_not_after_it) {
  const RunReader reader(run);
  EXPECT_EQ(reader.at_time(-1.0), 0u);
  EXPECT_EQ(reader.at_time(0.7), 1u);
  EXPECT_EQ(reader.at_time(1.0), 3u);
  EXPECT_EQ(reader.at_time(99.0), 4u);
  EXPECT_THROW((void)reader.frame(5), FileError);
}

// --- run.xmf ------------------------------------------------------------------------------------------------------

/// Texts between `before` and `after`, in order.
std::vector<std::string> all_between(const std::string& text, const std::string& before, const std::string& after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

TEST_F(Results, xmf_has_every_frame_and_two_at_one_time_are_a_tick_apart) {
  const std::vector<std::string> values = all_between(text_of(run / "run.xmf"), "<Time Value=\"", "\"");
  std::vector<double> times;
  times.reserve(values.size());
  for (const std::string& v : values) times.push_back(std::strtod(v.c_str(), nullptr));
  ASSERT_EQ(times.size(), 5u);
  EXPECT_EQ(times[1], 0.5);
  EXPECT_LT(times[2], 1.0);
  EXPECT_NEAR(times[2], 1.0, 1.1e-12);
  EXPECT_EQ(times[3], 1.0);
  EXPECT_EQ(times[4], 2.0);
}

TEST_F(Results, xmf_refers_to_datasets_of_the_sizes_that_it_says) {
  const std::string text = text_of(run / "run.xmf");
  const std::vector<std::string> sizes = all_between(text, "Dimensions=\"", "\""),
                                 names = all_between(text, "run.vtkhdf:", "<");
  std::map<std::string, std::int64_t> rows;
  for (const DatasetNote& d : RunReader(run).datasets()) rows[d.name] = d.rows;
  ASSERT_EQ(sizes.size(), names.size());
  EXPECT_EQ(names.size(), 5u * 13u);  // topology, points, 2 fields at points, 9 at cells
  for (std::size_t i = 0; i < names.size(); ++i) {
    ASSERT_EQ(rows.count(names[i]), 1u) << names[i];
    EXPECT_EQ(rows[names[i]], std::atoll(sizes[i].c_str())) << names[i];
  }
}

TEST_F(Results, windows_are_made_once_a_mesh_for_what_does_not_change) {
  std::map<std::string, int> made;
  for (const DatasetNote& d : RunReader(run).datasets()) ++made[d.name.substr(0, d.name.rfind('/'))];
  EXPECT_EQ(made["/xdmf/Points"], 5);
  EXPECT_EQ(made["/xdmf/CellData/stress"], 5);
  EXPECT_EQ(made["/xdmf/CellData/block_id"], 2);
  EXPECT_EQ(made["/xdmf/topology"], 2);
}

TEST_F(Results, xmf_is_whole_at_every_moment_of_a_run) {
  const Scratch other;
  const fs::path folder = other.path() / "r";
  SmallRun small;
  ResultsSink sink(RunFolder::create(folder, false), provenance());
  sink.begin(small.model, small.plan);
  small.use_triangles();
  for (int i = 0; i < 20; ++i) {
    sink.frame(small.frame(0.01 * i, 0, 0.01 * i, 0.0, 0.0));
    const std::string text = text_of(folder / "run.xmf");
    EXPECT_TRUE(text.starts_with("<?xml") && text.ends_with("</Xdmf>\n")) << i;
    EXPECT_FALSE(fs::exists(folder / "run.xmf.tmp"));
  }
  sink.end({}, small.frame(0.2, 0, 0.2, 0.0, 0.0));
  EXPECT_EQ(all_between(text_of(folder / "run.xmf"), "<Time", ">").size(), 21u);
}

TEST_F(Results, displacement_and_velocity_of_cells_are_means_over_them) {
  const StoredFrame f = RunReader(run).frame(1);  // the block is displaced as a whole
  EXPECT_NEAR(f.cell_displacement[2], 0.05, 1e-15);
  EXPECT_NEAR(f.cell_displacement[3], 0.10, 1e-15);
  EXPECT_EQ(f.cell_displacement[0], 0.0);
  EXPECT_EQ(f.cell_velocity[4], 1.0);
}

TEST_F(Results, stages_begin_at_their_first_frames) {
  const std::vector<StoredStage> stages = RunReader(run).stages();
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].name, "shake");
  EXPECT_EQ(stages[0].start, 0.0);
  EXPECT_EQ(stages[1].integrator, "implicit");
  EXPECT_EQ(stages[1].start, 1.0);
}

// --- tables and summary -------------------------------------------------------------------------------------------

TEST_F(Results, csv_has_units_and_reads_back_to_the_same_bits) {
  std::istringstream in(text_of(run / "history.csv"));
  std::string header, row;
  std::getline(in, header);
  std::getline(in, row);
  EXPECT_TRUE(header.starts_with("time [s],\"crest, left.x [m]\",\"crest, left.y [m]\",")) << header;
  EXPECT_EQ(std::strtod(row.substr(row.rfind(',') + 1).c_str(), nullptr), 1.0 / 3.0);
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), 12);
  EXPECT_TRUE(text_of(run / "energy.csv").starts_with("time [s],kinetic [J],elastic [J],"));
}

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

// --- pictures -----------------------------------------------------------------------------------------------------

struct Picture {
  int width = 0, height = 0;
  std::vector<std::array<int, 3>> pixel;

  explicit Picture(const fs::path& png) {
    cairo_surface_t* surface = cairo_image_surface_create_from_png(png.c_str());
    width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const unsigned char* p = data + y * stride + 4 * x;
        pixel.push_back({p[2], p[1], p[0]});
      }
    cairo_surface_destroy(surface);
  }
  /// Fraction of pixels within 3 of a colour.
  [[nodiscard]] double share(const std::array<int, 3>& rgb) const {
    const auto near = [&](const auto& p) {
      return std::abs(p[0] - rgb[0]) <= 3 && std::abs(p[1] - rgb[1]) <= 3 && std::abs(p[2] - rgb[2]) <= 3;
    };
    return static_cast<double>(std::count_if(pixel.begin(), pixel.end(), near)) / static_cast<double>(pixel.size());
  }
};

TEST_F(Results, snapshot_has_width_asked_and_colours_of_the_field) {
  const fs::path png = scratch->path() / "u.png";
  SnapshotOptions options;
  options.width = 840;
  snapshot(run, options, png);
  const Picture picture(png);
  EXPECT_EQ(picture.width, 840);
  EXPECT_GT(picture.height, 250);
  EXPECT_GT(picture.share({253, 231, 37}), 0.015);  // the block: the largest displacement, viridis at 1
  EXPECT_GT(picture.share({231, 230, 227}), 0.1);   // the held base: grey
  EXPECT_LT(picture.share({68, 1, 84}), 0.01);      // viridis at 0 only in the colour bar
}

TEST_F(Results, snapshot_of_signed_stress_has_blue_for_compression) {
  SnapshotOptions options;
  options.field = Field::sxx;
  snapshot(run, options, scratch->path() / "compression.png");  // last frame: -4 MPa
  options.time = 0.5;
  snapshot(run, options, scratch->path() / "tension.png");  // 0.5 MPa
  const Picture compression(scratch->path() / "compression.png"), tension(scratch->path() / "tension.png");
  const std::array<int, 3> blue{5, 48, 97}, red{103, 0, 31};
  EXPECT_GT(compression.share(blue), 10.0 * compression.share(red));
  EXPECT_GT(tension.share(red), 10.0 * tension.share(blue));
}

TEST_F(Results, snapshot_of_every_field_is_drawn) {
  for (const std::string& name : field_names()) {
    SnapshotOptions options;
    options.field = field_named(name).value();
    options.frame = 1;
    options.width = 420;
    const fs::path png = scratch->path() / (name + ".png");
    snapshot(run, options, png);
    EXPECT_EQ(Picture(png).width, 420) << name;
  }
  EXPECT_FALSE(field_named("temperature"));
}

TEST_F(Results, snapshot_of_frame_that_is_not_there_gives_file_error_and_no_picture) {
  SnapshotOptions options;
  options.frame = 7;
  EXPECT_THROW(snapshot(run, options, scratch->path() / "none.png"), FileError);
  EXPECT_FALSE(fs::exists(scratch->path() / "none.png"));
  EXPECT_THROW(snapshot(run, {}, scratch->path() / "no/such/folder.png"), FileError);
}

TEST_F(Results, ledger_plot_draws_a_line_a_column_that_is_not_zero) {
  const fs::path png = scratch->path() / "ledger.png";
  plot_ledger(run, png);
  const Picture picture(png);
  EXPECT_EQ(picture.width, 1680);
  for (const std::array<int, 3>& colour : {std::array{0, 114, 178}, {230, 159, 0}, {0, 158, 115}})
    EXPECT_GT(picture.share(colour), 5e-4);
  EXPECT_LT(picture.share({204, 121, 167}), 1e-5);  // a fourth column would have this one
}

TEST_F(Results, snapshot_as_pdf_and_svg_is_of_that_kind_and_keeps_the_letters) {
  SnapshotOptions options;
  options.arrows = Arrows::displacement;
  snapshot(run, options, scratch->path() / "u.pdf");
  snapshot(run, options, scratch->path() / "u.svg");
  plot_ledger(run, scratch->path() / "ledger.pdf");
  const std::string pdf = text_of(scratch->path() / "u.pdf"), svg = text_of(scratch->path() / "u.svg");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
  EXPECT_NE(pdf.find("/FontFile"), std::string::npos);        // letters, not pictures of them
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);  // nothing turned to pixels
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("width=\"504pt\""), std::string::npos);  // 7 inches
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_TRUE(text_of(scratch->path() / "ledger.pdf").starts_with("%PDF-"));
  EXPECT_THROW(snapshot(run, options, scratch->path() / "u.jpg"), FileError);
  EXPECT_FALSE(fs::exists(scratch->path() / "u.jpg"));
}

TEST_F(Results, snapshot_with_fixed_range_colours_by_it) {
  SnapshotOptions options;
  options.field = Field::sxx;
  options.frame = 4;  // -4 MPa
  options.range = {-8e6, 8e6};
  snapshot(run, options, scratch->path() / "half.png");
  EXPECT_GT(Picture(scratch->path() / "half.png").share({106, 172, 208}), 0.005);  // half way to the blue end
  options.range = {-4e6, 1e6};  // white is still zero: the block has the end colour
  snapshot(run, options, scratch->path() / "end.png");
  EXPECT_GT(Picture(scratch->path() / "end.png").share({5, 48, 97}), 0.005);
  EXPECT_LT(Picture(scratch->path() / "end.png").share({103, 0, 31}), 1e-4);  // the red end is not reached
}

TEST_F(Results, arrows_and_names_add_ink_to_the_blocks) {
  SnapshotOptions options;
  options.frame = 2;
  const fs::path png = scratch->path() / "marks.png";
  const auto black = [&] {
    snapshot(run, options, png);
    return Picture(png).share({0, 0, 0});
  };
  const double plain = black();
  options.arrows = Arrows::velocity;
  EXPECT_GT(black(), plain + 5e-5);
  options.arrows = Arrows::none;
  const auto dark = [&] {
    snapshot(run, options, png);
    return Picture(png).share({33, 33, 33});
  };
  const double before = dark();
  options.labels = true;
  EXPECT_GT(dark(), before + 2e-5);
}

TEST_F(Results, history_plot_draws_a_line_a_monitor_and_knows_their_names) {
  const fs::path png = scratch->path() / "history.png";
  plot_history(run, {}, png);
  const Picture all(png);
  EXPECT_EQ(all.width, 1680);
  EXPECT_GT(all.share({230, 159, 0}), 1e-4);  // the second monitor
  plot_history(run, {"crest, left_2"}, png);
  const Picture one(png);
  EXPECT_GT(one.share({0, 114, 178}), 1e-4);
  EXPECT_LT(one.share({230, 159, 0}), 1e-6);
  try {
    plot_history(run, {"toe"}, png);
    FAIL() << "no FileError";
  } catch (const FileError& e) {
    EXPECT_NE(e.reason.find("no monitor toe; there are crest, left"), std::string::npos) << e.reason;
  }
}

TEST(Ticks, round_ticks_lie_inside_and_share_their_digits) {
  const Ticks t = round_ticks(-0.13, 0.42, 5);
  EXPECT_EQ(t.label, (std::vector<std::string>{"−0.1", "0.0", "0.1", "0.2", "0.3", "0.4"}));
  for (const double scale : {1e-9, 3e-4, 1.0, 7.0, 2.5e6})
    for (const double at : {-1.0, 0.0, 10.0}) {
      const Ticks s = round_ticks(at * scale, (at + 1.0) * scale, 5);
      EXPECT_GE(s.at.size(), 3u);
      EXPECT_EQ(std::set<std::string>(s.label.begin(), s.label.end()).size(), s.label.size());
      EXPECT_GE(s.at.front(), at * scale - 1e-8 * scale);
      EXPECT_LE(s.at.back(), (at + 1.0) * scale + 1e-8 * scale);
    }
}

TEST(Ticks, prefix_brings_the_largest_between_one_and_a_thousand) {
  EXPECT_EQ(prefixed("Pa", 2.5e6).name, "MPa");
  EXPECT_EQ(prefixed("Pa", 12.0).name, "Pa");
  EXPECT_EQ(prefixed("m", 0.02).name, "mm");
  EXPECT_EQ(prefixed("m", 4000.0).name, "m");
}

}  // namespace
}  // namespace scree::io
