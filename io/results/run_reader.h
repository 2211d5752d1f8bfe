// Reads a stored run: frames, blocks, ledger, monitors. The interface does not use HDF5.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/results/worst_contact.h"
#include "model/geometry.h"
#include "model/rock_strength.h"

namespace scree::io {

/// One frame. Points and cells as in MeshView; a cell is offsets[c] .. offsets[c + 1] of connectivity.
struct StoredFrame {
  std::int64_t index = 0, step = 0, mesh = 0;  // mesh: number of its topology in the file
  double time = 0.0;                           // [s]
  std::string stage, integrator;
  std::uint64_t state_hash = 0;
  std::vector<double> position, displacement, velocity;  // x, y per point [m], [m], [m/s]
  std::vector<std::int64_t> offsets, connectivity;
  std::vector<std::int32_t> block, element, material, method, cell_integrator;  // per cell
  std::vector<double> cell_displacement, cell_velocity;                         // x, y per cell, area means [m], [m/s]
  std::vector<double> stress, principal;  // xx, yy, xy; larger, smaller; per cell; tension positive [Pa]

  [[nodiscard]] std::size_t cells() const { return block.size(); }
  [[nodiscard]] std::size_t points() const { return position.size() / 2; }
};

/// Data of a frame that are available without reading the frame.
struct StoredNote {
  std::int64_t step = 0, mesh = 0;
  double time = 0.0;  // [s]
  std::string stage, integrator;
};

/// The ledger over time [J].
struct StoredLedger {
  struct Column {
    std::string name, side, meaning;  // side: energy, work, dissipated, scheme
    std::vector<double> value;
  };
  std::vector<double> time, energy, closure, moved, passed;  // passed: equal to moved in older runs
  std::vector<Column> columns;                               // in the order of coupling::Column
};

struct StoredMonitor {
  std::string name, given;                                     // name in the file, which is unique; name in the case
  std::vector<double> time, position, displacement, velocity;  // x, y per time
  std::vector<double> stress;                                  // xx, yy, xy per time [Pa]; empty in older runs
};

struct StoredEvent {
  double time = 0.0;  // [s]
  std::string kind, text;
};

/// Progress of the run at a frame.
struct StoredProgress {
  std::int64_t cuts = 0, passes = 0, contacts = 0, unknowns = 0;
  WorstContact contact;  // time: of the frame
};

struct StoredStage {
  std::string name, integrator;
  std::optional<double> start;  // time of its first frame [s]; none where the run did not reach it
  double duration = 0.0;        // as planned [s]
};

struct StoredMaterial {
  std::string name;
  double young = 0.0;    // [Pa]
  double density = 0.0;  // [kg/m3]
  double poisson = 0.0;
  std::optional<RockStrength> strength{};  // of the rock
};

struct StoredBlock {
  std::string name;
  bool held = false;  // fixed or driven as a whole
  Polygon polygon;    // initial polygon
  std::int32_t material = 0;
};

/// A straight piece of a discontinuity, or of a crack that ends inside a block, in the initial geometry.
struct StoredJointLine {
  Vec2 from, to;  // [m]
  std::int32_t law = 0;
};

/// The joint laws and the lines that they belong to.
struct StoredJoints {
  struct Law {
    std::string name;
    double friction_deg = 0.0, cohesion = 0.0, tensile_strength = 0.0;  // [deg], [Pa], [Pa]
  };
  std::vector<Law> laws;
  std::vector<StoredJointLine> lines, cracks;
};

/// A point that a spring ties to its position at the start.
struct StoredSupport {
  Vec2 point;  // [m], in the model
  bool fix_x = true, fix_y = true;
};

/// A stretch of an outline that is held.
struct StoredEdgeSupport {
  Vec2 from, to;                 // [m], in the model; the block lies to their left
  Mat2 held = Mat2::Identity();  // projector on the directions that are held
};

/// A piezometric line, horizontal beyond its ends.
struct StoredWater {
  std::vector<Vec2> line;            // [m], in the model, from left to right
  std::vector<std::int32_t> joints;  // joint laws to which it applies; empty: all
};

/// Contact points of one frame; every list has one entry per contact point.
struct StoredContacts {
  std::vector<double> position, normal;   // x, y per point: of the vertex [m]; of the edge, outward from its block
  std::vector<double> fn, ft, gap, slip;  // [N], [N], [m], [m]; signs and definitions: docs/results.md
  std::vector<std::int32_t> state;        // 0 open, 1 slipping, 2 sticking
  std::vector<std::int32_t> failed;       // 1 where the strength that failure removes is lost
  std::vector<std::int32_t> law;          // joint law
  std::vector<std::int32_t> corner_block, edge_block;
};

/// Bolts of one frame: their nodes, bolt after bolt; every list has one entry per node.
struct StoredBolts {
  std::vector<std::int32_t> bolt;  // number, in the order of the case
  std::vector<double> position;    // x, y [m]
  std::vector<double> force;       // axial force between a node and the next [N]
};

/// Name and attributes of a dataset.
struct DatasetNote {
  std::string name, units, long_name;
  std::int64_t rows = 0;
};

class RunReader {
 public:
  /// @throws FileError, as every member, where the folder is no run or the file is damaged
  explicit RunReader(const std::filesystem::path& run_folder);
  ~RunReader();
  RunReader(RunReader&&) noexcept;

