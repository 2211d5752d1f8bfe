// run.xmf: what ParaView reads of run.vtkhdf through any of its three XDMF readers.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/results/atomic_file.h"
#include "io/results/vtkhdf_writer.h"
#include "io/results/xdmf_text.h"

namespace scree::io {

/// Makes, in the results file, the datasets that the text refers to, and writes the text beside it.
///   /xdmf/Points/<g>/<n>, /xdmf/PointData/<field>/<g>/<n>, /xdmf/CellData/<field>/<g>/<n>
///                          rows of the dataset of that name in /VTKHDF, as virtual datasets: nothing is stored twice.
///                          Counted anew by each field: one a frame, or one a mesh; 500 of them in a group. Arrays of
///                          at most 100 numbers stand in the text itself: a window would take more room than they do,
///                          and a hundred times as long to make
///   /xdmf/topology/<mesh>  cells as XDMF's "Mixed" topology: 3 (polygon), number of points, points
/// The readers of ParaView 5.11 agree on one plain or virtual dataset a frame only; of selections in the text two of
/// them show nothing.
///
/// Two frames at one time (the last of a stage and the first of the next, with new bodies): readers choose by time, so
/// the earlier one is given as 1 ps, a tick, before. Asked for the time itself they show the new bodies.
class XdmfWriter {
 public:
  /// @param file  with the datasets of a VtkhdfWriter; outlives this   @param xmf  the text, in the folder of the file
  XdmfWriter(const h5::File& file, std::filesystem::path xmf);

  /// Adds the frame that a VtkhdfWriter stored last, in the given rows.   @throws FileError
  void frame(const coupling::FrameView& frame, const FrameRows& rows, const FrameValues& values);
  /// Adds the frames that the file has already, in the rows that another file tells of.   @throws FileError
  void take(const h5::File& from, std::int64_t frames);
  /// Makes the windows of the frames added since. They take longer than all else of a frame: whoever adds a frame does
  /// not wait for them.   @throws FileError
  void settle();
  /// Windows that wait for settle().
  [[nodiscard]] std::size_t due() const { return due_.size(); }
  /// The text that waits for flush() has little room left.
  [[nodiscard]] bool full() const;
  /// Puts the text in place of the old one, whole, when a second has passed since and the last writing took less than
  /// 2 % of the time: all that stands already is copied, and that grows with the run.
  /// @pre the frames so far and their windows are in the file as other programs see it   @throws FileError
  void flush();
  /// Puts the text in place in any case.   @pre as for flush()   @throws FileError
  void close();

 private:
  using Clock = std::chrono::steady_clock;
  struct Field {
    const char *name, *center, *type;  // as XDMF calls them; the geometry has no centre
    std::string path;                  // below /VTKHDF, and below /xdmf
    int width;
    bool whole;  // numbers
    std::int64_t FrameRows::*first;
    std::vector<double> FrameValues::*values;  // nullptr: stored once a mesh
    h5::Label label;
    std::int64_t made = 0, shown = -1;  // windows so far; first row of the last one
  };
  struct Due {
    std::size_t field = 0;
    std::int64_t number = 0, first = 0, count = 0;  // of the window; rows
  };
  struct Waiting {
    std::int64_t number = 0;
    double time = 0.0;
    std::string parts;  // of its grid
  };
  std::string topology(std::span<const std::int32_t> offsets, std::span<const std::int32_t> connectivity,
                       std::int64_t number);
  /// @param values  of the fields that stand in the text
  void add(double time, const FrameRows& rows, const FrameValues& values);
  [[nodiscard]] static std::int64_t count(const Field& field, const FrameRows& rows);
  [[nodiscard]] static bool in_text(const Field& field, const FrameRows& rows);
  /// The virtual dataset of these rows, due unless it is the last one.
  xdmf::Array window(std::size_t field, const FrameRows& rows);
  [[nodiscard]] std::string waiting() const;
  void write();

  const h5::File* file_;
  std::filesystem::path xmf_;
  std::vector<Field> fields_;
  std::vector<Due> due_;
  std::string topology_;  // of the present mesh
  std::int64_t mesh_ = -1, frames_ = 0;
  std::string settled_;                  // opening and grids whose time is certain, as far as they are not in the file
  std::vector<Waiting> waiting_;         // frames of the latest time: one more of that time would move theirs
  std::unique_ptr<AtomicFile> written_;  // what is in place, and
  std::int64_t kept_ = 0;                // bytes of it that stay
  Clock::time_point next_;               // no text is written before
};

}  // namespace scree::io
