// Results: a small synthetic run is written by the sink and read back.
#include <cairo/cairo.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "io/pictures/snapshot.h"
#include "io/pictures/ticks.h"
#include "io/results/h5_read.h"
#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "io/results/sha256.h"
#include "io/watch/dashboard_source.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::results_test {
namespace {

using namespace test;

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
  EXPECT_EQ(rows["/VTKHDF/CellData/stress"], 3 * 3 + 2 * 2);  // per frame
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

TEST_F(Results, contacts_are_there_only_where_asked_for) {
  EXPECT_FALSE(h5::File::open(run / "run.vtkhdf").has("/contacts"));
}

TEST(ContactResults, rows_of_a_frame_are_those_it_showed) {
  const Scratch scratch;
  SmallRun small;
  small.plan.output.contacts = true;
  ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
  sink.begin(small.model, small.plan);
  small.use_triangles();
  sink.topology(small.mesh);
  const std::array<std::size_t, 4> counts{2, 0, 3, 1};
  std::vector<coupling::ContactMemory> memory;
  std::vector<double> position, normal;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    memory.assign(counts[k], {});
    position.clear(), normal.clear();
    for (std::size_t i = 0; i < counts[k]; ++i) {
      const auto x = static_cast<double>(10 * k + i);
      coupling::ContactMemory& m = memory[i];
      m.key = {1, 0, static_cast<std::int32_t>(k), static_cast<std::int32_t>(i), 0, 2, 3};
      m.status = coupling::ContactStatus::stick;
      m.joint = 0, m.failed = 1, m.tributary = x + 0.125, m.gap = -x, m.gap0 = 2.0 * x, m.fn = 3.0 * x, m.ft = -4.0 * x;
      m.slip = 5.0 * x, m.water = 6.0 * x;
      position.insert(position.end(), {x, -x});
      normal.insert(normal.end(), {0.6, 0.8});
    }
    const coupling::ContactView view{position, normal, memory};
    coupling::FrameView frame = small.frame(0.25 * static_cast<double>(k), 0, 0.0, 0.0, 0.0);
    frame.contacts = &view;
    if (k + 1 < counts.size())
      sink.frame(frame);
    else
      sink.end({}, frame);  // the end of the run is also a frame
  }
  const h5::File file = h5::File::open(scratch.path() / "run" / "run.vtkhdf");
  EXPECT_EQ(h5::read<std::int64_t>(file, "/contacts/frames/first"), (std::vector<std::int64_t>{0, 2, 2, 5}));
  EXPECT_EQ(h5::read<std::int64_t>(file, "/contacts/frames/count"), (std::vector<std::int64_t>{2, 0, 3, 1}));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/contacts/corner", 3, 2),
            (std::vector<std::int32_t>{1, 0, 2, 1, 1, 0, 2, 2}));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/contacts/edge", 5, 1), (std::vector<std::int32_t>{0, 2, 3}));
  EXPECT_EQ(h5::read<double>(file, "/contacts/position", 4, 1), (std::vector<double>{22.0, -22.0}));
  EXPECT_EQ(h5::read<double>(file, "/contacts/normal", 0, 1), (std::vector<double>{0.6, 0.8}));
  const double at_22[] = {22.125, -22.0, 44.0, 66.0, -88.0, 110.0, 132.0};
  const char* names[] = {"share", "gap", "gap0", "fn", "ft", "slip", "water"};
  for (std::size_t n = 0; n < std::size(names); ++n)
    EXPECT_EQ(h5::read<double>(file, std::string("/contacts/") + names[n], 4, 1).front(), at_22[n]) << names[n];
  EXPECT_EQ(h5::read<std::int32_t>(file, "/contacts/state"), (std::vector<std::int32_t>(6, 2)));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/contacts/failed"), (std::vector<std::int32_t>(6, 1)));
  EXPECT_EQ(h5::read<std::int32_t>(file, "/contacts/bonded"), (std::vector<std::int32_t>(6, 0)));
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
  ASSERT_EQ(monitors[1].stress.size(), 15u);  // xx, yy, xy per time
  EXPECT_EQ(monitors[0].stress[1], -2e6);
  EXPECT_EQ(monitors[1].stress[13], 5e6 * 2.0);
}

TEST_F(Results, provenance_names_the_case) {
  const RunReader reader(run);
  EXPECT_EQ(reader.provenance("case_sha256"), sha256("title = \"ä\"\n"));
  EXPECT_EQ(reader.provenance("commit"), "0123abc");
  EXPECT_FALSE(reader.provenance("compiler").empty());
}

