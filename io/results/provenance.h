// Origin of the results: everything needed to repeat the run, stored in its file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::io {

namespace h5 {
class File;
}

/// Data of a run and its case that the caller supplies.
struct Provenance {
  std::string version;    // of Scree
  std::string commit;     // of the source, empty when unknown
  std::string case_text;  // as the user wrote it; may be dropped once case_sha256 is set
  std::string case_sha256;
  std::string command_line;
  std::vector<std::string> overrides;                          // key=value, of --set
  int threads = 1;                                             // actually used
  std::vector<std::pair<std::string, std::string>> libraries;  // name, version pairs in addition to known_libraries()
};

/// SHA-256 of the case text, 64 hexadecimal digits.
[[nodiscard]] std::string case_hash(const Provenance& provenance);
/// Compiler and its version.
[[nodiscard]] std::string compiler();
/// Instruction set that the compiler was allowed to use: "x86-64", and the extensions that change results.
[[nodiscard]] std::string instruction_set();
/// Name and version of the libraries that results depend on and whose version is available here.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> known_libraries();

/// /provenance: attributes version, commit, case_sha256, command_line, compiler, instruction_set, threads; datasets
/// case, set (key=value of --set, where there were any), library, library_version.
void write_provenance(const h5::File& file, const Provenance& provenance);

/// Attributes title and origin of the file; all positions in the file are relative to the origin x, y [m].
/// /blocks/{name, material, held, ring_block, ring_offset, point}: rings of the initial polygons, ragged:
/// ring r is point[ring_offset[r] : ring_offset[r + 1]] of block ring_block[r], outer ring first.
/// /materials/{name, density, young, poisson}; /stages/{name, integrator, duration}.
void write_model(const h5::File& file, const Model& model);
void write_stages(const h5::File& file, const coupling::Plan& plan);

}  // namespace scree::io
