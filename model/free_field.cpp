#include "model/free_field.h"

#include <algorithm>
#include <cmath>

#include "model/edge_selection.h"

namespace scree {
namespace {

constexpr double kStraight = 2e-5;  // of the largest velocity: tolerated error of linear interpolation
constexpr double kSpan = 6.0;       // height of a stretch with one traction: path of a shear wave in so many steps
constexpr double kMostTimes = 2e5;
constexpr double kLeastStretches = 8.0, kMostStretches = 256.0;  // of the height
constexpr const char* kName = "free_field.";

double speed_of(const Model& model, MaterialId id, int axis) {
  const Material& m = model.materials[id.index()];
  const Elasticity law = Elasticity::from(m.young, m.poisson, model.plane);
  return std::sqrt((axis == 0 ? law.mu : law.p_modulus()) / m.density);
}

/// Step of tables of a motion's velocity [s]. If the acceleration is linear between samples, v is a parabola between
/// them and linear interpolation has the error v'' step^2/8. If it is constant, v has kinks and the error is the jump
/// of v' times step/4.
double time_step(const GroundMotion& motion, double largest) {
  const std::vector<double>&t = motion.times(), &a = motion.accelerations();
  double rate = 0.0, jump = 0.0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    rate = std::max(rate, std::abs(a[i] - a[i - 1]) / (t[i] - t[i - 1]));
    jump = std::max(jump, std::abs(a[i] - a[i - 1]));
  }
  if (motion.setting().between == Between::linear) return std::sqrt(8.0 * kStraight * largest / rate);
  return 100.0 * kStraight * largest / jump;
}

double step_of(const Model& model, const FreeField& ground, MaterialId material, double until) {
  const GroundMotion& motion = model.motions[ground.motion.index()];
  const double height = ground.top - ground.bottom, quick = height / speed_of(model, material, 1);
  return std::max(std::min(time_step(motion, motion.facts().pgv), quick / kLeastStretches), until / kMostTimes);
}

}  // namespace

GroundHistory ground_history(const Model& model, const FreeField& ground, MaterialId material, int axis, double height,
                             double until) {
  const GroundMotion& motion = model.motions[ground.motion.index()];
  const double part = ground.upgoing * motion.direction()[axis], H = ground.top - ground.bottom;
  GroundHistory out;
  if (part == 0.0 || motion.facts().pgv == 0.0 || !(until > 0.0)) return out;
  const double c = speed_of(model, material, axis), y = std::clamp(height - ground.bottom, 0.0, H), echo = 2.0 * H / c;
  // The step divides the time of the echo, so that the reflection from a rigid base is an earlier entry of the table.
  const auto steps = static_cast<std::size_t>(std::ceil(echo / step_of(model, ground, material, until)));
  const double step = echo / static_cast<double>(steps);
  const double duration = motion.times().back() - motion.times().front();
  const double end = ground.rigid ? until : std::min(until, duration + echo + step);
  const auto u = [&](double t) {
    return part * motion.velocity(motion.setting().start + t).dot(motion.direction()) /
           motion.direction().squaredNorm();
  };
  for (std::size_t n = 0; static_cast<double>(n) * step < end; ++n) {
    const double t = static_cast<double>(n) * step, up = u(t - y / c), down = u(t - (2.0 * H - y) / c);
    const bool back = ground.rigid && n >= steps;
    out.time.push_back(t);
    out.velocity.push_back(up + down - (back ? out.velocity[n - steps] : 0.0));
    out.stress.push_back(down - up - (back ? out.stress[n - steps] : 0.0));
  }
  if (out.time.size() < 2) return {};
  return out;
}

void add_free_field(Model& model, const std::vector<EdgeSpan>& sides, const FreeField& ground, double until) {
  const GroundMotion& motion = model.motions[ground.motion.index()];
  const auto function = [&](const std::vector<double>& time, std::vector<double> values) {
    TimeFunction f;
    f.name = kName + motion.setting().name;
    f.shape = TimeFunction::Shape::table;
    f.start = motion.setting().start;
    f.stage = motion.setting().stage;
    f.time = time;
    f.table = std::move(values);
    f.of_load = true;
    model.functions.push_back(std::move(f));
    return FunctionId{static_cast<std::int32_t>(model.functions.size()) - 1};
  };
  for (const EdgeSpan& side : sides) {
    model.viscous_edges.push_back({side});
    const Block& block = model.blocks[side.block.index()];
    const double density = model.material_of(side.block).density, H = ground.top - ground.bottom;
    const Elasticity law = model.elasticity_of(side.block);
    const double c_s = speed_of(model, block.material, 0), c_p = speed_of(model, block.material, 1);
    const auto [from, to] = ends_of(block.polygon, side.edge);
    const Vec2 n = outward_normal(block.polygon, side.edge);
    const double most = std::clamp(kSpan * c_s * step_of(model, ground, block.material, until), H / kMostStretches,
                                   H / kLeastStretches);
    const double length = length_of(model, side), count = std::ceil(length / most);
    const Mat2 impedance = density * (c_p * n * n.transpose() + c_s * (Mat2::Identity() - n * n.transpose()));
    for (double i = 0.0; i < count; ++i) {
      EdgeSpan stretch = side;
      stretch.s0 = side.s0 + (side.s1 - side.s0) * (i / count);
      stretch.s1 = i + 1.0 < count ? side.s0 + (side.s1 - side.s0) * ((i + 1.0) / count) : side.s1;
      const double middle = 0.5 * (stretch.s0 + stretch.s1), y = (1.0 - middle) * from.y() + middle * to.y();
      for (const int axis : {0, 1}) {
        GroundHistory h = ground_history(model, ground, block.material, axis, y, until);
        if (h.time.empty()) continue;
        Mat2 stress;  // at 1 m/s of the table
        const double wave = density * (axis == 0 ? c_s : c_p);
        stress << (axis == 0 ? 0.0 : law.lambda / law.p_modulus() * wave), (axis == 0 ? wave : 0.0),
            (axis == 0 ? wave : 0.0), (axis == 0 ? 0.0 : wave);
        model.tractions.push_back({stretch, impedance.col(axis), function(h.time, std::move(h.velocity))});
        model.tractions.push_back({stretch, stress * n, function(h.time, std::move(h.stress))});
      }
    }
  }
}

bool of_free_field(const Model& model, FunctionId function) {
  return function.valid() && model.functions[function.index()].of_load &&
         model.functions[function.index()].name.starts_with(kName);
}

}  // namespace scree
