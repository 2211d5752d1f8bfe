// The parts of reading a case, in the order in which they run.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/plan.h"
#include "io/case/drawn_layers.h"
#include "io/case/notice.h"
#include "io/case/section.h"
#include "model/model.h"

namespace scree::io {

/// Title, plane, gravity, materials and joint laws.
void read_laws(const Section& root, Model& model);
/// When a motion, a function or a load begins, by its keys start and offset.
struct Start {
  StageId stage;      // the time counts from the beginning of this stage; invalid: it is simulated time
  double time = 0.0;  // [s]
};
/// @pre the key start is present
[[nodiscard]] Start read_start(const Section& s, const Section& root);
/// Refuses motions, functions and loads that begin in no stage, and stages to rest during which a motion acts.
/// @pre everything else has been read
void check_times(const Section& root, const Model& model, const coupling::Plan& plan);

/// Refuses meshes too large for the memory of the machine.   @pre everything else has been read
void check_meshes(const Section& root, const Model& model, const coupling::Plan& plan);

/// Time functions of loads.   @param folder  base of relative paths
void read_functions(const Section& root, const std::filesystem::path& folder, Model& model);
/// Blocks with their edges and initial velocities, both listed ones and those cut from a domain; checks the geometry.
/// @param folder  base of relative paths     @pre read_laws
void read_blocks(const Section& root, const std::filesystem::path& folder, const DrawnLayers& drawing, Model& model,
                 const Notice& notice);
/// Appends the blocks of [domain], its lines and cracks.   @pre read_laws
void read_domain(const Section& section, const std::filesystem::path& folder, const DrawnLayers& drawing, Model& model,
                 const Notice& notice);
/// Cracks inside blocks, appended to those that the cutting of a domain left.   @pre read_blocks
void read_cracks(const Section& root, Model& model);
/// Ground motions from their files.   @param folder  base of relative paths
void read_motions(const Section& root, const std::filesystem::path& folder, Model& model);
/// Supports and monitors.   @pre read_blocks, read_motions
void read_supports(const Section& root, Model& model);
void read_monitors(const Section& root, const DrawnLayers& drawing, Model& model);
/// Point loads, tractions, body accelerations, viscous edges.   @pre read_functions, read_supports
void read_loads(const Section& root, Model& model);
/// Refuses a stretch that overlaps a viscous edge.
void check_absorbs_once(const Section& s, const EdgeSpan& span, const Model& model);
/// Free fields: sides of the model that border on level ground.   @pre read_loads, read_plan
void read_free_fields(const Section& root, const coupling::Plan& plan, Model& model);
/// Bolts, laid out in the blocks.   @pre read_blocks, read_supports
void read_bolts(const Section& root, const DrawnLayers& drawing, Model& model);
/// Water in joints.   @pre read_laws
void read_water(const Section& root, const DrawnLayers& drawing, Model& model);
/// Representation of blocks, damping and rest criterion of a stage; refuses incompatible options.
/// @param used  method of every block in the stage   @param first  true for the first stage   @pre the method and the
/// integrator of the stage are set
void read_stage_options(const Section& s, std::span<const std::string> used, bool first, coupling::Stage& stage);
/// Which blocks of a partitioned stage take explicit steps.   @pre read_supports; the integrator of the stage is set
void read_partition(const Section& s, const Model& model, coupling::Stage& stage);
/// Liners, after the bolts, laid out on the blocks present in the liner's stage.   @pre read_bolts, the plan is read
void read_liners(const Section& root, const std::vector<coupling::Stage>& stages, Model& model);
/// Refuses to divide blocks that have no mesh.   @param used  method of every block in the stage
void check_divided(const Section& s, const Model& model, std::span<const std::string> used,
                   const coupling::Stage& stage);
/// Conditions that end a stage early, and the blocks that may change method during it.   @pre read_stage_options
void read_stage_rules(const Section& s, const Model& model, coupling::Stage& stage);
/// Blocks that stages excavate and fill, and release of excavations.   @pre the stages are read, read_bolts
void read_construction(const Section& root, const Model& model, coupling::Plan& plan);
/// Stages, output, streaming, threads.   @pre read_blocks, read_supports
[[nodiscard]] coupling::Plan read_plan(const Section& root, const Model& model, std::span<const std::string> methods);

/// [reduction]: replaces the stages after those to rest, removes weakening of joints and all motions.
/// @param methods  names of the methods that exist   @pre everything else has been read and checked
void read_reduction(const Section& root, std::span<const std::string> methods, Model& model, coupling::Plan& plan);

/// Names of materials, blocks and so on, in the order of their ids.
template <class T>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<T>& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const T& item : items) names.push_back(item.name);
  return names;
}

/// Index of the name under a key, or of the name in an item of the list under the key.
/// @param what  for the message: "material"     @throws CaseError with the known names
[[nodiscard]] std::int32_t find_name(const Section& section, std::string_view key, std::string_view what,
                                     const std::vector<std::string>& known);
[[nodiscard]] std::int32_t find_name(const Section& section, std::string_view key, std::size_t item,
                                     std::string_view what, const std::vector<std::string>& known);

/// Indices of the names that an item of a list selects: the name equal to the item, else all names that match it as a
/// pattern, in which `*` stands for any characters.   @throws CaseError if there is none
[[nodiscard]] std::vector<std::int32_t> find_names(const Section& section, std::string_view key, std::size_t item,
                                                   std::string_view what, const std::vector<std::string>& known);
/// True if the whole name matches the pattern.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view name);

}  // namespace scree::io
