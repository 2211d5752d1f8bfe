#include "coupling/contact/node_forces.h"

#include <omp.h>

#include <algorithm>

#include "coupling/contact/table/contact_pairs.h"
#include "coupling/contact_geometry.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr std::int64_t kFewForces = 1024, kFewNodes = 16384;  // fewer are not worth waking threads for

}  // namespace

NodeForces::NodeForces(const Setup& setup, std::size_t expected) : setup_(&setup) {
  forces_.resize(setup.outlines().nodes.size());
  rests_.assign(forces_.size(), 1);
  for (const IndexRange<OutlineNode> r : setup.outlines().moving_nodes)
    for (const OutlineNode n : r) rests_[n] = 0;
  of_point_.reserve(expected);
  reach_.reserve(expected / kContactChunk + 1);
}

template <class Take>
bool NodeForces::find(const ContactPoint& p, const ContactMemory& m, Take&& take) {
  const double normal = m.fn + m.water;
  if (normal == 0.0 && m.ft == 0.0) return false;
  const ContactRow gap = gap_row(p.at), stretch = stretch_row(p.at, m.anchor);
  for (std::size_t k = 0; k < 3; ++k) take(k, normal * gap[k] + m.ft * stretch[k]);
  return true;
}

void NodeForces::find_all(const ContactList& list) {
  const auto points = std::ssize(list.points);
  of_point_.resize(list.points.size());
  reach_.resize(static_cast<std::size_t>((points + kContactChunk - 1) / kContactChunk));
  const auto of_chunk = [&](std::int64_t begin, std::int64_t end) {
    Reach reach{OutlineNode::of(rests_.size()), OutlineNode{0}};
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      OfPoint& of = of_point_[i];
      const ContactPoint& p = list.points[i];
      const auto take = [&of](std::size_t k, const Vec2& force) { of.force[k] = force; };
      if (!find(p, list.memory[i], take)) {
        of.node.fill(OutlineNode{});
        continue;
      }
      std::copy_n(p.node.begin(), 3, of.node.begin());
      const auto [first, last] = std::minmax_element(of.node.begin(), of.node.end());
      reach = {std::min(reach.begin, *first), std::max(reach.end, *last + 1)};
    }
    reach_[static_cast<std::size_t>(begin / kContactChunk)] = reach;
  };
  parallel_for_chunks(points, of_chunk, kFewForces, kContactChunk);
}

template <class OfNode>
void NodeForces::for_moving(OutlineNode begin, OutlineNode end, OfNode&& of_node) const {
  for (const IndexRange<OutlineNode> r : setup_->outlines().moving_nodes)
    for (const OutlineNode n : IndexRange(std::clamp(r.first(), begin, end), std::clamp(r.end_index(), begin, end)))
      of_node(n);
}

void NodeForces::add(const ContactList& list, std::span<double> f) {
  if (list.points.empty()) return;
  const Outlines& o = setup_->outlines();
  const std::int32_t nodes = o.nodes.indices().size();
  const std::int64_t parts = std::ssize(list.points) < kFewForces ? 1 : omp_get_max_threads();
  const auto begin_of = [&](std::int64_t part) { return OutlineNode::of(nodes * part / parts); };
  // The nodes are divided into parts, one per thread. Several parts take the forces from of_point_, which holds what
  // they need of a point in one place: points themselves would move between the caches of the threads in every step.
  if (parts > 1) find_all(list);
  const auto collect = [&](std::int64_t part) {
    const OutlineNode begin = begin_of(part), end = begin_of(part + 1);
    for_moving(begin, end, [&](OutlineNode n) { forces_[n].setZero(); });
    const auto take = [&](OutlineNode n, const Vec2& force) {
      if (n >= begin && n < end && rests_[n] == 0) forces_[n] += force;
    };
    for (std::size_t i = 0; parts == 1 && i < list.points.size(); ++i)
      (void)find(list.points[i], list.memory[i],
                 [&](std::size_t k, const Vec2& force) { take(list.points[i].node[k], force); });
    for (std::size_t c = 0; parts > 1 && c < reach_.size(); ++c) {
      if (!(reach_[c].begin < end) || !(begin < reach_[c].end)) continue;
      const auto chunk = static_cast<std::size_t>(kContactChunk);
      for (std::size_t i = chunk * c; i < std::min(chunk * (c + 1), of_point_.size()); ++i)
        for (std::size_t k = 0; k < 3; ++k) take(of_point_[i].node[k], of_point_[i].force[k]);
    }
  };
  parallel_for(parts, collect, 2);
  // Parts begin with a body here: bodies share no node of the state.
  const auto first_of_body = [&](OutlineNode i) {
    while (i.value > 0 && i.value < nodes && o.node_body[i] == o.node_body[i - 1]) i = i + 1;
    return i;
  };
  const auto pass_on = [&](std::int64_t part) {
    for_moving(first_of_body(begin_of(part)), first_of_body(begin_of(part + 1)), [&](OutlineNode n) {
      if (!forces_[n].isZero(0.0)) add_force(o.nodes[n], forces_[n], f);
    });
  };
  parallel_for(parts, pass_on, nodes < kFewNodes ? parts + 1 : 2);
}

}  // namespace scree::coupling
