#include "coupling/stages/plan_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>

#include "coupling/bodies/partition.h"
#include "coupling/stages/lasting_loads.h"
#include "coupling/stages/model_warnings.h"
#include "coupling/transfer/transfer.h"

namespace scree::coupling {
namespace {

constexpr std::size_t kMostNames = 5;
constexpr double kSlender = 0.5;  // base over height below which a shaken block is expected to rock
// A block whose base over height is below this times the slope of its base topples by its weight, or nearly does.
constexpr double kTopples = 1.1;
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Groups of blocks that are connected by touching.
struct Groups {
  std::vector<std::int32_t> of;              // per block
  std::vector<std::vector<BlockId>> blocks;  // per group
};

Groups groups_of(std::size_t blocks, const std::vector<Touch>& touches) {
  std::vector<std::size_t> root(blocks);
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const Touch& t : touches) {
    const std::size_t i = find(t.a.index()), j = find(t.b.index());
    root[std::max(i, j)] = std::min(i, j);
  }
  Groups out;
  out.of.assign(blocks, -1);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t r = find(b);
    if (r == b) {
      out.of[b] = static_cast<std::int32_t>(out.blocks.size());
      out.blocks.emplace_back();
    }
    out.of[b] = out.of[r];
    out.blocks[static_cast<std::size_t>(out.of[b])].emplace_back(static_cast<std::int32_t>(b));
  }
  return out;
}

/// Axes, x and y, along which supports hold a group.
std::vector<std::array<bool, 2>> held_axes(const Model& model, const Groups& groups) {
  std::vector<std::array<bool, 2>> held(groups.blocks.size(), {false, false});
  const auto at = [&](BlockId b) -> std::array<bool, 2>& {
    return held[static_cast<std::size_t>(groups.of[b.index()])];
  };
  for (const BlockSupport& s : model.block_supports) at(s.block) = {true, true};
  for (const PointSupport& s : model.point_supports) {
    at(s.block)[0] = at(s.block)[0] || s.fix_x;
    at(s.block)[1] = at(s.block)[1] || s.fix_y;
  }
  for (const EdgeSupport& s : model.edge_supports)
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (s.held.col(static_cast<Eigen::Index>(axis)).norm() > 1e-6) at(s.span.block)[axis] = true;
  return held;
}

bool thrown(const Model& model, BlockId block) {
  return std::any_of(model.initial_velocities.begin(), model.initial_velocities.end(), [&](const InitialVelocity& v) {
    return v.block == block && (v.velocity != Vec2::Zero() || v.spin != 0.0);
  });
}

/// True for methods with affine motion only: damping of the non-affine part has no effect on their blocks.
bool affine(const BodyRequest& request) { return request.method == "dda" || request.form.onefold; }

/// True for a dynamic stage: velocities are physical.
bool dynamic(const Stage& stage) { return !stage.rest && stage.dynamics == 1.0; }

/// Angle of a push into a block from the upward direction, counter-clockwise [rad].
double turned(const Vec2& weight, const Vec2& push) {
  return weight == Vec2::Zero() ? std::numbers::pi : std::atan2(cross(-weight, push), -weight.dot(push));
}

