// Blocks that slide on steep planes, by every scheme, against a rigid block.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <numbers>
#include <random>
#include <thread>

#include "app/studies/elastic_blocks.h"
#include "app/studies/studies.h"
#include "coupling/stages/driver.h"

namespace scree::app {
namespace {

using coupling::Integrator;

constexpr double kGravity = 9.81;                           // [m/s2]
constexpr double kRamp = 0.5;                               // gravity is applied within [s]
constexpr double kPulse = 3.0, kBegin = 1.0, kWidth = 0.2;  // horizontal half sine down the slope [m/s2], [s]
constexpr double kEnd = 2.6;                                // [s]
constexpr double kElastic = 0.005;                          // runs further from rigid are compared with elastic blocks
constexpr double kSteeper = 2.0;                            // friction than the slope, under a pulse [deg]
constexpr double kThickness = 3.0;                          // of the plane [m]
constexpr double kDensity = 2600.0, kPoisson = 0.2, kBetween = 15.0;  // friction angle between blocks, more [deg]
constexpr double kDegree = std::numbers::pi / 180.0;

enum class Drive { steady, pulse };

struct Shape {
  const char* name;
  Ring ring;  // its base lies on y = 0; down the slope is -x
  [[nodiscard]] Box box() const { return bounds({ring, {}}); }
  [[nodiscard]] Vec2 size() const { return box().hi - box().lo; }
};

struct Setting {
  const Shape* shape = nullptr;
  int row = 1, stack = 1;  // blocks side by side, and on each other
  double slope_deg = 35.0;
  Drive drive = Drive::steady;
  std::string method = "dda";
  Integrator integrator = Integrator::explicit_;
  double dt = 0.0;       // [s]; 0: automatic
  double safety = 0.8;   // of explicit steps
  double covers = 4.0;   // across the lower side of the shape
  double stiffer = 1.0;  // contact stiffness over auto
  double young = 5e10;   // [Pa]
  bool bare = false;     // without damping of any kind

