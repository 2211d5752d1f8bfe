#include "io/serve/stored_site.h"

#include <deque>

#include "io/report/frames.h"
#include "io/report/page.h"
#include "io/report/run_text.h"
#include "io/results/run_reader.h"
#include "io/serve/request_rules.h"
#include "io/viewer/bundle.h"

namespace scree::io {
namespace {

constexpr std::size_t kLooked = 300;          // frames from which ranges of colours are taken
constexpr std::size_t kKeptBytes = 64 << 20;  // of frames that were requested lately, for other viewers
constexpr int kLevel = 1;                     // of compression: on this machine reading waits longer than sending

SharedBytes shared_bytes(std::vector<std::uint8_t>&& bytes) {
  return std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
}

Resource chunk_resource(SharedBytes bytes) { return {"application/octet-stream", std::move(bytes)}; }

}  // namespace

std::optional<Resource> page_resource(std::string_view path, const std::string& title, std::string_view source) {
  if (path == "/") return Resource{"text/html; charset=utf-8", bytes_of(served_page(title, source))};
  if (path == "/viewer.js") return Resource{"text/javascript; charset=utf-8", bytes_of(viewer_script())};
  if (path == "/viewer.css") return Resource{"text/css; charset=utf-8", bytes_of(viewer_style())};
  return {};
}

struct StoredSite::Data {
  Data(const std::filesystem::path& folder, const std::string& version) : run(folder), text(run, folder, version) {}

  /// The frame, from those kept where it is among them.
  SharedBytes frame(std::size_t index) {
    for (const auto& [i, bytes] : kept)
      if (i == index) return bytes;
    SharedBytes bytes = shared_bytes(frame_chunk(run, run.frame(index), text.base()).packed(kLevel));
    kept.emplace_back(index, bytes);
    kept_bytes += bytes->size();
    while (kept_bytes > kKeptBytes && kept.size() > 1) {
      kept_bytes -= kept.front().second->size();
      kept.pop_front();
    }
    return bytes;
  }

  RunReader run;
  RunText text;
  ReportFrames frames;
  std::string title;
  std::string_view source;
  SharedBytes json, history;
  std::deque<std::pair<std::size_t, SharedBytes>> kept;
  std::size_t kept_bytes = 0;
};

StoredSite::StoredSite(const std::filesystem::path& run_folder, const std::string& version, Kind kind)
    : data_(std::make_unique<Data>(run_folder, version)) {
  Data& d = *data_;
  if (d.run.times().empty()) throw FileError(run_folder, "has no frame yet; there is nothing to show");
  d.title = d.run.title().empty() ? "Scree run" : d.run.title();
  d.source = kind == Kind::model ? "model" : "stored";
  d.frames = list_frames(d.run, d.text.base(), kLooked);
  d.text.add_frames(d.frames);
  d.json = bytes_of(d.text.text());
  d.history = shared_bytes(d.text.history().packed(kLevel));
}

StoredSite::~StoredSite() = default;

std::size_t StoredSite::frames() const { return data_->frames.frames.size(); }

const std::string& StoredSite::title() const { return data_->title; }

std::optional<Resource> StoredSite::find(std::string_view path) {
  Data& d = *data_;
  if (auto page = page_resource(path, d.title, d.source)) return page;
  if (path == "/run.json") return Resource{"application/json", d.json};
  if (path == "/history") return chunk_resource(d.history);
  if (const auto mesh = number_of_path(path, "/mesh/"); mesh && *mesh < d.frames.first.size())
    return chunk_resource(shared_bytes(mesh_chunk(d.run.frame(d.frames.first[*mesh]), d.text.base()).packed(kLevel)));
  if (const auto frame = number_of_path(path, "/frame/"); frame && *frame < d.frames.frames.size())
    return chunk_resource(d.frame(*frame));
  return {};
}

}  // namespace scree::io