TEST_F(Results, positions_have_their_origin_beside_them) {
  const Scratch other;
  const fs::path folder = other.path() / "survey";
  SmallRun small;
  small.model.origin = {500000.0, -4.0e6};
  ResultsSink sink(RunFolder::create(folder, false), provenance());
  small.play(sink);
  const RunReader far(folder), near(run);
  EXPECT_EQ(far.origin(), Vec2(500000.0, -4.0e6));
  EXPECT_EQ(near.origin(), Vec2(0.0, 0.0));
  EXPECT_EQ(far.frame(0).position, near.frame(0).position) << "positions stay local";
  EXPECT_EQ(far.blocks()[1].polygon.outer, near.blocks()[1].polygon.outer);
  std::string summary = text_of(folder / "summary.json");
  std::erase_if(summary, [](char c) { return c == ' ' || c == '\n'; });
  EXPECT_NE(summary.find("\"origin\":[500000.0,-4000000.0]"), std::string::npos) << summary;
  EXPECT_EQ(stored_dashboard(folder).monitors.at(0).x, 500004.0) << "people see where the case has it";

  snapshot(folder, {}, other.path() / "far.svg");
  snapshot(run, {}, other.path() / "near.svg");
  EXPECT_NE(text_of(other.path() / "far.svg"), text_of(other.path() / "near.svg")) << "its axes say what they count";
}

TEST_F(Results, origin_of_a_file_without_one_is_zero_and_one_that_is_no_pair_is_refused) {
  const Scratch other;
  const h5::File file = h5::File::create(other.path() / "old.h5");
  EXPECT_EQ(h5::pair_attribute(file, "/", "origin"), (std::array{0.0, 0.0}));
  file.attribute("/", "origin", 3.0);
  EXPECT_THROW((void)h5::pair_attribute(file, "/", "origin"), FileError);
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
  fs::create_directory(other.path() / "copy");  // files as after a kill
  fs::copy_file(folder / "run.vtkhdf", other.path() / "copy/run.vtkhdf");
  const RunReader reader(other.path() / "copy");
  EXPECT_EQ(reader.times().size(), 1u);
  EXPECT_EQ(reader.frame(0).cells(), 3u);
  EXPECT_EQ(reader.ledger().time.size(), 1u);
}

TEST_F(Results, sink_of_a_run_that_ended_by_an_exception_keeps_what_it_had) {
  const Scratch other;
  const fs::path folder = other.path() / "r";
  SmallRun small;
  {
    ResultsSink sink(RunFolder::create(folder, false), provenance());
    sink.begin(small.model, small.plan);
    small.use_triangles();
    for (int k = 0; k < 3; ++k) {
      small.history(sink, 0.1 * k);
      sink.frame(small.frame(0.1 * k, 0, 0.0, 0.0, 0.0));
    }
    EXPECT_EQ(RunReader(folder).times().size(), 1u) << "brought out by time: nothing is tested";
  }
  EXPECT_EQ(RunReader(folder).times().size(), 3u);
  EXPECT_EQ(RunReader(folder).ledger().time.size(), 3u);
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

/// An array of run.xmf: its numbers, from the text or from the file it refers to.
struct XmfArray {
  std::string dimensions, path;  // path: empty if the numbers are in the text
  std::vector<double> numbers;
};
std::vector<XmfArray> xmf_arrays(const fs::path& run) {
  std::vector<XmfArray> found;
  const h5::File file = h5::File::open(run / "run.vtkhdf");
  for (const std::string& item : all_between(text_of(run / "run.xmf"), "<DataItem ", "</DataItem>")) {
    XmfArray a;
    a.dimensions = all_between(item, "Dimensions=\"", "\"").front();
    std::string text = item.substr(item.find('>') + 1);
    if (item.starts_with("Format=\"HDF\"")) {
      a.path = text.substr(text.find(':') + 1);
      if (item.find("\"Int\"") == item.npos) a.numbers = h5::read<double>(file, a.path);
    } else {
      std::istringstream words(text);
      for (std::string word; words >> word;) a.numbers.push_back(std::strtod(word.c_str(), nullptr));
    }
    found.push_back(a);
  }
  return found;
}

TEST_F(Results, xmf_holds_short_arrays_itself_and_refers_to_what_stays_the_same) {
  const std::vector<XmfArray> arrays = xmf_arrays(run);
  ASSERT_EQ(arrays.size(), 5u * 13u);  // topology, points, 2 fields at points, 9 at cells
  const RunReader reader(run);
  std::map<std::string, std::int64_t> rows;
  for (const DatasetNote& d : reader.datasets()) rows[d.name] = d.rows;
  for (std::size_t k = 0; k < 5; ++k) {
    const XmfArray& points = arrays[13 * k + 1];
    const XmfArray& stress = arrays[13 * k + 11];
    const StoredFrame frame = reader.frame(k);
    EXPECT_EQ(points.dimensions, "8 3");
    ASSERT_EQ(points.numbers.size(), 24u);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(points.numbers[3 * i], frame.position[2 * i]);
      EXPECT_EQ(points.numbers[3 * i + 1], frame.position[2 * i + 1]);
    }
    EXPECT_EQ(stress.numbers, frame.stress);
    for (std::size_t i = 0; i < 13; ++i) {
      const XmfArray& a = arrays[13 * k + i];
      const bool of_mesh = i == 0 || (i >= 4 && i < 9);
      EXPECT_EQ(a.path.empty(), !of_mesh) << i;
      if (of_mesh) {
        EXPECT_EQ(rows.at(a.path), std::atoll(a.dimensions.c_str())) << a.path;
      }
    }
  }
}