  [[nodiscard]] std::string name() const {
    const std::string kind = row > 1     ? fmt::format("row of {}", row)
                             : stack > 1 ? fmt::format("stack of {}", stack)
                                         : "alone";
    const char* scheme = integrator == Integrator::explicit_  ? "explicit"
                         : integrator == Integrator::implicit ? "implicit"
                                                              : "partitioned";
    return fmt::format("{:<8} {:<10} {:>2} deg {:<6} {} {:<11} {}{}{}{}", shape->name, kind, slope_deg,
                       drive == Drive::steady ? "steady" : "pulse", method, scheme,
                       dt > 0.0 ? fmt::format("dt {:g} ms", 1e3 * dt) : fmt::format("{:g} of the bound", safety),
                       method == "nmm" ? fmt::format(", {:g} covers", covers) : "",
                       stiffer != 1.0 ? fmt::format(", contacts x {:g}", stiffer) : "",
                       fmt::format(", {:g} GPa", young / 1e9));
  }
};

std::vector<Shape> shapes() {
  const auto box = [](double width, double height) { return Ring{{0, 0}, {width, 0}, {width, height}, {0, height}}; };
  return {{"triangle", {{0, 0}, {34.8689, 0}, {20.9303, 9.7598}}},  // 20 m high between 35 and 60 degrees
          {"10 x 10", box(10, 10)},
          {"10 x 5", box(10, 5)},
          {"2 x 1", box(2, 1)},
          {"3 x 1", box(3, 1)}};
}

/// True where the blocks are at least 5 degrees from toppling.
bool stands(const Shape& shape, int stack, double slope_deg) {
  const Box b = shape.box();
  if (shape.ring.size() == 3) return stack == 1;  // flat: it topples at 78 degrees
  return slope_deg + 5.0 <= std::atan((b.hi.x() - b.lo.x()) / (stack * (b.hi.y() - b.lo.y()))) / kDegree + 1e-9;
}

double friction(const Setting& s) {
  const double a = s.slope_deg * kDegree;
  return s.drive == Drive::pulse ? std::tan(a + kSteeper * kDegree) : (std::sin(a) - 0.01) / std::cos(a);
}

/// Accelerations along the plane (downwards) and into it.
Vec2 drive(const Setting& s, double t) {
  const double a = s.slope_deg * kDegree, g = kGravity * std::min(1.0, t / kRamp),
               p = s.drive == Drive::pulse && t > kBegin && t < kBegin + kWidth
                       ? kPulse * std::sin(std::numbers::pi * (t - kBegin) / kWidth)
                       : 0.0;
  return {g * std::sin(a) + p * std::cos(a), g * std::cos(a) - p * std::sin(a)};
}

/// Displacement of a rigid block from `from` on [m], by steps of 1e-5 s with starts and stops at their ends.
double rigid_way(const Setting& s, double from) {
  constexpr double h = 1e-5;
  const double mu = friction(s);
  double v = 0.0, x = 0.0;
  for (int i = 0; i * h < kEnd; ++i) {
    const Vec2 a = drive(s, (i + 0.5) * h);
    const double net = a.x() - mu * std::max(0.0, a.y());
    const double next = v > 0.0 || net > 0.0 ? std::max(0.0, v + h * net) : 0.0;
    if (i * h >= from) x += 0.5 * h * (v + next);
    v = next;
  }
  return x;
}

double p_modulus(const Setting& s) { return Elasticity::from(s.young, kPoisson, Plane::strain).p_modulus(); }

/// Stiffness of contacts that are stiffer than auto, per area [Pa/m].
double contact_stiffness(const Setting& s) {
  const Vec2 size = s.shape->size();
  return s.stiffer * p_modulus(s) / size.minCoeff();
}

Model model_of(const Setting& s, std::vector<BlockId>& sliders) {
  Model model;
  model.gravity = Vec2(0.0, 0.0);
  model.materials.push_back({"rock", kDensity, s.young, kPoisson});
  const Box b = s.shape->box();
  const double width = b.hi.x() - b.lo.x(), height = b.hi.y() - b.lo.y(), mu = friction(s);
  for (const double more : {0.0, kBetween}) {
    JointLaw law;
    law.name = more == 0.0 ? "plane" : "between";
    law.friction = std::atan(mu) + more * kDegree;
    if (s.stiffer != 1.0) law.normal_stiffness = contact_stiffness(s);
    if (s.bare) law.damping = 0.0;
    model.joints.push_back(law);
  }
  model.default_joint = JointId{0};
  const auto add = [&](std::string name, Ring ring, JointId joint) {
    Block block;
    block.name = std::move(name);
    block.polygon = {std::move(ring), {}};
    block.material = MaterialId{0};
    block.joint = joint;
    model.blocks.push_back(block);
    return BlockId{static_cast<std::int32_t>(model.blocks.size()) - 1};
  };
  const BlockId plane = add(
      "plane", {{-40, -kThickness}, {s.row * width + 40, -kThickness}, {s.row * width + 40, 0}, {-40, 0}}, JointId{0});
  model.block_supports.push_back({plane, MotionId{}});
  for (int i = 0; i < s.row; ++i)
    for (int j = 0; j < s.stack; ++j) {
      Ring ring = s.shape->ring;
      for (Vec2& x : ring) x += Vec2(i * width, j * height);
      sliders.push_back(add(fmt::format("block {} {}", i, j), std::move(ring), JointId{1}));
    }
  TimeFunction ramp, pulse;
  ramp.name = "ramp";
  ramp.shape = TimeFunction::Shape::ramp;
  ramp.duration = kRamp;
  pulse.name = "pulse";
  pulse.shape = TimeFunction::Shape::half_sine;
  pulse.start = kBegin;
  pulse.duration = kWidth;
  model.functions = {ramp, pulse};
  const double a = s.slope_deg * kDegree;
  model.body_accelerations.push_back({{}, kGravity * Vec2(-std::sin(a), -std::cos(a)), FunctionId{0}});
  if (s.drive == Drive::pulse)
    model.body_accelerations.push_back({{}, kPulse * Vec2(-std::cos(a), std::sin(a)), FunctionId{1}});
  for (const BlockId id : sliders)
    model.monitors.push_back({model.blocks[id.index()].name, id, moments(model.blocks[id.index()].polygon).centroid});
  return model;
}

struct Ways final : coupling::Sink {
  double from = 0.0;
  std::vector<double> begin, end;  // per block, down the slope [m]
  void history(const coupling::HistoryView& h) override {
    std::vector<double> now;
    for (std::size_t i = 0; i + 1 < h.displacement.size(); i += 2) now.push_back(-h.displacement[i]);
    if (begin.empty() && h.time >= from - 1e-9) begin = now;
    end = now;
  }
};

struct Outcome {
  double error = 0.0;    // of the worst block, over the rigid displacement
  double mean = 0.0;     // of the blocks together, over the rigid displacement
  double elastic = 0.0;  // of the blocks together, over the displacement of elastic ones, if requested
  double closure = 0.0;  // of the ledger

