#include "coupling/contact/search/box_tree.h"

#include <LinearMath/btAlignedAllocator.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <utility>

namespace scree::coupling {
namespace {

constexpr double kTooWide = 1.5;  // times the least extents since it was built: a tree this wide is built anew

/// Bullet uses the memory it receives without a check, and an exception that passes through its trees leaves them in a
/// state that cannot be destroyed: a failed allocation ends the program, as an uncaught exception does.
void* allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) std::terminate();
  return memory;
}
const bool kAllocates = (btAlignedAllocSetCustom(allocate, std::free), true);

btDbvtVolume volume(const Box& box) {
  return btDbvtVolume::FromMM(btVector3(box.lo.x(), box.lo.y(), -1.0), btVector3(box.hi.x(), box.hi.y(), 1.0));
}

/// A number coprime to n, about its golden section: its multiples modulo n are all of 0 .. n - 1, and successive ones
/// lie evenly scattered.
std::size_t scattering(std::size_t n) {
  constexpr double kGoldenSection = 0.6180339887498949;
  auto stride = std::max<std::size_t>(1, static_cast<std::size_t>(kGoldenSection * static_cast<double>(n)));
  while (std::gcd(stride, n) != 1) ++stride;
  return stride;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  leaves_.resize(boxes.size());
  nodes_.reserve(boxes.size());
  // Bullet inserts a box beside the nearest one in the tree. Boxes in the order of a file, row after row, make a tree
  // as deep as a row is long, and the time grows with the square of their number: 20 s for 400,000 of them.
  const std::size_t n = boxes.size(), stride = n > 0 ? scattering(n) : 0;
  for (std::size_t k = 0, i = 0; k < n; ++k, i = (i + stride) % n) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): what the tree stores with a leaf is a pointer
    leaves_[i] = tree_.insert(volume(boxes[i]), reinterpret_cast<void*>(i));
  }
  build();
}

void BoxTree::move(std::size_t i, const Box& box) {
  btDbvtVolume v = volume(box);
  tree_.update(leaves_[i], v);
  nodes_.clear();
}

void BoxTree::place(std::size_t i, const Box& box) { leaves_[i]->volume = volume(box); }

void BoxTree::refit() {
  if (nodes_.empty()) list_nodes();
  const double extents = fit();
  narrowest_ = std::min(narrowest_, extents);
  if (extents > kTooWide * narrowest_) build();
}

void BoxTree::list_nodes() {
  nodes_.clear();
  waiting_.clear();
  const auto wait = [this](btDbvtNode* node) {
    if (node != nullptr && node->isinternal()) waiting_.push_back(node);
  };
  wait(tree_.m_root);
  while (!waiting_.empty()) {
    btDbvtNode* node = waiting_.back();
    waiting_.pop_back();
    nodes_.push_back(node);
    wait(node->childs[0]);
    wait(node->childs[1]);
  }
}

double BoxTree::fit() {
  double extents = 0.0;
  for (auto n = nodes_.rbegin(); n != nodes_.rend(); ++n) {
    btDbvtVolume& v = (*n)->volume;
    Merge((*n)->childs[0]->volume, (*n)->childs[1]->volume, v);
    const btVector3 size = v.Lengths();
    extents += size.x() + size.y();
  }
  return extents;
}

void BoxTree::build() {
  constexpr int kPairUp = 8;  // leaves at most that Bullet joins by trying all pairs
  tree_.optimizeTopDown(kPairUp);
  // A copy has its nodes in memory in the order in which they are visited; those of the tree are scattered.
  struct Leaves final : btDbvt::IClone {
    explicit Leaves(std::vector<btDbvtNode*>& list) : of_boxes(&list) {}
    void CloneLeaf(btDbvtNode* leaf) override { (*of_boxes)[index_of(leaf)] = leaf; }
    std::vector<btDbvtNode*>* of_boxes;
  } leaves(leaves_);
  btDbvt copy;
  tree_.clone(copy, &leaves);
  std::swap(tree_.m_root, copy.m_root);
  list_nodes();
  narrowest_ = fit();
}

}  // namespace scree::coupling
