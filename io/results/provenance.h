// Where results come from: everything needed to repeat the run, in its file.
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

/// What the caller knows about a run and its case.
struct Provenance {
  std::string version;    // of Scree
  std::string commit;     // of the source, empty when unknown
  std::string case_text;  // as the user wrote it
  std::string command_line;
  std::vector<std::string> overrides;                          // key=value, of --set
  int threads = 1;                                             // really used
  std::vector<std::pair<std::string, std::string>> libraries;  // more name, version pairs than known_libraries()
};

/// SHA-256 of the case text, 64 hexadecimal digits.
[[nodiscard]] std::string case_hash(const Provenance& provenance);
/// Compiler and its version.
[[nodiscard]] std::string compiler();
/// Instruction set that the compiler was allowed: "x86-64", or with the extensions that change results.
[[nodiscard]] std::string instruction_set();
/// Name and version of the libraries that results depend on and this part can ask.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> known_libraries();

/// /provenance: attributes version, commit, case_sha256, command_line, compiler, instruction_set, threads; datasets
/// case, set (key=value of --set, where there were any), library, library_version.
void write_provenance(const h5::File& file, const Provenance& provenance);

/// Attributes title and origin of the file: x, y that every position in it is counted from [m].
/// /blocks/{name, material, held, ring_block, ring_offset, point}: rings of the polygons as the model first had them,
/// ragged: ring r is point[ring_offset[r] : ring_offset[r + 1]] of block ring_block[r], outer ring first.
/// /materials/{name, density, young, poisson}; /stages/{name, integrator, duration}.
void write_model(const h5::File& file, const Model& model);
void write_stages(const h5::File& file, const coupling::Plan& plan);

}  // namespace scree::io
