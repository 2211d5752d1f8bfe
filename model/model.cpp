#include "model/model.h"

namespace scree {

const BlockSupport* Model::support_of(BlockId b) const {
  for (const BlockSupport& s : block_supports)
    if (s.block == b) return &s;
  return nullptr;
}

const JointWater* Model::water_in(JointId joint) const {
  for (const JointWater& w : waters)
    if (w.fills(joint)) return &w;
  return nullptr;
}

JointId Model::joint_of(BlockId b, std::size_t ring, std::size_t edge) const {
  const Block& block = blocks[b.index()];
  if (ring < block.edges.size() && edge < block.edges[ring].size() && block.edges[ring][edge].valid())
    return block.edges[ring][edge];
  return block.joint;
}

}  // namespace scree