/// Per block 1 where supports hold it, or where forces of standing blocks within their cones of friction can carry a
/// weight: of one of them, or of two on either side of the vertical, as of a slope and of a block below on it.
std::vector<char> standing_blocks(const Model& model, const std::vector<Touch>& touches) {
  std::vector<char> stands(model.blocks.size(), 0);
  for (const BlockSupport& s : model.block_supports) stands[s.block.index()] = 1;
  for (const PointSupport& s : model.point_supports) stands[s.block.index()] = 1;
  for (const EdgeSupport& s : model.edge_supports) stands[s.span.block.index()] = 1;
  struct Sides {  // smallest angles to either side
    double left = std::numeric_limits<double>::infinity(), right = -std::numeric_limits<double>::infinity();
  };
  std::vector<Sides> sides(stands.size());
  const auto carries = [&, weight = weight_direction(model)](BlockId into, const Vec2& push, const Stretch& s) {
    if (!s.law.valid()) return false;
    const JointLaw& law = model.joints[s.law.index()];
    if (law.cohesion > 0.0 || law.tensile_strength > 0.0) return true;
    const double angle = turned(weight, push), least = angle - law.friction, most = angle + law.friction;
    Sides& of = sides[into.index()];
    if (most >= 0.0) of.left = std::min(of.left, std::max(least, 0.0));
    if (least <= 0.0) of.right = std::max(of.right, std::min(most, 0.0));
    return of.left - of.right < std::numbers::pi - 1e-6;
  };
  for (bool grew = true; grew;) {
    grew = false;
    for (const Touch& t : touches)
      for (const Stretch& s : t.facing) {
        const auto lift = [&](BlockId from, BlockId into, const Vec2& push) {
          if (stands[from.index()] == 0 || stands[into.index()] != 0 || !carries(into, push, s)) return;
          stands[into.index()] = 1;
          grew = true;
        };
        lift(t.a, t.b, s.normal);
        lift(t.b, t.a, -s.normal);
      }
  }
  return stands;
}

std::string group_text(const Model& model, const std::vector<BlockId>& blocks, bool held_elsewhere) {
  const Neighbour next = nearest_other(model, blocks);
  const std::string nearest = next.block.valid() ? fmt::format("; the nearest other one, '{}', is {:.3g} m away",
                                                               model.blocks[next.block.index()].name, next.gap)
                                                 : std::string();
  if (blocks.size() == 1)
    return fmt::format(
        "block {} touches nothing{}: it moves off as soon as the run begins; close the gap, or give it a support",
        named_blocks(model, blocks), nearest);
  return fmt::format("blocks {} touch each other, but nothing that is held{}{}", named_blocks(model, blocks), nearest,
                     held_elsewhere ? "; close the gap, or give one of them a support" : "");
}

/// Warning about blocks that supports hold along the other axis only.   @param axis  0: x, 1: y
std::string half_held_text(const Model& model, const std::vector<BlockId>& blocks, int axis) {
  const bool one = blocks.size() == 1;
  return fmt::format("nothing holds {} {} along {}, where {} acts on {}: supports fix {} only",
                     one ? "block" : "blocks", named_blocks(model, blocks), axis == 0 ? 'x' : 'y',
                     model.gravity[axis] != 0.0 ? "gravity" : "a load", one ? "it" : "them", axis == 0 ? 'y' : 'x');
}

}  // namespace

std::string named_blocks(const Model& model, const std::vector<BlockId>& blocks) {
  std::string out;
  const std::size_t shown = blocks.size() > kMostNames + 1 ? kMostNames : blocks.size();
  for (std::size_t i = 0; i < shown; ++i)
    out += fmt::format("{}'{}'",
                       i == 0                   ? ""
                       : i + 1 == blocks.size() ? " and "
                                                : ", ",
                       model.blocks[blocks[i].index()].name);
  if (shown < blocks.size()) out += fmt::format(" and {} more", blocks.size() - shown);
  return out;
}

