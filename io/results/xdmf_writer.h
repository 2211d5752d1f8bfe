// run.xmf, by which any of the three XDMF readers of ParaView reads run.vtkhdf.
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
///                          rows of the dataset of that name in /VTKHDF, as virtual datasets ("windows"): nothing is
///                          stored twice. n counts the windows of each field separately: one per frame, or one per
///                          mesh; g = n / 500. Arrays of at most 100 numbers are in the text itself: a window would
///                          take more room than they do, and a hundred times as long to make
///   /xdmf/topology/<mesh>  cells as XDMF's "Mixed" topology: 3 (polygon), number of points, points
/// The only form that all readers of ParaView 5.11 read is one plain or virtual dataset per frame; with selections in
/// the text two of them show nothing.
///
/// Two frames may have the same time (the last of a stage and the first of the next, with new bodies). Readers select
/// by time, so the earlier frame is written with a time 1 ps (a tick) less. At the time itself new bodies are shown.
class XdmfWriter {
 public:
  /// @param file  with the datasets of a VtkhdfWriter; outlives this   @param xmf  path of the text, in the same folder
  XdmfWriter(const h5::File& file, std::filesystem::path xmf);

  /// Adds the frame that a VtkhdfWriter stored last, in the given rows.   @throws FileError
  void frame(const coupling::FrameView& frame, const FrameRows& rows, const FrameValues& values);
  /// Adds the frames that the file contains already, in the rows stated in `from`.   @throws FileError
  void take(const h5::File& from, std::int64_t frames);
  /// Makes the windows of the frames added since the last call. They take longer than the rest of a frame, so frame()
  /// does not make them.   @throws FileError
  void settle();
  /// Number of windows that settle() still has to make.
  [[nodiscard]] std::size_t due() const { return due_.size(); }
  /// True when little room is left for the text that flush() has not written yet.
  [[nodiscard]] bool full() const;
  /// Replaces the text on the disk as a whole, if a second has passed since the last writing and that writing took less
  /// than 2 % of the time, or if the text that waits is longer than 64 KiB: all the text written so far is copied, and
  /// it grows with the run.
  /// @pre other programs can read the frames so far and their windows from the file   @throws FileError
  void flush();
  /// Replaces the text in any case.   @pre as for flush()   @throws FileError
  void close();

 private:
  using Clock = std::chrono::steady_clock;
  struct Field {
    const char *name, *center, *type;  // names of XDMF; the geometry has no centre
    std::string path;                  // below /VTKHDF, and below /xdmf
    int width;
    bool whole;  // whole numbers (int32)
    std::int64_t FrameRows::*first;
    std::vector<double> FrameValues::*values;  // nullptr: stored once per mesh
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
  /// @param values  of the fields whose arrays are in the text
  void add(double time, const FrameRows& rows, const FrameValues& values);
  [[nodiscard]] static std::int64_t count(const Field& field, const FrameRows& rows);
  [[nodiscard]] static bool in_text(const Field& field, const FrameRows& rows);
  /// The virtual dataset of these rows; a new one, added to due_, unless the last one of the field has the same rows.
  xdmf::Array window(std::size_t field, const FrameRows& rows);
  [[nodiscard]] std::string waiting() const;
  void write();

  const h5::File* file_;
  std::filesystem::path xmf_;
  std::vector<Field> fields_;
  std::vector<Due> due_;
  std::string topology_;  // of the present mesh
  std::int64_t mesh_ = -1, frames_ = 0;
  std::string settled_;                  // opening and grids whose time is final, as far as they are not written yet
  std::vector<Waiting> waiting_;         // frames of the latest time; one more of that time would change theirs
  std::unique_ptr<AtomicFile> written_;  // the text in place
  std::int64_t kept_ = 0;                // leading bytes of it that do not change any more
  Clock::time_point next_;               // no text is written earlier
};

}  // namespace scree::io
