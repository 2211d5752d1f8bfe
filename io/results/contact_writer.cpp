#include "io/results/contact_writer.h"

#include <array>

namespace scree::io {

ContactWriter::ContactWriter(const h5::File& file) {
  const std::string g = "/contacts/";
  corner_ = {file,
             g + "corner",
             4,
             {"1",
              "corner of a point: block, counted from 0 in /blocks; ring, 0 the outer one, then holes and cracks; edge "
              "that begins at the "
              "corner; vertex of the mesh along that edge, 0 the corner itself"}};
  edge_ = {file, g + "edge", 3, {"1", "edge against the corner: block, ring, edge from corner k to k + 1"}};
  joint_ = {file, g + "joint", 1, {"1", "law, counted from 0 in /joints/name"}};
  state_ = {file, g + "state", 1, {"1", "0 open, 1 slipping, 2 sticking"}};
  facing_ = {file, g + "facing", 1, {"1", "1: part of two edges that face each other; 0: a corner against an edge"}};
  bonded_ = {file, g + "bonded", 1, {"1", "1: closed since the start with a tensile strength, and not failed"}};
  failed_ = {file, g + "failed", 1, {"1", "1: what failure takes of the strength is lost"}};
  position_ = {file, g + "position", 2, {"m", "x, y of the corner"}};
  normal_ = {file, g + "normal", 2, {"1", "x, y of the unit normal of the edge, outward of its block"}};
  share_ = {file, g + "share", 1, {"m", "length of joint that the point stands for"}};
  gap_ = {file, g + "gap", 1, {"m", "corner above the edge, negative where it penetrates, less gap0"}};
  gap0_ = {file, g + "gap0", 1, {"m", "gap at which the normal spring has no force"}};
  fn_ = {file, g + "fn", 1, {"N", "force on the corner along the normal for unit thickness, negative: a bond pulls"}};
  ft_ = {file, g + "ft", 1, {"N", "force on the corner along (-normal y, normal x) for unit thickness"}};
  water_ = {file, g + "water", 1, {"N", "force of water in the joint on the corner along the normal, beside fn"}};
  slip_ = {file, g + "slip", 1, {"m", "accumulated slip, whatever its direction"}};
  first_ = {file, g + "frames/first", 1, {"1", "first row of a frame"}};
  count_ = {file, g + "frames/count", 1, {"1", "rows of a frame"}};
}

void ContactWriter::frame(const coupling::FrameView& frame) {
  const coupling::ContactView& view = *frame.contacts;
  first_.append(state_.rows());
  count_.append(static_cast<std::int64_t>(view.memory.size()));
  for (const coupling::ContactMemory& m : view.memory) {
    const coupling::ContactKey& k = m.key;
    corner_.append(std::array{k.block_p, k.ring_p, k.vertex, k.part});
    edge_.append(std::array{k.block_e, k.ring_e, k.edge});
    joint_.append(m.joint);
    state_.append(static_cast<std::int32_t>(m.status));
    facing_.append(m.edge_edge);
    bonded_.append(m.bonded);
    failed_.append(m.failed);
    share_.append(m.tributary);
    gap_.append(m.gap);
    gap0_.append(m.gap0);
    fn_.append(m.fn);
    ft_.append(m.ft);
    water_.append(m.water);
    slip_.append(m.slip);
  }
  position_.append(view.position);
  normal_.append(view.normal);
}

}  // namespace scree::io