std::vector<std::string> support_warnings(const Model& model, const std::vector<Touch>& touches,
                                          const std::vector<BlockId>& absent) {
  const auto there = [&](BlockId b) { return std::find(absent.begin(), absent.end(), b) == absent.end(); };
  std::vector<Touch> at_start;
  std::copy_if(touches.begin(), touches.end(), std::back_inserter(at_start),
               [&](const Touch& t) { return there(t.a) && there(t.b); });
  const Groups groups = groups_of(model.blocks.size(), at_start);
  const std::vector<std::array<bool, 2>> held = held_axes(model, groups);
  std::vector<LastingForce> force(groups.blocks.size());
  add_lasting_loads(model, groups.of, force);
  const bool no_support = model.block_supports.empty() && model.point_supports.empty() && model.edge_supports.empty();
  std::vector<std::string> out;
  std::vector<BlockId> alone;
  std::vector<std::string> found;
  bool all_free = true, all_thrown = true, moved = false;
  for (std::size_t g = 0; g < groups.blocks.size(); ++g) {
    const std::vector<BlockId>& blocks = groups.blocks[g];
    if (!there(blocks.front())) continue;  // alone in its group
    const bool on_its_way = std::all_of(blocks.begin(), blocks.end(), [&](BlockId b) { return thrown(model, b); });
    all_thrown = all_thrown && on_its_way;
    all_free = all_free && !held[g][0] && !held[g][1];
    for (int axis = 0; axis < 2; ++axis) {
      if (!force[g].acts(axis) || held[g][static_cast<std::size_t>(axis)]) continue;
      moved = true;
      if (on_its_way || no_support) continue;
      if (held[g][static_cast<std::size_t>(1 - axis)])
        found.push_back(half_held_text(model, blocks, axis));
      else if (blocks.size() == 1)
        alone.push_back(blocks.front());
      else
        found.push_back(group_text(model, blocks, true));
      break;
    }
  }
  if (no_support && moved && !all_thrown)
    out.push_back(
        fmt::format("nothing holds the model: the case has no [[support]], and {} moves all of it from the beginning{}",
                    model.gravity != Vec2::Zero() ? "gravity" : "a load that lasts",
                    model.viscous_edges.empty() ? "" : " (viscous edges only slow it down: the model sinks on them)"));
  out.insert(out.end(), found.begin(), found.end());
  for (std::size_t i = 0; i < alone.size() && i < kMostNames; ++i) out.push_back(group_text(model, {alone[i]}, true));
  if (alone.size() > kMostNames)
    out.push_back(fmt::format("{} more blocks touch nothing: {}", alone.size() - kMostNames,
                              named_blocks(model, {alone.begin() + kMostNames, alone.end()})));
  return out;
}

std::vector<std::string> damping_warnings(const Model& model, const Plan& plan) {
  std::vector<std::string> out;
  for (const Stage& stage : plan.stages) {
    const std::vector<BodyRequest> request = body_requests(model, stage);
    bool free = false, bends = stage.change.used && stage.change.back.used();
    for (std::size_t b = 0; b < request.size(); ++b) {
      if (model.support_of(BlockId(static_cast<std::int32_t>(b))) != nullptr) continue;
      free = true;
      bends = bends || !affine(request[b]);
    }
    const bool any = stage.damping > 0.0 || stage.stiffness_damping > 0.0 || stage.local_damping > 0.0;
    if (any && !free)
      out.push_back(fmt::format("stage '{}': its damping acts on nothing: all blocks are held", stage.name));
    else if (stage.damping > 0.0 && !stage.damp_rigid_motion && !bends)
      out.push_back(fmt::format(
          "stage '{}': damping = {:g} acts on nothing: it does not damp affine motion, and blocks of the DDA and under "
          "onefold covers have no other motion; stiffness_damping acts on their strain, damp_rigid_motion = true on "
          "all of their motion",
          stage.name, stage.damping));
  }
  return out;
}

std::vector<std::string> partition_warnings(const Model& model, const Plan& plan) {
  std::vector<std::string> out;
  for (const Stage& stage : plan.stages) {
    if (stage.integrator != Integrator::partitioned) continue;
    const auto takes = [&](const Partition& rule) {
      const std::vector<char> sides = first_sides(model, rule);
      for (std::size_t b = 0; b < sides.size(); ++b)
        if (sides[b] != 0 && model.support_of(BlockId(static_cast<std::int32_t>(b))) == nullptr) return true;
      return false;
    };
    Partition area, region;
    area.explicit_area = stage.partition.explicit_area;
    region.explicit_region = stage.partition.explicit_region;
    if (area.explicit_area > 0.0 && !takes(area))
      out.push_back(fmt::format("stage '{}': explicit_area = {:g} m2 makes no block explicit: no free one is smaller",
                                stage.name, area.explicit_area));
    if (!region.explicit_region.empty() && !takes(region))
      out.push_back(
          fmt::format("stage '{}': explicit_region makes no block explicit: no free one lies in it", stage.name));
  }
  return out;
}