  [[nodiscard]] const std::string& title() const;
  /// Origin to which positions in the run are relative [m]; (0, 0) in runs from before it was stored.
  [[nodiscard]] const Vec2& origin() const;
  [[nodiscard]] const std::vector<double>& times() const;  // of the frames [s]
  [[nodiscard]] const std::vector<std::string>& methods() const;
  [[nodiscard]] const std::vector<StoredBlock>& blocks() const;
  [[nodiscard]] const std::vector<StoredMaterial>& materials() const;
  [[nodiscard]] std::vector<StoredStage> stages() const;
  /// The last frame that is not later than `time`, apart from rounding; the first one when all are later.
  /// @pre there are frames
  [[nodiscard]] std::size_t at_time(double time) const;
  /// @throws FileError when there is no such frame
  [[nodiscard]] StoredFrame frame(std::size_t index) const;
  /// One entry per frame.
  [[nodiscard]] std::vector<StoredNote> notes() const;
  [[nodiscard]] StoredLedger ledger() const;
  /// In the order of the case (in older runs by name).
  [[nodiscard]] std::vector<StoredMonitor> monitors() const;
  [[nodiscard]] std::vector<StoredEvent> events() const;
  /// One entry per frame; none in runs from before they were stored.
  [[nodiscard]] std::vector<StoredProgress> progress() const;
  [[nodiscard]] StoredJoints joints() const;
  /// Point supports; none in runs from before they were stored. Blocks held as a whole: StoredBlock::held.
  [[nodiscard]] std::vector<StoredSupport> supports() const;
  /// Held stretches of outlines; none in runs from before they were stored.
  [[nodiscard]] std::vector<StoredEdgeSupport> edge_supports() const;
  /// Piezometric lines; none in runs from before they were stored.
  [[nodiscard]] std::vector<StoredWater> waters() const;
  /// Whether the run stored its contact points (output.contacts).
  [[nodiscard]] bool has_contacts() const;
  /// Contact points of a frame.   @pre has_contacts()   @throws FileError when there is no such frame
  [[nodiscard]] StoredContacts contacts(std::size_t frame) const;
  [[nodiscard]] bool has_bolts() const;
  /// Bolts of a frame; none where the model has none.   @throws FileError when there is no such frame
  [[nodiscard]] StoredBolts bolts(std::size_t frame) const;
  [[nodiscard]] double end_time() const;  // of the plan; stages that are over count with their actual ends [s]
  [[nodiscard]] std::vector<DatasetNote> datasets() const;
  /// Attribute of /provenance, such as version, commit, case_sha256, command_line, and status and reason for a run that
  /// ended; empty where it is missing.
  [[nodiscard]] std::string provenance(const std::string& key) const;
  /// A list of /provenance, such as case (one entry), set, library, library_version; empty where it is missing.
  [[nodiscard]] std::vector<std::string> provenance_list(const std::string& key) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace scree::io
