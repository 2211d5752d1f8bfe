#include "io/live/encode.h"

#include <algorithm>
#include <scree/energy_v1_t.hpp>
#include <scree/event_v1_t.hpp>
#include <scree/hist_v1_t.hpp>
#include <scree/mesh_v1_t.hpp>
#include <scree/state_v1_t.hpp>
#include <scree/topo_v1_t.hpp>

#include "io/live/affine_map.h"
#include "io/live/quantise.h"
#include "io/live/send_pieces.h"
#include "model/check.h"

namespace scree::io {
namespace {

std::string_view side_name(coupling::Side side) {
  switch (side) {
    case coupling::Side::energy:
      return "energy";
    case coupling::Side::work:
      return "work";
    case coupling::Side::dissipated:
      return "dissipated";
    case coupling::Side::scheme:
      return "scheme";
  }
  return "";
}

}  // namespace

Bytes encode_mesh(const LiveMesh& mesh) {
  mesh_v1_t out{};
  out.id = mesh.id;
  out.base[0] = mesh.base[0];
  out.base[1] = mesh.base[1];
  out.points = static_cast<std::int32_t>(mesh.points());
  out.origin_x = mesh.origin_x;
  out.origin_y = mesh.origin_y;
  out.start_x = mesh.start_x;
  out.start_y = mesh.start_y;
  out.cells = static_cast<std::int32_t>(mesh.cells());
  for (std::size_t c = 0; c < mesh.cells(); ++c) out.corners.push_back(mesh.offsets[c + 1] - mesh.offsets[c]);
  out.block = mesh.block;
  out.material = mesh.material;
  out.method = mesh.method;
  out.links = static_cast<std::int32_t>(mesh.connectivity.size());
  out.connectivity = mesh.connectivity;
  out.kinds = static_cast<std::int32_t>(mesh.methods.size());
  for (const std::string& method : mesh.methods) out.methods.push_back(wire_text(method));
  return seal(out);
}

void send_mesh(const header_v1_t& header, const Bytes& mesh, const Send& send) {
  send_pieces<topo_v1_t>(header, mesh, send);
}

void send_frame(const LiveFrame& frame, const Send& send) {
  const LiveMesh& mesh = *frame.mesh;
  SCREE_ASSERT(frame.position.size() == 2 * mesh.points() && frame.scalar.size() == mesh.cells());
  std::vector<std::int32_t> bodies;
  std::vector<AffineMap> maps;
  std::vector<char> loose(mesh.points(), 1);
  for (std::size_t b = 0; b < mesh.bodies(); ++b)
    if (const auto map = affine_map(mesh, b, frame.position)) {
      bodies.push_back(static_cast<std::int32_t>(b));
      maps.push_back(*map);
      for (const std::int32_t p : mesh.points_of(b)) loose[static_cast<std::size_t>(p)] = 0;
    }
  std::vector<double> dx, dy;
  for (std::size_t p = 0; p < mesh.points(); ++p)
    if (loose[p] != 0) {
      dx.push_back(frame.position[2 * p] - mesh.start_x[p]);
      dy.push_back(frame.position[2 * p + 1] - mesh.start_y[p]);
    }

  state_v1_t out{};
  out.header = frame.header;
  out.total_maps = static_cast<std::int32_t>(maps.size());
  out.total_points = static_cast<std::int32_t>(dx.size());
  out.total_cells = static_cast<std::int32_t>(mesh.cells());
  out.chunks = frame_chunks(out.total_maps, out.total_points, out.total_cells);
  for (out.chunk = 0; out.chunk < out.chunks; ++out.chunk) {
    const auto part = [&](std::int32_t total, std::int32_t& first, std::int32_t& count) {
      first = split_at(total, out.chunk, out.chunks);
      count = split_at(total, out.chunk + 1, out.chunks) - first;
      return std::pair(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    };
    const auto [map, map_count] = part(out.total_maps, out.first_map, out.maps);
    out.body.assign(bodies.begin() + out.first_map, bodies.begin() + out.first_map + out.maps);
    for (auto* list : {&out.ux, &out.uy, &out.xx, &out.xy, &out.yx, &out.yy}) list->clear();
    for (const AffineMap& m : std::span(maps).subspan(map, map_count)) {
      out.ux.push_back(m.ux), out.uy.push_back(m.uy);
      out.xx.push_back(m.xx), out.xy.push_back(m.xy);
      out.yx.push_back(m.yx), out.yy.push_back(m.yy);
    }
    const auto [point, point_count] = part(out.total_points, out.first_point, out.points);
    Quantised q = quantise(std::span(dx).subspan(point, point_count), std::span(dy).subspan(point, point_count));
    out.base[0] = q.base[0];
    out.base[1] = q.base[1];
    out.scale = q.scale;
    out.dx = std::move(q.dx);
    out.dy = std::move(q.dy);
    (void)part(out.total_cells, out.first_cell, out.cells);
    out.scalar.assign(frame.scalar.begin() + out.first_cell, frame.scalar.begin() + out.first_cell + out.cells);
    send(seal(out));
  }
}

void send_history(const LiveHistory& history, const Send& send) {
  hist_v1_t out{};
  out.header = history.header;
  out.total = static_cast<std::int32_t>(history.names.size());
  for (std::size_t first = 0; first < history.names.size(); first += std::size_t{kMonitorsPerMessage}) {
    const std::size_t last = std::min(first + std::size_t{kMonitorsPerMessage}, history.names.size());
    out.first = static_cast<std::int32_t>(first);
    out.monitors = static_cast<std::int32_t>(last - first);
    for (auto* list :
         {&out.position_x, &out.position_y, &out.displacement_x, &out.displacement_y, &out.velocity_x, &out.velocity_y})
      list->clear();
    out.name.clear();
    for (std::size_t i = first; i < last; ++i) {
      out.name.push_back(wire_text(history.names[i], 100));
      out.position_x.push_back(history.position[2 * i]);
      out.position_y.push_back(history.position[2 * i + 1]);
      out.displacement_x.push_back(history.displacement[2 * i]);
      out.displacement_y.push_back(history.displacement[2 * i + 1]);
      out.velocity_x.push_back(history.velocity[2 * i]);
      out.velocity_y.push_back(history.velocity[2 * i + 1]);
    }
    send(seal(out));
  }
}

Bytes encode_energy(const header_v1_t& header, const coupling::Ledger& ledger) {
  energy_v1_t out{};
  out.header = header;
  out.columns = coupling::kColumns;
  for (int c = 0; c < coupling::kColumns; ++c) {
    const coupling::ColumnInfo& column = coupling::info(static_cast<coupling::Column>(c));
    out.name.emplace_back(column.name);
    out.side.emplace_back(side_name(column.side));
    out.value.push_back(ledger[static_cast<coupling::Column>(c)]);
  }
  out.energy = ledger.energy();
  out.closure = ledger.closure();
  out.moved = ledger.moved();
  out.relative_closure = ledger.relative_closure();
  out.passed = ledger.passed();
  return seal(out);
}

Bytes encode_event(const header_v1_t& header, const coupling::Event& event) {
  event_v1_t out{};
  out.header = header;
  out.kind = name(event.kind);
  out.text = wire_text(event.text, 2000);
  out.block = -1;
  if (event.transfer != nullptr) {
    out.block = event.transfer->block.value;
    out.from_method = wire_text(event.transfer->from);
    out.to_method = wire_text(event.transfer->to);
    out.mass_error = event.transfer->mass_error;
    out.momentum_error = event.transfer->momentum_error;
    out.angular_error = event.transfer->angular_error;
    out.energy_error = event.transfer->energy_error;
  }
  return seal(out);
}

}  // namespace scree::io
