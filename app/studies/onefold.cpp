#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/studies/studies.h"
#include "coupling/contact/table/contact_finder.h"
#include "coupling/onefold/onefold_forms.h"
#include "coupling/transfer/transfer.h"
#include "model/dense_algebra.h"

namespace scree::app {
namespace {

using namespace coupling;

constexpr double kOnefoldStep = 1e-3, kOnefoldGravity = 9.81;  // [s], [m/s2]

Polygon box(double x0, double y0, double x1, double y1) { return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}; }

/// Two blocks, 1 m and 0.8 m wide, one on the other on a floor as wide as the model.
Model stack(double width) {
  Model model;
  model.materials.push_back({"rock", 2600.0, 1e10, 0.25});
  JointLaw law;
  law.name = "joint";
  model.joints.push_back(law);
  model.default_joint = JointId{0};
  const double x = 0.3 * (width - 1.0);
  for (const auto& [name, polygon] :
       {std::pair("floor", box(0.0, -0.2, width, 0.0)), std::pair("lower", box(x, 0.0, x + 1.0, 0.4)),
        std::pair("upper", box(x + 0.1, 0.4, x + 0.9, 0.8))}) {
    Block block;
    block.name = name;
    block.polygon = polygon;
    block.material = MaterialId{0};
    block.joint = JointId{0};
    model.blocks.push_back(block);
  }
  model.block_supports.push_back({BlockId{0}, MotionId{}});
  return model;
}

/// One step of the stack in both forms: A d = weight, corners move by reach d.
struct Forms {
  OnefoldForms of;
  Eigen::VectorXd weight_stars, weight;
  Eigen::MatrixXd reach_stars, reach;
};

Forms forms_of(double width, bool model_triangle) {
  const Model model = stack(width);
  Stage stage;
  stage.method = "nmm";
  stage.integrator = Integrator::implicit;
  for (std::int32_t b = 0; b < 3; ++b) stage.rules.push_back({{BlockId{b}}, "nmm", 0.0, true, model_triangle});
  const Methods methods = standard_methods();
  const Setup setup(model, methods, initial_records(model, body_requests(model, stage)));
  std::vector<double> q(2 * static_cast<std::size_t>(setup.nodes()), 0.0), v = q, f = q;
  for (const Body& b : setup.bodies()) {
    AffineMotion at;
    at.c = b.centre;
    setup.pool_of(b).place(b.index, at, q, v);
  }
  ContactFinder finder(setup, 0.01);
  ContactList none, contacts;
  finder.find(q, none, true, contacts);
  Forms out;
  out.of = onefold_forms(setup, q, contacts);
  const std::size_t free = setup.own_pools()[0];
  setup.pool(free).body_force(Vec2(0.0, -kOnefoldGravity), setup.part(std::span<double>(f), free));
  const Eigen::Index n = out.of.map.rows();
  const auto begin = 2 * static_cast<Eigen::Index>(setup.pool_first(free));  // of the free blocks
  out.weight_stars = Eigen::Map<const Eigen::VectorXd>(f.data() + begin, n);
  out.weight = Eigen::VectorXd::Zero(n);
  const Outlines& o = setup.outlines();
  out.reach = out.reach_stars = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(o.nodes.size()), n);
  for (const OutlineNode k : o.nodes.indices()) {
    if (o.node_body[k] == BodyIndex{0}) continue;
    const Body& b = setup.body(o.node_body[k]);
    const auto r = 2 * static_cast<Eigen::Index>(k.index()),
               first = static_cast<Eigen::Index>(2 * b.first_node) - begin;
    const ChartRow row = setup.pool_of(b).chart_row(b.index, setup.local(b, o.nodes[k]), q);
    for (std::size_t u = 0; u < static_cast<std::size_t>(row.n); ++u) {
      out.reach(r, first + row.dof[u]) = row.tx[u];
      out.reach(r + 1, first + row.dof[u]) = row.ty[u];
    }
    for (std::size_t s = 0; s < 3; ++s)
      for (Eigen::Index d = 0; d < 2; ++d)
        out.reach_stars(r + d, 2 * static_cast<Eigen::Index>(o.nodes[k].node[s]) - begin + d) = o.nodes[k].w[s];
    const double mass = setup.pool_of(b).totals(b.index, q, v).mass;
    out.weight[first + 1] = -kOnefoldGravity * mass;
  }
  return out;
}

