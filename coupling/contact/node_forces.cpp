#include "coupling/contact/node_forces.h"

#include <algorithm>
#include <utility>

namespace scree::coupling {
namespace {

constexpr std::int64_t kFewForces = 1024, kFewNodes = 4096;  // fewer are not worth waking threads for

}  // namespace

NodeForces::NodeForces(const Setup& setup, std::size_t expected) : setup_(&setup) {
  forces_.resize(setup.outlines().nodes.size());
  rests_.assign(forces_.size(), 1);
  for (const IndexRange<OutlineNode> r : setup.outlines().moving_nodes)
    for (const OutlineNode n : r) rests_[n] = 0;
  of_point_.reserve(expected);
  reach_.reserve(expected / kContactChunk + 1);
}

void NodeForces::begin(std::size_t points) {
  of_point_.resize(points);
  reach_.resize((points + kContactChunk - 1) / kContactChunk);
}

void NodeForces::take_all(const ContactList& list) {
  begin(list.points.size());
  const auto of_chunk = [&](std::int64_t begin, std::int64_t end) {
    begin_chunk(static_cast<std::size_t>(begin));
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      take(i, list.points[i], list.memory[i]);
  };
  parallel_for_chunks(std::ssize(list.points), of_chunk, kFewForces, kContactChunk);
}

template <class OfNode>
void NodeForces::for_moving(OutlineNode begin, OutlineNode end, OfNode&& of_node) const {
  for (const IndexRange<OutlineNode> r : setup_->outlines().moving_nodes)
    for (const OutlineNode n : IndexRange(std::clamp(r.first(), begin, end), std::clamp(r.end_index(), begin, end)))
      of_node(n);
}

void NodeForces::add(std::span<double> f) {
  if (of_point_.empty()) return;
  const Outlines& o = setup_->outlines();
  const std::int32_t nodes = o.nodes.indices().size();
  const bool on_threads = std::ssize(of_point_) >= kFewForces;
  parallel_parts(nodes, on_threads, [&](std::int64_t, std::int32_t begin, std::int32_t end) {
    for_moving(OutlineNode{begin}, OutlineNode{end}, [&](OutlineNode n) { forces_[n].setZero(); });
    const auto chunk = static_cast<std::size_t>(kContactChunk);
    for (std::size_t c = 0; c < reach_.size(); ++c) {
      if (!reach_[c].meets(begin, end)) continue;
      for (const OfPoint& p : std::span(of_point_).subspan(chunk * c, std::min(chunk, of_point_.size() - chunk * c)))
        for (std::size_t k = 0; k < 3; ++k)
          if (const OutlineNode n = p.node[k]; n.value >= begin && n.value < end && rests_[n] == 0)
            forces_[n] += p.force[k];
    }
  });
  // Parts begin with a body here: bodies share no node of the state.
  const auto first_of_body = [&](OutlineNode i) {
    while (i.value > 0 && i.value < nodes && o.node_body[i] == o.node_body[i - 1]) i = i + 1;
    return i;
  };
  parallel_parts(nodes, on_threads && nodes >= kFewNodes, [&](std::int64_t, std::int32_t begin, std::int32_t end) {
    for_moving(first_of_body(OutlineNode{begin}), first_of_body(OutlineNode{end}), [&](OutlineNode n) {
      if (!forces_[n].isZero(0.0)) add_force(o.nodes[n], forces_[n], f);
    });
  });
}

}  // namespace scree::coupling