std::vector<std::string> sliding_warnings(const Model& model, const Plan& plan, const std::vector<Touch>& touches) {
  const SlidingNeeds needs;
  const auto stage = std::find_if(plan.stages.begin(), plan.stages.end(), dynamic);
  if (stage == plan.stages.end()) return {};
  const Vec2 pull = weight_direction(model);
  if (pull == Vec2::Zero()) return {};
  std::vector<double> steepest(model.joints.size(), -1.0);  // per joint law [rad]
  for (const Touch& touch : touches) {
    const bool a_held = model.support_of(touch.a) != nullptr, b_held = model.support_of(touch.b) != nullptr;
    if (a_held && b_held) continue;
    for (const Stretch& s : touch.facing) {
      if (!s.law.valid()) continue;
      const double slope = std::acos(std::min(1.0, std::abs(s.normal.dot(pull)) / pull.norm()));
      steepest[s.law.index()] = std::max(steepest[s.law.index()], slope);
    }
  }
  std::vector<std::string> out;
  double rough = -1.0;  // steepest joint with at least the friction needs.angle [rad]
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const JointLaw& law = model.joints[j];
    if (steepest[j] < needs.angle || law.friction < needs.angle) continue;
    rough = std::max(rough, steepest[j]);
    if (law.damping >= needs.joint_damping) continue;
    out.push_back(fmt::format(
        "joint '{}': damping = {:g} is less than sliding requires, {:g}: on joints as steep as {:.0f} degrees with "
        "{:.0f} degrees of friction blocks may hop on their contacts and slide too far, as undamped equations do; "
        "leave the key out unless that is what you study",
        law.name, law.damping, needs.joint_damping, steepest[j] * kDegrees, law.friction * kDegrees));
  }
  for (const Stage& s : plan.stages)
    if (rough >= 0.0 && dynamic(s) && s.sliding_damping < needs.stage_damping)
      out.push_back(fmt::format(
          "stage '{}': sliding_damping = {:g} is less than sliding requires, {:g}: on joints as steep as {:.0f} "
          "degrees blocks may vibrate, lose friction and slide too far; leave the key out unless that is what you "
          "study",
          s.name, s.sliding_damping, needs.stage_damping, rough * kDegrees));
  return out;
}

std::vector<std::string> arch_warnings(const Model& model, const Plan& plan, const std::vector<Touch>& touches) {
  const std::vector<BlockId> stones = stones_of_arches(model, touches);
  if (stones.empty()) return {};
  std::vector<std::string> out;
  for (const Stage& stage : plan.stages) {
    const std::vector<BodyRequest> request = body_requests(model, stage);
    // Blocks of the NMM with joints of automatic stiffness, which a mesh divides.
    const auto divided = [&](BlockId b) {
      const BodyRequest& w = request[b.index()];
      return w.method == "nmm" && !w.form.onefold && std::any_of(touches.begin(), touches.end(), [&](const Touch& t) {
               return (t.a == b || t.b == b) && std::any_of(t.facing.begin(), t.facing.end(), [&](const Stretch& s) {
                        const bool automatic = !s.law.valid() || (!model.joints[s.law.index()].normal_stiffness &&
                                                                  !model.joints[s.law.index()].penalty);
                        return automatic && s.length > w.form.cover_size;
                      });
             });
    };
    std::vector<BlockId> soft;
    std::copy_if(stones.begin(), stones.end(), std::back_inserter(soft), divided);
    if (soft.empty()) continue;
    out.push_back(fmt::format(
        "stage '{}': {} {} carried by thrust alone, as a stone of an arch, on joints with normal_stiffness = "
        "\"auto\" that the NMM divides: a hinge is softer there than at the two points of a joint of the DDA, and "
        "the limit of an arch changes by about 3 %; a normal_stiffness ten times the automatic one, or the DDA, is "
        "closer to rigid blocks",
        stage.name, soft.size() == 1 ? "block" : "blocks",
        named_blocks(model, soft) + (soft.size() == 1 ? " is" : " are")));
    break;  // later stages would repeat the warning
  }
  return out;
}

