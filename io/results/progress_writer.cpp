#include "io/results/progress_writer.h"

#include "io/results/worst_contact.h"

namespace scree::io {

ProgressWriter::ProgressWriter(const h5::Growing& in, const Model& model) {
  for (const Block& block : model.blocks) blocks_.push_back(block.name);
  const std::string g = "/progress/";
  cuts_ = {in, g + "cuts", 1, {"1", "step cuts since the start"}};
  passes_ = {in, g + "passes", 1, {"1", "open-close passes since the start"}};
  contacts_ = {in, g + "contacts", 1, {"1", "contact points closed"}};
  unknowns_ = {in, g + "unknowns", 1, {"1", "unknowns of the stage"}};
  depth_ = {in, g + "contact_depth", 1, {"m", "deepest penetration of a closed contact"}};
  force_ = {in, g + "contact_force", 1, {"N", "largest force of a closed contact for unit thickness"}};
  depth_at_ = {in, g + "contact_depth_at", {"none", "the deepest contact: corner and edge; empty: none is closed"}};
  force_at_ = {in, g + "contact_force_at", {"none", "the contact with the largest force"}};
}

void ProgressWriter::frame(const coupling::FrameView& frame) {
  const WorstContact worst = worst_contact(*frame.state, blocks_);
  cuts_.append(frame.stats->cuts);
  passes_.append(frame.stats->passes);
  contacts_.append(frame.stats->contacts);
  unknowns_.append(frame.stats->unknowns);
  depth_.append(worst.depth);
  force_.append(worst.force);
  depth_at_.append(worst.depth_at);
  force_at_.append(worst.force_at);
}

}  // namespace scree::io