TEST_F(Results, xmf_refers_to_windows_of_long_arrays) {
  const Scratch other;
  const fs::path folder = other.path() / "r";
  SmallRun small;
  {
    ResultsSink sink(RunFolder::create(folder, false), provenance());
    sink.begin(small.model, small.plan);
    small.use_many();
    for (int k = 0; k < 3; ++k) sink.frame(small.frame(0.1 * k, 0, 0.1 * k, 1.0 * k, 1e6 * k));
    sink.end({}, small.frame(0.2, 0, 0.2, 2.0, 2e6));
  }
  const std::vector<XmfArray> arrays = xmf_arrays(folder);
  ASSERT_EQ(arrays.size(), 3u * 13u);
  const RunReader reader(folder);
  std::map<std::string, int> made;
  for (const DatasetNote& d : reader.datasets()) ++made[d.name.substr(0, d.name.rfind('/'))];
  EXPECT_EQ(made["/xdmf/Points/0"], 3);
  EXPECT_EQ(made["/xdmf/CellData/stress/0"], 3);
  EXPECT_EQ(made["/xdmf/CellData/principal_stress/0"], 0) << "80 numbers";
  EXPECT_EQ(made["/xdmf/CellData/block_id/0"], 1);
  EXPECT_EQ(made["/xdmf/topology"], 1);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(arrays[13 * k + 1].path, "/xdmf/Points/0/" + std::to_string(k));
    EXPECT_EQ(arrays[13 * k + 11].numbers, reader.frame(k).stress);
    EXPECT_EQ(arrays[13 * k + 3].numbers[12], reader.frame(k).velocity[8]);
  }
}

TEST_F(Results, windows_are_made_once_a_mesh_for_what_does_not_change) {
  std::map<std::string, int> made;
  for (const DatasetNote& d : RunReader(run).datasets()) ++made[d.name.substr(0, d.name.rfind('/'))];
  EXPECT_EQ(made["/xdmf/CellData/block_id/0"], 2);
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
  EXPECT_TRUE(
      header.ends_with("\"crest, left_2.vy [m/s]\",\"crest, left_2.sxx [Pa]\",\"crest, left_2.syy [Pa]\","
                       "\"crest, left_2.sxy [Pa]\""))
      << header;
  std::vector<double> numbers;
  for (std::istringstream fields(row); std::getline(fields, row, ',');)
    numbers.push_back(std::strtod(row.c_str(), nullptr));
  ASSERT_EQ(numbers.size(), 19u);
  EXPECT_EQ(numbers[9], 1e5 / 3.0);   // sxy of the first
  EXPECT_EQ(numbers[15], 1.0 / 3.0);  // vy of the second
  EXPECT_EQ(numbers[18], 6e6);
  EXPECT_TRUE(text_of(run / "energy.csv").starts_with("time [s],kinetic [J],elastic [J],"));
}

TEST(Outcome, a_summary_with_a_number_that_is_not_finite_does_not_say_done) {
  // Each non-finite number is set where no step checks it; a run that ended for another reason keeps that reason.
  enum class Planted { nothing, travel, ledger, position };
  for (const Planted planted : {Planted::nothing, Planted::travel, Planted::ledger, Planted::position})
    for (const auto status : {coupling::RunEnd::Status::done, coupling::RunEnd::Status::interrupted}) {
      const Scratch scratch;
      SmallRun small;
      small.use_triangles();
      ResultsSink sink(RunFolder::create(scratch.path() / "run", false), {});
      sink.begin(small.model, small.plan);
      sink.topology(small.mesh);
      const double none = std::numeric_limits<double>::quiet_NaN();
      const coupling::StageTravel travel{"s", BlockId{1}, planted == Planted::travel ? none : 1.0};
      sink.event({coupling::EventKind::stage_end, 0.0, "done", nullptr, &travel});
      if (planted == Planted::ledger) small.state.ledger.book(Column::friction, none);
      const coupling::FrameView last = small.frame(0.1, 0, planted == Planted::position ? none : 0.01, 0.0, 1e5);
      sink.end({status, status == coupling::RunEnd::Status::done ? "" : "stopped"}, last);
      const std::string text = text_of(scratch.path() / "run" / "summary.json");
      const bool wrong = planted != Planted::nothing && status == coupling::RunEnd::Status::done;
      EXPECT_EQ(sink.outcome().status, wrong ? coupling::RunEnd::Status::non_finite : status);
      EXPECT_EQ(text.find("\"status\": \"non_finite\"") != std::string::npos, wrong) << text;
      if (wrong) {
        const char* field = planted == Planted::travel   ? "'farthest_displacement'"
                            : planted == Planted::ledger ? "'friction'"
                                                         : "'displacement'";
        EXPECT_NE(sink.outcome().reason.find(field), std::string::npos) << sink.outcome().reason;
      }
    }
}

}  // namespace
}  // namespace scree::io::results_test
