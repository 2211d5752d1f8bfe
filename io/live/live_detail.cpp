#include "io/live/live_detail.h"

#include <algorithm>
#include <cmath>

namespace scree::io {
namespace {

constexpr std::uint8_t kFailed = 4;  // flag added to the state

float near(double value, double base) { return static_cast<float>(value - base); }

void set_counts(detail_v1_t& out) {
  out.contacts = static_cast<std::int32_t>(out.state.size());
  out.cells = static_cast<std::int32_t>(out.xx.size());
  out.nodes = static_cast<std::int32_t>(out.bolt.size());
}

void add_place(detail_v1_t& out, double x, double y, double nx, double ny) {
  out.x.push_back(near(x, out.base[0])), out.y.push_back(near(y, out.base[1]));
  out.nx.push_back(static_cast<float>(nx)), out.ny.push_back(static_cast<float>(ny));
}

void add_force(detail_v1_t& out, double fn, double ft, double slip) {
  out.fn.push_back(static_cast<float>(fn)), out.ft.push_back(static_cast<float>(ft));
  out.slip.push_back(static_cast<float>(slip));
}

void add_stress(detail_v1_t& out, std::span<const double> stress) {
  for (std::size_t i = 0; i + 2 < stress.size(); i += 3) {
    out.xx.push_back(static_cast<float>(stress[i]));
    out.yy.push_back(static_cast<float>(stress[i + 1]));
    out.xy.push_back(static_cast<float>(stress[i + 2]));
  }
}

void add_nodes(detail_v1_t& out, std::span<const std::int32_t> bolt, std::span<const double> position,
               std::span<const double> force) {
  for (std::size_t i = 0; i < bolt.size(); ++i) {
    out.node_x.push_back(near(position[2 * i], out.base[0])),
        out.node_y.push_back(near(position[2 * i + 1], out.base[1]));
    out.node_force.push_back(static_cast<float>(force[i]));
    out.bolt.push_back(bolt[i]);
  }
}

}  // namespace

detail_v1_t live_detail(const coupling::FrameView& frame, const std::array<double, 2>& base) {
  detail_v1_t out{};
  out.base[0] = base[0], out.base[1] = base[1];
  const coupling::ContactView* contacts = frame.contacts;
  if (contacts != nullptr)
    for (std::size_t i = 0; i < contacts->memory.size(); ++i) {
      const coupling::ContactMemory& m = contacts->memory[i];
      if (m.status == coupling::ContactStatus::open) continue;
      add_place(out, contacts->position[2 * i], contacts->position[2 * i + 1], contacts->normal[2 * i],
                contacts->normal[2 * i + 1]);
      add_force(out, m.fn, m.ft, m.slip);
      out.corner.push_back(m.key.block_p), out.edge.push_back(m.key.block_e), out.law.push_back(m.joint);
      out.state.push_back(static_cast<std::uint8_t>(static_cast<int>(m.status) | (m.failed ? kFailed : 0)));
    }
  add_stress(out, frame.stress);
  if (frame.bolts != nullptr) add_nodes(out, frame.bolts->bolt, frame.bolts->position, frame.bolts->node_force);
  set_counts(out);
  return out;
}

detail_v1_t live_detail(const RunReader& run, const StoredFrame& frame, const std::array<double, 2>& base) {
  detail_v1_t out{};
  out.base[0] = base[0], out.base[1] = base[1];
  const auto index = static_cast<std::size_t>(frame.index);
  const StoredContacts c = run.has_contacts() ? run.contacts(index) : StoredContacts{};
  for (std::size_t i = 0; i < c.state.size(); ++i) {
    if (c.state[i] == 0) continue;
    add_place(out, c.position[2 * i], c.position[2 * i + 1], c.normal[2 * i], c.normal[2 * i + 1]);
    add_force(out, c.fn[i], c.ft[i], c.slip[i]);
    out.corner.push_back(c.corner_block[i]), out.edge.push_back(c.edge_block[i]), out.law.push_back(c.law[i]);
    out.state.push_back(static_cast<std::uint8_t>(c.state[i] | (c.failed[i] != 0 ? kFailed : 0)));
  }
  add_stress(out, frame.stress);
  const StoredBolts bolts = run.bolts(index);
  add_nodes(out, bolts.bolt, bolts.position, bolts.force);
  set_counts(out);
  return out;
}

double size_of(const detail_v1_t& detail) { return static_cast<double>(detail.getEncodedSize()); }

bool holds_together(const detail_v1_t& d, const LiveMesh& mesh) {
  const auto counts = [](const std::vector<std::int32_t>& values, std::int32_t low) {
    return std::all_of(values.begin(), values.end(), [low](std::int32_t v) { return v >= low; });
  };
  const bool states = std::all_of(d.state.begin(), d.state.end(),
                                  [](std::uint8_t s) { return (s & ~kFailed) == 1 || (s & ~kFailed) == 2; });
  return states && counts(d.corner, 0) && counts(d.edge, 0) && counts(d.law, -1) && counts(d.bolt, 0) &&
         std::isfinite(d.base[0]) && std::isfinite(d.base[1]) &&
         (d.cells == 0 || static_cast<std::size_t>(d.cells) == mesh.cells());
}

}  // namespace scree::io
