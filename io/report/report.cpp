#include "io/report/report.h"

#include <algorithm>

#include "io/report/frames.h"
#include "io/report/page.h"
#include "io/report/run_text.h"
#include "io/results/atomic_file.h"
#include "io/results/run_reader.h"
#include "io/viewer/bundle.h"

namespace scree::io {
namespace {

constexpr double kMegabyte = 1e6;
constexpr std::size_t kSlack = 20000;  // bytes of the page's own elements

}  // namespace

ReportNote write_report(const std::filesystem::path& run_folder, const ReportOptions& options,
                        const std::filesystem::path& file) {
  const RunReader run(run_folder);
  if (run.times().empty()) throw FileError(run_folder, "has no frame yet; there is nothing to report");
  RunText page(run, run_folder, options.version);
  PageParts parts;
  parts.title = run.title().empty() ? "Scree run" : run.title();
  parts.chunks.emplace_back("history", page.history().text());
  const std::size_t rest = page.text().size() + parts.chunks.front().second.size() + viewer_script().size() +
                           viewer_style().size() + viewer_body().size() + viewer_licences().size() + kSlack;
  const auto limit = static_cast<std::size_t>(options.megabytes * kMegabyte);
  // A report always has its model, its histories and the ends of its stages, whatever their size.
  const std::size_t room = limit == 0 ? 0 : std::max<std::size_t>(1, limit > rest ? limit - rest : 1);
  ReportFrames frames = pack_frames(run, page.base(), room);
  page.add_frames(frames);
  parts.run = page.text();
  for (std::size_t m = 0; m < frames.meshes.size(); ++m)
    parts.chunks.emplace_back("mesh-" + std::to_string(m), std::move(frames.meshes[m]));
  for (std::size_t i = 0; i < frames.frames.size(); ++i)
    parts.chunks.emplace_back("frame-" + std::to_string(i), std::move(frames.frames[i].text));
  const std::string html = report_page(parts);
  write_atomically(file, html);
  return {frames.stored, frames.frames.size(), html.size()};
}

}  // namespace scree::io
