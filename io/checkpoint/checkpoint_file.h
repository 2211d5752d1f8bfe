// One checkpoint in one file, which is either whole and that of its run, or refused.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "coupling/stages/checkpoint.h"
#include "io/results/results_mark.h"

namespace scree::io {

/// The input and options of a run: sufficient to start the same run again.
struct RunRecord {
  std::string version, commit, instruction_set;  // of the program
  std::string name, command_line;                // of the run
  std::string case_path;                         // absolute; files named in the case are relative to its folder
  std::string case_text;
  std::vector<std::string> overrides;            // --set
  std::vector<std::string> files, file_digests;  // named in the case, with their SHA-256
  bool audit = false;
  double until = std::numeric_limits<double>::infinity();  // --until [s]

  /// Calls see(name, value) as State::visit() does.
  template <class Visitor>
  void visit(Visitor&& see) const;
};

struct StoredCheckpoint {
  RunRecord run;
  ResultsMark results;
  coupling::Checkpoint checkpoint;

  /// Calls see(name, value) as State::visit() does.
  template <class Visitor>
  void visit(Visitor&& see) const {
    run.visit(see);
    results.visit(see);
    checkpoint.visit(see);
  }
};

/// Contents of the file: "SCREE-CP"; format version and a word that shows the byte order (32 bits each); number of
/// bytes that follow (64 bits); the record, the mark and the checkpoint (archive.h); hash of the state; SHA-256 of
/// everything before in 64 hexadecimal digits. It is written under another name and then put in place (atomic_file.h).
/// @throws FileError; an existing file of that name is unchanged then
void write_checkpoint(const std::filesystem::path& path, const RunRecord& run, const ResultsMark& results,
                      const coupling::Checkpoint& checkpoint);

/// @param version  of the program: a state can be used only by the version that wrote it
/// @throws FileError with the reason: unreadable, no checkpoint, of another format, byte order or version, cut short,
///         damaged
[[nodiscard]] StoredCheckpoint read_checkpoint(const std::filesystem::path& path, const std::string& version);

// ---------------------------------------------------------------------------------------------------------------

template <class Visitor>
void RunRecord::visit(Visitor&& see) const {
  see("run.version", version);
  see("run.commit", commit);
  see("run.instruction_set", instruction_set);
  see("run.name", name);
  see("run.command_line", command_line);
  see("run.case_path", case_path);
  see("run.case_text", case_text);
  for (auto* list : {&overrides, &files, &file_digests}) {
    see.size("run.texts", *list);
    for (const std::string& text : *list) see("run.text", text);
  }
  see("run.audit", audit);
  see("run.until", until);
}

}  // namespace scree::io
