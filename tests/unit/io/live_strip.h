// A moving strip of cells with the views that a driver provides, and buses for its messages.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/live/live_publisher.h"
#include "io/live/live_sink.h"

namespace scree::io::test {

using coupling::FrameView;
using coupling::MeshView;

/// A moving strip of n quadrilaterals with the views that a driver provides.
struct Strip {
  std::vector<double> origin, position, velocity, stress;
  std::vector<std::int32_t> offsets{0}, connectivity, block, material, method;
  MeshView mesh;
  FrameView frame;
  coupling::RunStats stats;
  coupling::State state;

  explicit Strip(std::int32_t cells, std::uint32_t id = 7) {
    for (std::int32_t i = 0; i <= cells; ++i)
      for (int j = 0; j < 2; ++j) origin.insert(origin.end(), {5.0e5 + 0.1 * i, 4.0e6 + 0.1 * j});  // from a survey
    for (std::int32_t c = 0; c < cells; ++c) {
      for (const std::int32_t p : {2 * c, 2 * c + 2, 2 * c + 3, 2 * c + 1}) connectivity.push_back(p);
      offsets.push_back(4 * (c + 1));
      block.push_back(c / 3);
      material.push_back(c % 2);
      method.push_back(c % 2);
    }
    mesh.id = id;
    mesh.offsets = offsets;
    mesh.connectivity = connectivity;
    mesh.cell_block = block;
    mesh.cell_material = material;
    mesh.cell_method = method;
    mesh.origin = origin;
    mesh.methods = {"nmm", "dda"};
    move(0.0);
  }
  Strip(const Strip&) = delete;
  Strip& operator=(const Strip&) = delete;

  void move(double t) {
    position = origin;
    velocity.clear();
    for (std::size_t p = 0; p < origin.size() / 2; ++p) {
      const double phase = 0.37 * static_cast<double>(p);
      position[2 * p] += t * std::sin(phase);
      position[2 * p + 1] -= 2.0 * t * std::cos(phase);
      velocity.insert(velocity.end(), {std::sin(phase), -2.0 * std::cos(phase)});
    }
    stress.assign(3 * block.size(), 0.0);
    for (std::size_t c = 0; c < block.size(); ++c)
      stress[3 * c] = -1000.0 * static_cast<double>(c), stress[3 * c + 1] = 500.0;
    frame.time = t;
    frame.end_time = 10.0;
    frame.step = static_cast<std::int64_t>(1000 * t);
    frame.stage_name = "only";
    frame.position = position;
    frame.velocity = velocity;
    frame.stress = stress;
    frame.mesh = &mesh;
    frame.stats = &stats;
    frame.state = &state;
    stats.steps = frame.step;
    state.ledger.set(coupling::Column::kinetic, 12.5 * t);
  }
};

inline Model model_with_monitors(int count) {
  Model model;
  model.title = "a strip";
  for (int i = 0; i < count; ++i) model.monitors.push_back({"m" + std::to_string(i), BlockId(0), {0.0, 0.0}});
  return model;
}

inline coupling::Plan plan_at(double rate) {
  coupling::Plan plan;
  plan.live.enabled = true;
  plan.live.url = "memq://";
  plan.live.rate = rate;
  plan.stages.emplace_back();
  plan.stages[0].duration = ticks(10.0);
  return plan;
}

inline std::shared_ptr<LiveBus> memory_bus() {
  std::string why;
  return LiveBus::open("memq://", LiveSide::sender, why);
}

/// Records every message of a sink on a separate bus.
struct Recorder {
  std::shared_ptr<LiveBus> bus = memory_bus();
  std::vector<std::pair<std::string, Bytes>> messages;

  Recorder() {
    bus->subscribe("SCREE_.*", [this](std::string_view channel, std::span<const std::uint8_t> bytes) {
      messages.emplace_back(channel, Bytes(bytes.begin(), bytes.end()));
    });
  }
  void drain() {
    while (bus->handle(0) == LiveBus::Got::message) {
    }
  }
};

/// All messages of a short run. The mesh begins at t = 0; only the last frame is sent.
inline std::vector<std::pair<std::string, Bytes>> short_run(Strip& strip, double t) {
  Recorder recorder;
  LiveSink sink(plan_at(0.0).live, {"short"}, {}, recorder.bus);
  sink.begin(model_with_monitors(2), plan_at(0.0));
  strip.move(0.0);
  sink.frame(strip.frame);
  strip.move(t);
  sink.event({coupling::EventKind::stage_start, 0.0, "only", nullptr});
  sink.end({}, strip.frame);
  recorder.drain();
  return recorder.messages;
}

/// Strip whose blocks share no points, like DDA and NMM bodies: `blocks` blocks of `cells` quadrilaterals each.
struct Blocks {
  std::vector<double> origin, position, velocity, stress;
  std::vector<std::int32_t> offsets{0}, connectivity, block, zero;
  MeshView mesh;
  FrameView frame;

  Blocks(std::int32_t blocks, std::int32_t cells) {
    for (std::int32_t b = 0; b < blocks; ++b) {
      const auto first = static_cast<std::int32_t>(origin.size() / 2);
      for (std::int32_t i = 0; i <= cells; ++i)
        for (int j = 0; j < 2; ++j) origin.insert(origin.end(), {5.0e5 + 4.0 * b + 3.0 * i / cells, 4.0e6 + 2.0 * j});
      for (std::int32_t c = 0; c < cells; ++c) {
        for (const std::int32_t p : {2 * c, 2 * c + 2, 2 * c + 3, 2 * c + 1}) connectivity.push_back(first + p);
        offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
        block.push_back(100 - b);  // numbers not ascending
      }
    }
    zero.assign(block.size(), 0);
    velocity.assign(origin.size(), 0.0);
    stress.assign(3 * block.size(), 0.0);
    mesh.id = 3;
    mesh.offsets = offsets;
    mesh.connectivity = connectivity;
    mesh.cell_block = block;
    mesh.cell_material = zero;
    mesh.cell_method = zero;
    mesh.origin = origin;
    mesh.methods = {"any"};
    move([](std::size_t, double x, double y) { return std::array{x, y}; });
  }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;
  template <class Where>
  void move(Where&& where) {
    position.resize(origin.size());
    for (std::size_t p = 0; p < origin.size() / 2; ++p) {
      const auto [x, y] = where(p, origin[2 * p] - 5.0e5, origin[2 * p + 1] - 4.0e6);
      position[2 * p] = 5.0e5 + x;
      position[2 * p + 1] = 4.0e6 + y;
    }
    frame.position = position;
    frame.velocity = velocity;
    frame.stress = stress;
    frame.mesh = &mesh;
  }
  [[nodiscard]] LiveFrame live(const std::shared_ptr<const LiveMesh>& its_mesh) const {
    LiveFrame f;
    f.mesh = its_mesh;
    f.header.topology_id = 3;
    f.position = position;
    f.scalar.assign(block.size(), 0.0F);
    return f;
  }
};

}  // namespace scree::io::test