std::vector<std::string> rocking_warnings(const Model& model, const Plan& plan, const std::vector<Touch>& touches) {
  const bool shaken = std::any_of(model.block_supports.begin(), model.block_supports.end(),
                                  [](const BlockSupport& s) { return s.motion.valid(); }) ||
                      std::any_of(model.body_accelerations.begin(), model.body_accelerations.end(),
                                  [](const BodyAcceleration& a) { return a.function.valid(); });
  const Vec2 weight = weight_direction(model);
  if (weight == Vec2::Zero()) return {};
  const Vec2 up = -weight.normalized();
  struct Base {
    double length = 0.0, friction = 0.0;
    Vec2 push{0.0, 0.0};  // into the block
    bool automatic = true, alone = true;
  };
  std::vector<Base> bases(model.blocks.size());
  const auto stand = [&](BlockId b, const Vec2& push, const Stretch& s) {
    Base& base = bases[b.index()];
    if (!s.law.valid() || up.dot(push) < std::numbers::sqrt2 / 2.0) {
      base.alone = false;
      return;
    }
    const JointLaw& law = model.joints[s.law.index()];
    base.length += s.length;
    base.push = push;
    base.friction = std::max(base.friction, law.friction);
    base.automatic = base.automatic && !law.normal_stiffness && !law.penalty && law.tensile_strength == 0.0;
  };
  for (const Touch& t : touches)
    for (const Stretch& s : t.facing) {
      stand(t.b, s.normal, s);
      stand(t.a, -s.normal, s);
    }
  const auto rocks = [&](BlockId b) {
    const Base& base = bases[b.index()];
    if (!base.alone || !base.automatic || base.length == 0.0 || model.support_of(b) != nullptr) return false;
    const auto height = [&](const Vec2& along) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Vec2& x : model.blocks[b.index()].polygon.outer) {
        low = std::min(low, along.dot(x));
        high = std::max(high, along.dot(x));
      }
      return high - low;
    };
    // It rocks before it slides: because it is shaken, or because its weight acts beyond its base or near its end.
    const double rough = std::tan(base.friction), leans = std::abs(cross(up, base.push)) / up.dot(base.push);
    return (shaken && base.length < std::min(kSlender, rough) * height(up)) ||
           base.length < std::min(kTopples * leans, rough) * height(base.push);
  };
  for (const Stage& stage : plan.stages) {
    if (!dynamic(stage)) continue;
    const std::vector<BodyRequest> request = body_requests(model, stage);
    std::vector<BlockId> soft;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      const BodyRequest& w = request[i];
      const BlockId b{static_cast<std::int32_t>(i)};
      if (w.method == "nmm" && !w.form.onefold && rocks(b) && bases[i].length > w.form.cover_size) soft.push_back(b);
    }
    if (soft.empty()) continue;
    return {fmt::format(
        "stage '{}': {} {} rock on a joint with normal_stiffness = \"auto\" that the NMM divides: its edge is "
        "compliant, so that a block rocks or topples farther than a rigid one, by a fifth or more under a short pulse "
        "or in the first second, and overturns somewhat earlier; a normal_stiffness a hundred times the automatic one, "
        "or the DDA, is closer to "
        "rigid blocks",
        stage.name, soft.size() == 1 ? "block" : "blocks", named_blocks(model, soft) + " may")};
  }
  return {};
}

