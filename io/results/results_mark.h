// How much of a run's results there was at an instant.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree::io {

/// A dataset: its rows, and a hash of all that was written in them. A file that was killed or had no room while it was
/// written may read back without an error and yet hold other numbers: the place of a chunk that moved is used again.
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

/// Rows of every dataset and lengths of the tables: what comes after is written again by a run that goes on from there.
struct ResultsMark {
  std::vector<SeriesMark> frames, histories, events, contacts, bolts,
      progress;                       // in the order in which their writers have them
  std::array<TableMark, 2> tables{};  // history.csv and energy.csv
  // Of the frames: their number; id of the mesh stored last (-1: none yet); 1 once time schemes of its cells have been
  // stored, else 0; and where that mesh is.
  std::int64_t frame_count = 0, mesh = -1, schemes = 0;
  std::array<std::int64_t, 6> mesh_rows{};
  std::int64_t stored_tick = -1, stored_stage = -1;  // of the last frame
  double wall_seconds = 0.0, cpu_seconds = 0.0;      // that the run has taken so far

  /// As State::visit().
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