  /// A slide that oscillates is compared with elastic blocks that oscillate.
  [[nodiscard]] double least() const {
    return std::isnan(elastic) ? std::abs(error) : std::min(std::abs(error), std::abs(elastic));
  }
};

/// Displacement of elastic blocks over that of rigid ones, mean of all. Blocks of DDA are affine, with contacts on
/// corners.
/// @param from, rigid  as in slide()
double elastic_mean(const Setting& s, double from, double rigid) {
  ElasticBlocks e;
  e.shape = s.shape->ring;
  e.row = s.row;
  e.stack = s.stack;
  e.degree = s.method == "nmm" ? 6 : 1;  // of the mesh: converged to a fifth of what elasticity adds
  e.points = s.method == "nmm" ? 17 : 2;
  e.density = kDensity;
  e.young = s.young;
  e.poisson = kPoisson;
  e.friction_plane = friction(s);
  e.sliding_damping = std::max(1.0, 2.0 * std::pow(friction(s), 3));  // as SlidingDamping: steep slides flutter more
  e.friction_between = std::tan(std::atan(friction(s)) + kBetween * kDegree);
  if (s.stiffer != 1.0) {
    e.stiffness_plane = e.stiffness_stack = e.stiffness_row = contact_stiffness(s);
  } else {  // auto: over the width, normal to the joint, of the thinner side
    const Vec2 size = s.shape->size();
    e.stiffness_plane = p_modulus(s) / std::min(kThickness, size.y());
    e.stiffness_stack = p_modulus(s) / size.y();
    e.stiffness_row = p_modulus(s) / size.x();
  }
  const auto acceleration = [&](double t) {
    const Vec2 down = drive(s, t);
    return Vec2(-down.x(), -down.y());
  };
  double sum = 0.0;
  const std::vector<double> ways = elastic_ways(e, acceleration, from, kEnd, 0.3);
  for (const double way : ways) sum += way / rigid;
  return sum / static_cast<double>(ways.size());
}

Outcome slide(const Setting& s) {
  std::vector<BlockId> sliders;
  const Model model = model_of(s, sliders);
  const Box b = s.shape->box();
  coupling::Stage stage;
  stage.name = "slide";
  stage.method = s.method;
  stage.integrator = s.integrator;
  stage.duration = ticks(kEnd);
  if (s.dt > 0.0) stage.dt = s.dt;
  stage.safety = s.safety;
  stage.cover_size = std::min(b.hi.x() - b.lo.x(), b.hi.y() - b.lo.y()) / s.covers;
  if (s.bare) stage.sliding_damping = 0.0;
  if (s.integrator == Integrator::partitioned)
    for (std::size_t i = 0; i < sliders.size(); i += 2) stage.partition.explicit_blocks.push_back(sliders[i]);
  coupling::Plan plan;
  plan.stages.push_back(stage);
  plan.output.every = plan.output.history_every = ticks(0.1);
  static const coupling::Methods kMethods = coupling::standard_methods();
  coupling::Driver run(model, plan, kMethods);
  Ways ways;
  // A steady slide is measured from when all of gravity acts: the oscillation while gravity is applied does not count.
  ways.from = s.drive == Drive::pulse ? kBegin : kRamp + 0.1;
  run.add_sink(ways);
  Outcome out;
  if (run.run().status != coupling::RunEnd::Status::done) {
    out.error = out.mean = std::numeric_limits<double>::infinity();
    out.elastic = std::numeric_limits<double>::quiet_NaN();
    out.closure = 1.0;
    return out;
  }
  const double rigid = rigid_way(s, ways.from);
  for (std::size_t i = 0; i < ways.end.size(); ++i) {
    const double error = (ways.end[i] - ways.begin[i]) / rigid - 1.0;
    if (!(std::abs(error) <= std::abs(out.error))) out.error = error;
    out.mean += error / static_cast<double>(ways.end.size());
  }
  out.elastic = std::abs(out.error) > kElastic ? (1.0 + out.mean) / elastic_mean(s, ways.from, rigid) - 1.0
                                               : std::numeric_limits<double>::quiet_NaN();
  out.closure = run.state().ledger.relative_closure();
  return out;
}

/// Every scheme that the blocks of `s` are tried with.
std::vector<Setting> every_scheme(Setting s) {
  std::vector<Setting> out;
  const bool small = s.row == 1 && s.stack == 1;
  for (const char* method : {"dda", "nmm"}) {
    const bool nmm = std::string(method) == "nmm";
    s.method = method;
    s.integrator = Integrator::explicit_;
    s.dt = 0.0;
    for (const double covers : {4.0, 8.0}) {
      if (!nmm && covers > 4.0) continue;
      s.covers = covers;
      for (const double safety : {0.8, 0.2, 0.05}) {
        if (safety < 0.5 && !small) continue;
        s.safety = safety;
        out.push_back(s);
      }
    }
    s.covers = 4.0;
    s.integrator = Integrator::implicit;
    for (const double dt : {5e-3, 1e-3, 2e-4, 5e-5, 2e-5}) {
      if (dt < 1e-4 && (nmm || !small)) continue;
      s.dt = dt;
      out.push_back(s);
    }
    if (small && s.shape->ring.size() == 3) continue;
    s.integrator = Integrator::partitioned;
    s.dt = 1e-3;
    out.push_back(s);
  }
  return out;
}

/// Deals schemes like cards from a shuffled pack, which is shuffled anew when it is used up: each scheme is dealt as
/// often as any other, and almost every scheme meets every slope, shape and drive.
class Pack {
 public:
  [[nodiscard]] std::size_t deal(std::size_t schemes) {
    if (left_.empty() || size_ != schemes) {
      size_ = schemes;
      for (std::size_t i = 0; i < schemes; ++i) left_.push_back(i);
      std::shuffle(left_.begin(), left_.end(), random_);
    }
    const std::size_t next = left_.back();
    left_.pop_back();
    return next;
  }

