// A small synthetic run that is written by the results sink.
#pragma once

#include <cairo/cairo.h>
#include <gtest/gtest.h>

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
#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "io/results/sha256.h"

namespace scree::io::test {

namespace fs = std::filesystem;
using coupling::Column;
using coupling::Integrator;

/// A separate folder for each test, removed at its end.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "scree-results-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Scratch() {
    std::error_code ignored;  // a folder that remains is not a failure of the test
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

inline std::string text_of(const fs::path& file) {
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
    mesh.methods = {"dda"};  // numbered separately in each mesh
    use(2);
  }
  /// The base in 40 cells that share no points: too many numbers to be stored in the text of run.xmf.
  void use_many() {
    offsets = {0}, connectivity.clear(), block.clear();
    std::vector<double> points;
    for (std::int32_t c = 0; c < 40; ++c) {
      const double x = c / 4.0, y = (c + 1) / 4.0;
      points.insert(points.end(), {x, -2, y, -2, y, 0, x, 0});
      for (std::int32_t i = 0; i < 4; ++i) connectivity.push_back(4 * c + i);
      offsets.push_back(4 * (c + 1));
      block.push_back(0);
    }
    material.assign(block.size(), 0), method = material;
    mesh.methods = {"nmm"};
    use(3, std::move(points));
  }
  void use(std::uint32_t id) { use(id, {0, -2, 10, -2, 10, 0, 0, 0, 4, 0, 6, 0, 6, 2, 4, 2}); }
  void use(std::uint32_t id, std::vector<double> points) {
    origin = std::move(points);
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
    const std::array<double, 6> s{-1e6 * time, -2e6, 1e5 / 3.0, 4e6, 5e6 * time, 6e6};
    coupling::HistoryView h;
    h.time = time, h.tick = ticks(time);
    h.position = x, h.displacement = u, h.velocity = v, h.stress = s;
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

inline Provenance provenance() {
  Provenance p;
  p.version = "1.2.3", p.commit = "0123abc", p.case_text = "title = \"ä\"\n", p.command_line = "scree run case.toml",
  p.threads = 3;
  return p;
}

/// The small run in a folder, written once.
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

}  // namespace scree::io::test