double slope(const std::vector<double>& x, const std::vector<double>& y, std::size_t from) {
  return std::log(y.back() / y[from]) / std::log(x.back() / x[from]);
}

}  // namespace

StudyResult onefold(Tier) {
  StudyResult out;
  std::vector<double> width, step, mass, step_centroidal, mass_centroidal;
  double contact_error = 0.0, worst = 0.0, most = 0.0;
  for (int i = 0; i <= 6; ++i) {
    const double L = std::pow(10.0, 0.5 * i);
    const Forms f = forms_of(L, true);
    const OnefoldForms& of = f.of;
    const Eigen::MatrixXd A = of.stars.of_step(kOnefoldStep), B = of.centroidal.of_step(kOnefoldStep);
    width.push_back(L);
    step.push_back(condition_number(A));
    mass.push_back(condition_number(of.stars.mass));
    step_centroidal.push_back(condition_number(B));
    mass_centroidal.push_back(condition_number(of.centroidal.mass));
    const Eigen::MatrixXd mapped = of.stars.rows * of.map;
    const Eigen::MatrixXd contact = of.centroidal.contact(),
                          off = mapped.transpose() * of.stars.springs.asDiagonal() * mapped - contact;
    contact_error = std::max(contact_error, off.norm() / contact.norm());
    // The same step solved in either form: displacements of the corners.
    const Eigen::VectorXd u_stars = f.reach_stars * solve_symmetric(A, f.weight_stars),
                          u = f.reach * solve_symmetric(B, f.weight);
    const double apart = (u_stars - u).lpNorm<Eigen::Infinity>() / u.lpNorm<Eigen::Infinity>();
    most = std::max(most, apart);
    worst = std::max(worst, apart / (std::numeric_limits<double>::epsilon() * step.back()));
    out.notes.push_back(
        fmt::format("model/block {:7.1f}: stars {:.3g} (mass {:.3g}), centroidal {:.3g} (mass {:.3g}), "
                    "solutions apart {:.1e}",
                    L, step.back(), mass.back(), step_centroidal.back(), mass_centroidal.back(), apart));
  }
  const std::size_t from = 2;  // from ten blocks to a model
  out.numbers["step_power"] = slope(width, step, from);
  out.numbers["mass_power"] = slope(width, mass, from);
  out.numbers["step_stars_1000"] = step.back();
  out.numbers["step_centroidal_1"] = step_centroidal.front();
  out.numbers["step_centroidal_1000"] = step_centroidal.back();
  out.numbers["step_centroidal_spread"] =
      *std::max_element(step_centroidal.begin(), step_centroidal.end()) / step_centroidal.front();
  out.numbers["step_own_triangle"] = condition_number(forms_of(1000.0, false).of.stars.of_step(kOnefoldStep));
  out.numbers["contact_error"] = contact_error;
  out.numbers["solutions_apart"] = most;
  out.numbers["apart_over_condition"] = worst;
  std::vector<double> square;
  square.reserve(width.size());
  for (const double L : width) square.push_back(mass.back() * std::pow(L / width.back(), 2));
  out.plots.push_back({"Onefold covers: condition by the size of the model",
                       "model size over block size",
                       "condition number",
                       {{"stars, step", width, step, true},
                        {"stars, mass", width, mass, true},
                        {"square of the ratio", width, square, false, true},
                        {"centroidal, step", width, step_centroidal, true},
                        {"centroidal, mass", width, mass_centroidal, true}},
                       true,
                       true});
  return out;
}

}  // namespace scree::app