 private:
  std::mt19937_64 random_{20261122};
  std::vector<std::size_t> left_;
  std::size_t size_ = 0;
};

/// Settings (blocks, slope, drive and contacts) of the long table: if it is whole, each setting is run with two of its
/// schemes, else one setting of every four with one. All schemes of all settings would be 4,600 runs and take a day.
std::vector<Setting> long_table(const std::vector<Shape>& all, bool whole) {
  std::vector<Setting> out;
  std::map<std::size_t, Pack> packs;  // by the number of schemes
  Pack chosen;
  const auto deal = [&](const Setting& s) {
    const std::vector<Setting> schemes = every_scheme(s);
    const bool some = whole || chosen.deal(4) == 0;
    for (const bool first : {true, false}) {
      const Setting& dealt = schemes[packs[schemes.size()].deal(schemes.size())];
      if (!some || (!first && !whole)) continue;
      // While a block slides, the force on its base is inclined by the angle of friction.
      if (stands(*s.shape, s.stack, s.drive == Drive::pulse ? s.slope_deg + kSteeper : s.slope_deg))
        out.push_back(dealt);
    }
  };
  for (const Shape& shape : all)
    for (const double slope : {15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0})
      for (const Drive drive : {Drive::steady, Drive::pulse})
        for (const double stiffer : {1.0, 10.0}) {
          Setting s;
          s.shape = &shape;
          s.slope_deg = slope;
          s.drive = drive;
          s.stiffer = stiffer;
          if (!stands(shape, 1, slope)) continue;
          deal(s);
          if (shape.ring.size() == 3) continue;
          s.row = 5;
          deal(s);
          s.row = 1;
          s.stack = stands(shape, 3, slope) ? 3 : 2;
          if (stands(shape, s.stack, slope)) deal(s);
        }
  return out;
}

/// Of the quick tier: each shape on the steepest slope on which it stands, by explicit DDA, implicit DDA and, where it
/// is not small, explicit NMM.
std::vector<Setting> short_table(const std::vector<Shape>& all) {
  std::vector<Setting> out;
  for (const Shape& shape : all)
    for (const Drive drive : {Drive::steady, Drive::pulse})
      for (const double stiffer : {1.0, 10.0}) {
        Setting s;
        s.shape = &shape;
        s.slope_deg = 45.0;
        while (!stands(shape, 1, s.slope_deg)) s.slope_deg -= 5.0;
        s.drive = drive;
        s.stiffer = stiffer;
        out.push_back(s);
        s.integrator = Integrator::implicit;
        s.dt = drive == Drive::steady ? 1e-3 : 2e-4;
        out.push_back(s);
        s.integrator = Integrator::explicit_;
        s.dt = 0.0;
        s.method = "nmm";
        s.covers = 4.0;
        if (drive == Drive::pulse && shape.box().hi.x() > 5.0 && stiffer > 1.0) out.push_back(s);
      }
  return out;
}

std::string shown(const Outcome& o) {
  std::string rigid = fmt::format("{:+.3f} %", 100.0 * o.error);
  if (std::isnan(o.elastic)) return rigid;
  return fmt::format("{}, all {:+.3f} %, of elastic blocks {:+.3f} %", rigid, 100.0 * o.mean, 100.0 * o.elastic);
}

/// The runs of `settings`, as many at a time as there are threads, each on one thread.
std::vector<Outcome> slide_all(const std::vector<Setting>& settings, bool tell) {
  std::vector<Outcome> out(settings.size());
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  const auto work = [&] {
    omp_set_num_threads(1);
    for (std::size_t i = next++; i < settings.size(); i = next++) {
      const auto begin = std::chrono::steady_clock::now();
      out[i] = slide(settings[i]);
      if (!tell) continue;
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      const std::scoped_lock lock(telling);
      fmt::print(stderr, "{:>4} of {}  {}: {}, {:.1f} s\n", i + 1, settings.size(), settings[i].name(), shown(out[i]),
                 took.count());
    }
  };
  std::vector<std::jthread> workers(static_cast<std::size_t>(omp_get_max_threads()));
  for (std::jthread& worker : workers) worker = std::jthread(work);
  for (std::jthread& worker : workers) worker.join();
  return out;
}

}  // namespace

StudyResult sliding(Tier tier) {
  StudyResult result;
  const std::vector<Shape> all = shapes();
  double worst_steady = 0.0, worst_pulse = 0.0, closure = 0.0;
  const bool told = tier >= Tier::full;
  const std::vector<Setting> settings = told ? long_table(all, tier == Tier::exhaustive) : short_table(all);
  const std::vector<Outcome> outcomes = slide_all(settings, told);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Setting& s = settings[i];
    const Outcome& o = outcomes[i];
    double& worst = s.drive == Drive::steady ? worst_steady : worst_pulse;
    worst = std::max(worst, o.least());
    closure = std::max(closure, o.closure);
    if (told || o.least() > 0.01)
      result.notes.push_back(fmt::format("{}: {}, ledger {:.0e}", s.name(), shown(o), o.closure));
  }
  result.numbers["worst_steady"] = worst_steady;
  result.numbers["worst_pulse"] = worst_pulse;
  result.numbers["closure"] = closure;
  // What is left is elastic: it falls as 1/E.
  for (const double young : {5e9, 5e10, 5e11}) {
    double worst = 0.0;
    for (const Shape& shape : all)
      for (const Drive drive : {Drive::steady, Drive::pulse}) {
        Setting s;
        s.shape = &shape;
        s.drive = drive;
        s.young = young;
        worst = std::max(worst, std::abs(slide(s).error));
      }
    result.numbers[fmt::format("elastic_{:g}", young / 1e9)] = worst;
  }
  // The bare equations flutter.
  Setting bare;
  bare.shape = &all[1];
  bare.drive = Drive::pulse;
  bare.bare = true;
  result.numbers["bare"] = slide(bare).error;
  return result;
}

}  // namespace scree::app
