// Contents of the page of a stored run besides its frames: the model, stages, histories, events, input and results.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "io/report/chunk.h"
#include "io/report/frames.h"
#include "io/results/run_reader.h"

namespace scree::io {

/// The JSON that io/viewer/src/source.ts names Run, and the chunk of histories.
class RunText {
 public:
  /// @param version  of the program that writes   @throws FileError
  RunText(const RunReader& run, const std::filesystem::path& run_folder, const std::string& version);
  ~RunText();
  RunText(const RunText&) = delete;
  RunText& operator=(const RunText&) = delete;

  /// The middle of the model in whole metres, the reference point of positions on the page, in addition to the origin
  /// of the run: float32 then resolves them to 1e-7 of the extent of the model.
  [[nodiscard]] const Vec2& base() const;
  /// Monitors and the ledger.
  [[nodiscard]] const Chunk& history() const;

  void add_frames(const ReportFrames& frames);
  /// Valid JSON whatever the texts of the run contain.
  [[nodiscard]] std::string text() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace scree::io
