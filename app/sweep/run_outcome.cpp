#include "app/sweep/run_outcome.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "io/checkpoint/checkpoints.h"
#include "io/results/file_error.h"
#include "io/results/run_folder.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

}  // namespace

std::string first_error(const fs::path& log) {
  constexpr std::string_view kMark = "error: ";
  std::ifstream in(log, std::ios::binary);
  for (std::string line; std::getline(in, line);)
    if (const std::size_t at = line.find(kMark); at != std::string::npos) return line.substr(at + kMark.size());
  return {};
}

RunOutcome run_outcome(const fs::path& folder, const fs::path& log, const std::vector<std::string>& overrides,
                       const std::string& case_sha256) {
  std::error_code error;
  RunOutcome out;
  if (!fs::is_directory(folder, error) || fs::is_empty(folder, error)) {
    out.reason = first_error(log);
    if (!out.reason.empty()) out.status = "failed";
    return out;
  }
  out.state = RunOutcome::State::started;
  out.status = "started";
  std::ifstream in(folder / "summary.json", std::ios::binary);
  const Json summary = in.is_open() ? Json::parse(in, nullptr, false) : Json();
  if (!summary.is_object() || !summary.contains("status")) {
    out.reason = first_error(log);
    if (!out.reason.empty()) out.status = "failed";
    return out;
  }
  if (summary.value("case_sha256", "") != case_sha256)
    throw io::FileError(folder,
                        "holds a run of another case than the sweep around it; remove the folder to run it again");
  if (summary.value("set", std::vector<std::string>()) != overrides)
    throw io::FileError(
        folder, "holds a run with other parameters than the sweep around it has; remove the folder to run it again");
  out.status = summary.value("status", "");
  out.reason = summary.value("reason", "");
  if (out.status == "done")
    out.state = RunOutcome::State::done;
  else if (out.status != "interrupted")
    out.state = RunOutcome::State::failed;
  return out;
}

bool has_checkpoint(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return false;
  return !io::checkpoint_files(io::RunFolder::reopen(folder)).empty();
}

bool is_busy(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return false;
  try {
    const io::FolderLock lock(folder);
    return false;
  } catch (const io::FileError&) {
    return true;
  }
}

}  // namespace scree::app
