#include "model/bolt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/model.h"

namespace scree {
namespace {

constexpr double kNear = 1e-6;           // of the bolt's length: the rounding of typed coordinates
constexpr std::size_t kMostNodes = 400;  // of a bolt

/// The piece that contains the point at a distance from the head; nullptr: none.
const BoltPiece* piece_at(const std::vector<BoltPiece>& pieces, double at, double near) {
  for (const BoltPiece& p : pieces)
    if (at >= p.from - near && at <= p.to + near) return &p;
  return nullptr;
}

/// The bond in pieces of nearly equal length, each inside one block.
void add_bond(const std::vector<BoltPiece>& pieces, double begin, double segment, double near, Bolt& bolt) {
  for (const BoltPiece& p : pieces) {
    const double from = std::max(p.from, begin), length = p.to - from;
    if (length <= near) continue;
    const double count = std::max(1.0, std::ceil(length / segment * (1.0 - 1e-9)));
    for (double k = 0.0; k < count; ++k)
      bolt.nodes.push_back({p.block, from + (k + 0.5) / count * length, length / count});
  }
}

void add_crossings(const std::vector<BoltPiece>& pieces, Bolt& bolt) {
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    const BoltPiece &a = pieces[k], &b = pieces[k + 1];
    const auto after = std::find_if(bolt.nodes.begin(), bolt.nodes.end(),
                                    [&](const Bolt::Node& n) { return n.at > 0.5 * (a.to + b.from); });
    if (after == bolt.nodes.begin() || after == bolt.nodes.end()) continue;  // no bar on one side of the crossing
    bolt.crossings.push_back(
        {static_cast<std::int32_t>(after - bolt.nodes.begin()) - 1, a.block, b.block, a.to, b.from});
  }
}

}  // namespace

std::vector<BoltPiece> pieces_in_blocks(const Model& model, const Vec2& a, const Vec2& b) {
  const double length = (b - a).norm();
  const Vec2 along = (b - a) / length, across(-along.y(), along.x());
  std::vector<BoltPiece> out;
  std::vector<double> cuts;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Polygon& polygon = model.blocks[i].polygon;
    cuts.assign({0.0, length});
    for (std::size_t r = 0; r < polygon.rings(); ++r) {
      const Ring& ring = polygon.ring(r);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 p = ring[k] - a, q = ring[(k + 1) % ring.size()] - a;
        const double hp = across.dot(p), hq = across.dot(q);
        if ((hp > 0.0) == (hq > 0.0)) continue;
        const double at = along.dot(p) + hp / (hp - hq) * along.dot(q - p);
        if (at > 0.0 && at < length) cuts.push_back(at);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      if (cuts[k + 1] - cuts[k] <= kNear * length) continue;
      if (!contains(polygon, a + 0.5 * (cuts[k] + cuts[k + 1]) * along)) continue;
      const BlockId block{static_cast<std::int32_t>(i)};
      if (!out.empty() && out.back().block == block && cuts[k] - out.back().to <= kNear * length)
        out.back().to = cuts[k + 1];
      else
        out.push_back({block, cuts[k], cuts[k + 1]});
    }
  }
  std::sort(out.begin(), out.end(), [](const BoltPiece& x, const BoltPiece& y) { return x.from < y.from; });
  return out;
}

std::string lay_out(const Model& model, Bolt& bolt) {
  bolt.nodes.clear();
  bolt.crossings.clear();
  const double length = bolt.length(), near = kNear * length;
  const std::vector<BoltPiece> pieces = pieces_in_blocks(model, bolt.head, bolt.toe);
  if (pieces.empty()) return "it runs through no block";
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k)
    if (pieces[k + 1].from < pieces[k].to - near) return "it runs along the boundary between two blocks";
  const double bond = std::min(bolt.bond_length, length), begin = length - bond;
  const BoltPiece *head = piece_at(pieces, 0.0, near), *toe = piece_at(pieces, length, near);
  if (bolt.plate && head == nullptr) return "its head is in no block";
  if (bond <= 0.0 && toe == nullptr) return "its toe is in no block";
  if (bolt.plate) bolt.nodes.push_back({head->block, 0.0, 0.0});
  if (bond > 0.0) {
    const double segment = bolt.segment > 0.0
                               ? bolt.segment
                               : std::min(bond / 10.0, std::sqrt(bolt.stiffness / bolt.bond_stiffness) / 3.0);
    if (bond / segment > static_cast<double>(kMostNodes))
      return fmt::format("its bond of {:.4g} m would have more than {} pieces of {:.4g} m", bond, kMostNodes, segment);
    add_bond(pieces, begin, segment, near, bolt);
  } else {
    bolt.nodes.push_back({toe->block, length, 0.0});
  }
  if (bolt.nodes.size() < 2) return "its bond lies in no block";
  add_crossings(pieces, bolt);
  return {};
}

}  // namespace scree
