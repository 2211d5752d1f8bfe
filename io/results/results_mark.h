// Amount of results that a run had stored at an instant.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree::io {

/// A dataset: its number of rows, and a hash of all that was written in them. A file whose writing was cut short (run
/// killed, disk full) may be read without an error and yet contain other numbers: the place of a chunk that was moved
/// is used again.
struct SeriesMark {
  std::int64_t rows = 0;
  std::uint64_t hash = 0;
  bool operator==(const SeriesMark&) const = default;
};

/// A table: its length, and a hash of its bytes.
struct TableMark {
  std::int64_t bytes = 0;
  std::uint64_t hash = 0;
  bool operator==(const TableMark&) const = default;
};

/// Rows of every dataset and lengths of the tables. A run that continues from the mark writes all later results again.
struct ResultsMark {
  std::vector<SeriesMark> frames, histories, events, contacts, bolts,
      progress;                       // in the order of each() of their writers
  std::array<TableMark, 2> tables{};  // history.csv and energy.csv
  // Of the frames: their number; id of the mesh stored last (-1: none yet); 1 once the time integrators of its cells
  // have been stored, else 0; and the rows of that mesh.
  std::int64_t frame_count = 0, mesh = -1, schemes = 0;
  std::array<std::int64_t, 6> mesh_rows{};
  std::int64_t stored_tick = -1, stored_stage = -1;  // of the last frame stored
  double wall_seconds = 0.0, cpu_seconds = 0.0;      // used by the run so far

  /// Calls see(name, value) as State::visit() does.
  template <class Visitor>
  void visit(Visitor&& see) const {
    for (auto* list : {&frames, &histories, &events, &contacts, &bolts, &progress}) {
      see.size("results.series", *list);
      for (const SeriesMark& series : *list) {
        see("results.rows", series.rows);
        see("results.hash", series.hash);
      }
    }
    for (const TableMark& table : tables) {
      see("results.table_bytes", table.bytes);
      see("results.table_hash", table.hash);
    }
    see("results.frame_count", frame_count);
    see("results.mesh", mesh);
    see("results.schemes", schemes);
    see("results.mesh_rows", mesh_rows);
    see("results.stored_tick", stored_tick);
    see("results.stored_stage", stored_stage);
    see("results.wall_seconds", wall_seconds);
    see("results.cpu_seconds", cpu_seconds);
  }
};

}  // namespace scree::io