std::vector<std::string> hand_over_warnings(const Model& model, const Plan& plan) {
  for (std::size_t k = 1; k < plan.stages.size(); ++k) {
    const Stage &before = plan.stages[k - 1], &stage = plan.stages[k];
    if (!dynamic(stage)) continue;
    const std::vector<BodyRequest> had = body_requests(model, before), has = body_requests(model, stage);
    std::vector<BlockId> blocks;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      const BlockId b{static_cast<std::int32_t>(i)};
      const auto& absent = before.construction.absent;
      const bool there = std::find(absent.begin(), absent.end(), b) == absent.end();
      if (there && model.support_of(b) == nullptr && affine(had[i]) && !affine(has[i])) blocks.push_back(b);
    }
    if (blocks.empty()) continue;
    return {fmt::format(
        "stage '{}': {} {} from one cover or the DDA to a mesh of the NMM under load: stress and contact forces of an "
        "affine block are not in balance in its mesh, and oscillate by a fifth or more in the first milliseconds, "
        "which can break a joint near its limit; put a stage with this method and rest = true before",
        stage.name, named_blocks(model, blocks), blocks.size() == 1 ? "passes" : "pass")};
  }
  return {};
}

std::vector<BlockId> stones_of_arches(const Model& model, const std::vector<Touch>& touches) {
  const std::size_t n = model.blocks.size();
  const std::vector<char> stands = standing_blocks(model, touches);
  // Blocks that do not stand form connected groups; standing blocks may push a group from the left, the right, or both.
  std::vector<Touch> among;
  std::copy_if(touches.begin(), touches.end(), std::back_inserter(among), [&](const Touch& t) {
    return stands[t.a.index()] == 0 && stands[t.b.index()] == 0 && !t.facing.empty();
  });
  const Groups groups = groups_of(n, among);
  std::vector<std::array<bool, 2>> pushed(groups.blocks.size(), {false, false});
  const auto push = [&, weight = weight_direction(model)](BlockId from, BlockId into, const Vec2& direction) {
    if (stands[from.index()] == 0 || stands[into.index()] != 0) return;
    const double angle = turned(weight, direction);
    if (std::abs(angle) > 0.5 * std::numbers::pi + 1e-6) return;  // from above
    pushed[static_cast<std::size_t>(groups.of[into.index()])][angle > 0.0 ? 0 : 1] = true;
  };
  for (const Touch& t : touches)
    for (const Stretch& s : t.facing) {
      push(t.a, t.b, s.normal);
      push(t.b, t.a, -s.normal);
    }
  std::vector<BlockId> stones;
  for (std::size_t b = 0; b < n; ++b)
    // One block between two sides, as in a notch, has no hinge that could open.
    if (const auto group = static_cast<std::size_t>(groups.of[b]);
        stands[b] == 0 && pushed[group] == std::array{true, true} && groups.blocks[group].size() > 1)
      stones.emplace_back(static_cast<std::int32_t>(b));
  return stones;
}

std::vector<std::string> plan_warnings(const Model& model, const Plan& plan) {
  const std::vector<Touch> touches = touching_blocks(model);
  std::vector<std::string> out = support_warnings(model, touches, plan.stages.front().construction.absent);
  for (const auto& more :
       {damping_warnings(model, plan), partition_warnings(model, plan), sliding_warnings(model, plan, touches),
        arch_warnings(model, plan, touches), rocking_warnings(model, plan, touches), hand_over_warnings(model, plan),
        stiffness_warnings(model), size_warnings(model), unit_warnings(model), weight_warnings(model),
        lawless_warnings(model, touches)})
    out.insert(out.end(), more.begin(), more.end());
  return out;
}

}  // namespace scree::coupling
