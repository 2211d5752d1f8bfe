#include "nmm/nmm_pool.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/local_origin.h"
#include "model/mesh_error.h"
#include "model/planar.h"
#include "nmm/field_projection.h"

namespace scree::nmm {
namespace {

/// Least certified step, as a fraction of the uncut mesh's 0.866 h/c_p, for which a block keeps its mesh: narrower
/// blocks than 1.5 covers can have less, and then do better on a onefold cover (docs/theory/kinematics-and-nmm.md,
/// "Ties").
constexpr double kLeastStep = 0.25;

bool keeps_its_step(const CoverMesh& mesh, const ReferenceShape& shape, const Formulation& form,
                    const Elasticity& law) {
  LumpedMass mass;
  if (!mass.add(mesh, 0, shape, form.mass)) return false;
  CoverChart chart;
  chart.add(mesh, 0);
  chart.finish();
  const FrequencyBound bound = frequency_bound_of(mesh, chart, 0, mass.lumped(), 1.0, law);
  const double density = shape.mass / shape.area,
               uncut = std::sqrt(3.0) / 2.0 * form.cover_size / std::sqrt(law.p_modulus() / density),
               step = 2.0 / std::sqrt(mass.theta(0, static_cast<std::int32_t>(mesh.star.size())) * bound.lambda);
  return step >= kLeastStep * uncut;
}

}  // namespace

bool NmmPool::lumps(const Formulation& form) {
  return form.mass != MassKind::consistent ||
         (form.division.divides() && form.division.acts != Division::Acts::implicit_half);
}

bool NmmPool::has_consistent(const Formulation& form) {
  return form.mass == MassKind::consistent &&
         !(form.division.divides() && form.division.acts == Division::Acts::explicit_half);
}

CoverMesh NmmPool::make_mesh(const Model& model, const BodyRecord& record, const AffineMotion& to_origin) {
  const Formulation& form = record.form;
  std::vector<CutLine> cracks;
  if (form.cracks) {
    const Mat2 back = to_origin.F.inverse();
    for (const Crack& c : model.cracks)
      if (c.block == record.block) cracks.push_back({back * (c.from - to_origin.c), back * (c.to - to_origin.c)});
  }
  std::function<bool(const Vec2&)> explicit_at;
  const Polygon region{form.division.region, {}};
  if (form.division.divides())
    explicit_at = [&](const Vec2& X) { return contains(region, to_origin.c + to_origin.F * X); };
  CoverMesh mesh =
      make_cover_mesh(record.shape.outline, form.cover_size, {form.offset_x, form.offset_y}, cracks, explicit_at);
  if (!mesh.onefold && cracks.empty() && !keeps_its_step(mesh, record.shape, form, model.elasticity_of(record.block)))
    mesh = make_onefold(record.shape.outline);
  return mesh;
}

void NmmPool::find_whole_inverse(Body& body) {
  const CoverMesh& mesh = *body.whole;
  body.whole_chart.add(mesh, 0);
  body.whole_chart.finish();
  body.whole_inverse = row_sums(mesh, body.shape.mass / mesh.drawn_area());
  for (std::size_t k = 0; k < mesh.star.size(); ++k) {
    double& mass = body.whole_inverse[k];
    if (body.whole_chart.tied(static_cast<std::int32_t>(k))) continue;
    if (!(mass > 0.0))
      throw MeshError(fmt::format(
          "block '{}' cannot be divided by the explicit region: a cover of one half has no lumped mass; move the "
          "region's border, or choose another cover_size",
          body.name));
    mass = 1.0 / mass;
  }
}

void NmmPool::divide(Body& body) {
  CoverMesh& mesh = body.mesh;
  const auto refuse = [&](const char* why) {
    throw MeshError(fmt::format("block '{}' cannot be divided by the explicit region: {}", body.name, why));
  };
  if (mesh.onefold) refuse("it is so narrow that one cover carries it; choose a smaller cover_size");
  if (mesh.interface_constraints.empty())
    refuse("no two neighbouring elements have their centroids one in it and one outside");
  if (mesh.shapes.size() > 2)
    refuse(
        "a part of one half has no element of half a triangle; move the region's border, or choose a smaller "
        "cover_size");
  body.whole = std::make_unique<CoverMesh>(mesh);
  find_whole_inverse(body);
  const Division::Acts acts = body.form.division.acts;
  if (acts != Division::Acts::both) mesh = half_of(*body.whole, acts == Division::Acts::explicit_half);
  // A consistent mass is the implicit half's alone; explicit steps take a lumped one.
  body.lumped = std::make_unique<CoverMesh>(body.form.mass == MassKind::consistent ? half_of(mesh, true) : mesh);
}

void NmmPool::add(const Model& model, const BodyRecord& record) {
  auto body = std::make_unique<Body>();
  body->shape = record.shape;
  body->name = model.blocks[record.block.index()].name;
  model_origin_ = model.origin;
  const Formulation& form = record.form;
  const AffineMotion to_origin = affine_fit(record.shape.outline, record.shape.origin);
  const std::int32_t first = first_.back();
  body->law = model.elasticity_of(record.block);
  body->form = form;
  if (!form.onefold)
    body->mesh = make_mesh(model, record, to_origin);
  else
    body->mesh = form.model_triangle ? make_onefold(record.shape.outline, model_triangle(model, to_origin))
                                     : make_onefold(record.shape.outline);
  if (form.division.divides()) divide(*body);
  const CoverMesh& mesh = body->mesh;
  const MassKind lumped = body->lumped && form.mass == MassKind::consistent ? MassKind::affine_exact : form.mass;
  if (!mass_.add(body->lumped ? *body->lumped : mesh, first, record.shape, lumped))
    throw MeshError(fmt::format(
        "block '{}': its cracks leave a part on which no lumped mass is positive; choose another cover size",
        body->name));
  if (form.mass != MassKind::affine_exact && !mesh.onefold) make_implicit(*body, first);
  chart_.add(mesh, first);
  body->first_element = static_cast<std::int32_t>(elements_.size());
  // The rock keeps its area, mass over density, also where an outline fitted to a deformed body holds a little less.
  body->scale = record.shape.area / mesh.drawn_area();
  std::vector<std::array<double, 3>> initial;
  // Constant in an element, its value at the centroid: the mean of a linear stress, so that its force is exact.
  if (const InSituStress in_situ(model, record); !in_situ.none())
    for (std::size_t e = 0; e < mesh.elements(); ++e) {
      const Mat2 s = in_situ.at(mesh.centroid(e));
      initial.push_back({s(0, 0), s(1, 1), s(0, 1)});
    }
  if (mesh.onefold) {
    const std::array<double, 3> s = initial.empty() ? std::array{0.0, 0.0, 0.0} : initial[0];
    body->onefold.emplace(mesh.stars(0), record.shape, body->law, form.kinematics,
                          (Mat2() << s[0], s[2], s[2], s[1]).finished(), first);
  }
  elements_.add(mesh, first, body->scale, {body->law, form.kinematics}, std::move(initial));
  for (Row& row : body->mesh.boundary.nodes)
    for (std::int32_t& n : row.node) n += first;
  for (Boundary::Segment& s : body->mesh.boundary.segments) s.cell += body->first_element;
  idle_.resize(static_cast<std::size_t>(first) + mesh.star.size(), 0);
  for (InterfaceConstraint& s : body->mesh.interface_constraints) {
    s.explicit_node += first;
    s.implicit_node += first;
  }
  if (form.division.divides() && form.division.acts != Division::Acts::both)
    for (std::size_t c = 0; c < mesh.star.size(); ++c)
      if ((mesh.explicit_part[static_cast<std::size_t>(mesh.component[c])] != 0) !=
          (form.division.acts == Division::Acts::explicit_half))
        idle_[static_cast<std::size_t>(first) + c] = 1;
  first_.push_back(first + static_cast<std::int32_t>(mesh.star.size()));
  bodies_.push_back(std::move(body));
}

std::array<Vec2, 3> NmmPool::model_triangle(const Model& model, const AffineMotion& to_origin) {
  if (!model_triangle_) {
    std::vector<Vec2> ends;
    for (const Block& b : model.blocks) {
      const Box box = bounds(b.polygon);
      ends.insert(ends.end(), {box.lo, box.hi});
    }
    model_triangle_ = onefold_triangle(ends);
  }
  const Mat2 back = to_origin.F.inverse();
  std::array<Vec2, 3> star;
  for (std::size_t k = 0; k < 3; ++k) star[k] = back * ((*model_triangle_)[k] - to_origin.c);
  return star;
}

void NmmPool::make_implicit(Body& body, std::int32_t first) {
  const Division& division = body.form.division;
  if (division.acts == Division::Acts::explicit_half) return;
  const bool halved = division.divides() && division.acts == Division::Acts::both;
  const CoverMesh half = halved ? half_of(*body.whole, false) : CoverMesh();
  const CoverMesh& mesh = halved ? half : body.mesh;
  std::vector<MassElement> elements;
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const Moments material = moments(mesh.material(e));
    elements.push_back({mesh.cover[e], mesh.weights(e, material.centroid), mesh.shapes[mesh.shape[e]], material});
  }
  FoldedElements folded;
  folded.make(mesh);
  // The moments that travel with a body are those of the whole block: a half has those of its elements.
  body.consistent.make(folded, elements, mesh.star, body.shape.mass / mesh.drawn_area(),
                       division.divides() ? nullptr : &body.shape.second, first);
  std::vector<Mat3> masses;
  for (std::size_t e = 0; e < elements.size(); ++e) masses.push_back(body.consistent.element(e));
  body.implicit.make(std::move(folded), std::move(masses), body.form.mass == MassKind::lumped, first);
}

void NmmPool::finish() {
  chart_.finish();
  mass_.finish(chart_);
  elements_.finish(first_.back());
  for (int b = 0; b < bodies(); ++b) {
    Body& body = *bodies_[static_cast<std::size_t>(b)];
    body.frequency = body.onefold ? FrequencyBound{affine_frequency(body.shape, body.law), 0}
                                  : frequency_bound_of(body.lumped ? *body.lumped : body.mesh, chart_, first_node(b),
                                                       mass_.lumped(), body.scale, body.law);
  }
  ones_.assign(static_cast<std::size_t>(first_.back()), 1.0);
}

Row NmmPool::row_at(int body, const Vec2& X) const {
  const Body& b = of(body);
  const CoverMesh& mesh = b.whole ? *b.whole : b.mesh;
  Row row = mesh.row(mesh.locate(X), X);
  for (std::int32_t& n : row.node) n += first_node(body);
  return row;
}

std::span<const double> NmmPool::translation(int body) const {
  const auto first = static_cast<std::size_t>(first_node(body)), last = static_cast<std::size_t>(first_node(body + 1));
  return std::span(ones_).subspan(first, last - first);
}

void NmmPool::place(int body, const AffineMotion& m, std::span<double> q, std::span<double> v) const {
  const Body& b = of(body);
  for (std::size_t k = 0; k < b.mesh.star.size(); ++k) {
    const std::size_t i = 2 * (static_cast<std::size_t>(first_node(body)) + k);
    const Vec2 x = m.c + m.F * b.mesh.star[k], u = m.vc + m.Fdot * b.mesh.star[k];
    q[i] = x.x();
    q[i + 1] = x.y();
    v[i] = u.x();
    v[i + 1] = u.y();
  }
}

void NmmPool::settle(int body, std::span<double> q, std::span<double> v) const {
  const std::size_t first = 2 * static_cast<std::size_t>(first_node(body));
  for (const Tie& t : of(body).mesh.ties) {
    CoverChart::follow(t, q.subspan(first));
    CoverChart::follow(t, v.subspan(first));
  }
}

void NmmPool::project(int body, const FieldCarrier& from, int other, std::span<const double> q_from,
                      std::span<const double> v_from, std::span<double> q, std::span<double> v) const {
  const auto& was = dynamic_cast<const NmmPool&>(from);
  const auto part = [](auto all, const NmmPool& pool, int b) {
    const auto first = static_cast<std::size_t>(pool.first_node(b)),
               last = static_cast<std::size_t>(pool.first_node(b + 1));
    return all.subspan(2 * first, 2 * (last - first));
  };
  // Of a divided block the whole, whose interface constraints are still counted from its first cover.
  const auto mesh = [](const Body& b) -> const CoverMesh& { return b.whole ? *b.whole : b.mesh; };
  project_motion({&mesh(was.of(other)), part(q_from, was, other), part(v_from, was, other)}, mesh(of(body)),
                 of(body).law, of(body).form.kinematics, part(q, *this, body), part(v, *this, body));
  settle(body, q, v);
}

double NmmPool::internal_force(std::span<const double> q, std::span<double> f) const {
  return elements_.add_force(q, f);
}

Fault NmmPool::find_fault(std::span<const double> q) const {
  if (Fault fault = Pool::find_fault(q); fault.body >= 0) return fault;
  for (int b = 0; b < bodies(); ++b)
    for (std::size_t e = 0; e < of(b).mesh.elements(); ++e) {
      const std::size_t i = static_cast<std::size_t>(of(b).first_element) + e;
      if (elements_.law(i).kinematics == Kinematics::linear || elements_.gradient(i, q).determinant() > 0.0) continue;
      return {b, place_of(b, e) + " is turned inside out"};
    }
  return {};
}

std::string NmmPool::place_of(int body, std::size_t element) const {
  const AffineMotion origin = affine_fit(of(body).shape.outline, of(body).shape.origin);
  const Vec2 x = origin.c + origin.F * of(body).mesh.centroid(element);
  return fmt::format("element {} near {}", element, place_text(x, model_origin_));
}

std::string NmmPool::binding(int body) const {
  return place_of(body, static_cast<std::size_t>(of(body).frequency.element));
}

void NmmPool::stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                                std::span<double> f) const {
  elements_.add_rate_force(q, v, rate, f);
}

void NmmPool::body_force(const Vec2& acceleration, std::span<double> f) const {
  for (int b = 0; b < bodies(); ++b) add_weight(b, acceleration, f);
}

void NmmPool::add_weight(int b, const Vec2& g, std::span<double> f) const {
  if (of(b).onefold) {
    of(b).onefold->add_weight(g, f);
    return;
  }
  if (lumps(of(b).form)) mass_.add_weight(first_node(b), first_node(b + 1), g, f);
  if (has_consistent(of(b).form)) of(b).consistent.add_weight(g, f);
}

void NmmPool::apply_mass(int b, std::span<const double> v, std::span<double> p) const {
  if (of(b).onefold) {
    of(b).onefold->mass_apply(v, p);
    return;
  }
  if (lumps(of(b).form)) mass_.apply(first_node(b), first_node(b + 1), v, p);
  if (has_consistent(of(b).form)) of(b).consistent.apply(v, p);
}

double NmmPool::kinetic_of(int b, std::span<const double> v) const {
  if (of(b).onefold) return of(b).onefold->kinetic_energy(v);
  double sum = 0.0;
  if (lumps(of(b).form)) sum += mass_.kinetic_energy(first_node(b), first_node(b + 1), v);
  if (has_consistent(of(b).form)) sum += of(b).consistent.kinetic_energy(v);
  return sum;
}

void NmmPool::mass_solve(std::span<const double>, std::span<const double> f, std::span<double> a) const {
  mass_.solve(chart_, f, a);
  for (const auto& body : bodies_) {
    if (body->onefold)
      body->onefold->mass_solve(f, a);
    else if (has_consistent(body->form))
      body->consistent.solve(f, a);
  }
}

double NmmPool::mass_ratio(int body) const {
  return of(body).onefold ? 1.0 : mass_.theta(first_node(body), first_node(body + 1));
}

double NmmPool::kinetic_energy(std::span<const double>, std::span<const double> v,
                               std::span<const char> counted) const {
  double sum = 0.0;
  for (int b = 0; b < bodies(); ++b)
    if (counted[static_cast<std::size_t>(b)] != 0) sum += kinetic_of(b, v);
  return sum;
}

double NmmPool::damp(double factor, double rate, std::span<const double> along, std::span<double> v,
                     std::span<double> f, std::span<double> a) const {
  if (bodies() > 0 && lumps(of(0).form)) return mass_.damp(factor, rate, along, v, f, a);
  double power = 0.0;
  for (const auto& body : bodies_)
    if (!body->onefold) power += body->consistent.damp(factor, rate, along, v, f, a);
  return power;
}

double NmmPool::compliance(int body, const Row& row) const {
  if (of(body).onefold) return of(body).onefold->compliance(row);
  std::vector<Share> folded;
  double sum = 0.0;
  if (of(body).whole) {
    Row own = row;
    for (std::int32_t& n : own.node) n -= first_node(body);
    of(body).whole_chart.fold(own, folded);
    for (const Share& s : folded) sum += s.w * s.w * of(body).whole_inverse[static_cast<std::size_t>(s.cover)];
    return sum;
  }
  chart_.fold(row, folded);
  for (const Share& s : folded) sum += s.w * s.w * mass_.inverse()[static_cast<std::size_t>(s.cover)];
  return sum;
}

void NmmPool::bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const {
  if (of(body).onefold) {
    groups.assign(1, first_node(body));
    return;
  }
  std::vector<Share> folded;
  chart_.fold(row, folded);
  groups.clear();
  for (const Share& s : folded)
    if (std::abs(s.w) > 1e-12) groups.push_back(s.cover);
}

BodyTotals NmmPool::totals(int body, std::span<const double> q, std::span<const double> v) const {
  const Body& b = of(body);
  std::vector<double> p(q.size(), 0.0), weight(q.size(), 0.0);
  apply_mass(body, v, p);
  add_weight(body, {1.0, 1.0}, weight);
  BodyTotals t;
  for (std::int32_t k = first_node(body); k < first_node(body + 1); ++k) {
    const double m = weight[2 * static_cast<std::size_t>(k)];
    t.mass += m;
    t.centre += m * node(q, k);
    t.momentum += node(p, k);
    t.angular_momentum += cross(node(q, k), node(p, k));
  }
  t.centre /= t.mass;
  t.kinetic = kinetic_of(body, v);
  const auto first = static_cast<std::size_t>(b.first_element);
  for (std::size_t e = first; e < first + b.mesh.elements(); ++e)
    t.elastic += elements_.area(e) * elements_.response(e, q).energy;
  return t;
}

Release NmmPool::release(int body, std::span<const double> q, std::span<const double> v) const {
  const Body& b = of(body);
  Release out;
  const std::int32_t begin = first_node(body), end = first_node(body + 1);
  const auto local = [&](std::int32_t k) { return static_cast<std::size_t>(k - begin); };

  // Affine part in the operator really used: c, S, v_c, B, and the fit of x to X.
  std::vector<double> weight(q.size(), 0.0), p(q.size(), 0.0), r(q.size(), 0.0), Mr(q.size(), 0.0);
  add_weight(body, {1.0, 1.0}, weight);
  apply_mass(body, v, p);
  Vec2 c = Vec2::Zero(), momentum = Vec2::Zero();
  double mass = 0.0;
  for (std::int32_t k = begin; k < end; ++k) {
    mass += weight[2 * static_cast<std::size_t>(k)];
    c += weight[2 * static_cast<std::size_t>(k)] * node(q, k);
    momentum += node(p, k);
  }
  c /= mass;
  const Vec2 vc = momentum / mass;
  for (std::int32_t k = begin; k < end; ++k)
    for (int d = 0; d < 2; ++d) r[2 * static_cast<std::size_t>(k) + static_cast<std::size_t>(d)] = node(q, k)[d] - c[d];
  apply_mass(body, r, Mr);
  Mat2 S = Mat2::Zero(), B = Mat2::Zero(), fit = Mat2::Zero();
  for (std::int32_t k = begin; k < end; ++k) {
    S += node(Mr, k) * node(r, k).transpose();
    B += node(p, k) * node(r, k).transpose();
    fit += node(Mr, k) * b.mesh.star[local(k)].transpose();
  }
  S = 0.5 * (S + S.transpose()).eval();
  const Mat2 G = B * S.inverse();

  // The stress that keeps the affine part of the internal force, and the stretch that carries it.
  const Mat2 R = polar_rotation(fit * b.shape.second.inverse());  // of the best F, whatever the shape of the block
  const auto first = static_cast<std::size_t>(b.first_element);
  const std::size_t last = first + b.mesh.elements();
  Mat2 virial = Mat2::Zero(), initial = Mat2::Zero();
  double area = 0.0;
  for (std::size_t e = first; e < last; ++e) {
    virial += elements_.area(e) * elements_.response(e, q).P * elements_.gradient(e, q).transpose();
    initial += elements_.area(e) * elements_.initial_stress(e);
    area += elements_.area(e);
  }
  initial /= area;
  const Mat2 local_virial = R.transpose() * virial * R;
  const Mat2 strain = strain_of_kirchhoff(b.law, 0.5 * (local_virial + local_virial.transpose()) / area, initial);
  const Mat2 F = R * (Mat2::Identity() + strain), F_inverse = F.inverse();
  out.motion = {c, F, vc, G * F};
  out.initial = initial;

  out.shape.mass = b.shape.mass;
  out.shape.area = area;
  out.shape.second = F_inverse * S * F_inverse.transpose();
  out.shape.origin = b.shape.origin;
  out.shape.outline = b.shape.outline;
  for (const Boundary::Corner& corner : b.mesh.boundary.corners) {
    const Row& row = b.mesh.boundary.nodes[static_cast<std::size_t>(corner.node)];
    Vec2 x = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) x += row.w[k] * node(q, row.node[k]);
    out.shape.outline.ring(static_cast<std::size_t>(corner.ring))[static_cast<std::size_t>(corner.vertex)] =
        F_inverse * (x - c);
  }

  // What is left over: velocities M-orthogonal to affine fields, stresses about their mean.
  std::vector<double> w(q.size(), 0.0);
  for (std::int32_t k = begin; k < end; ++k) {
    const Vec2 rest = node(v, k) - vc - G * node(r, k), turned = R.transpose() * rest;
    w[2 * static_cast<std::size_t>(k)] = rest.x();
    w[2 * static_cast<std::size_t>(k) + 1] = rest.y();
    const Vec2 y = F_inverse * node(r, k);
    if (b.onefold) continue;  // its motion is affine
    out.velocity_rest.insert(out.velocity_rest.end(), {turned.x(), turned.y()});
    out.position.insert(out.position.end(), {y.x(), y.y()});
  }
  out.kinetic_rest = b.onefold ? 0.0 : kinetic_of(body, w);
  const Mat2 mean = b.law.stress(strain) + initial;
  double inertia = 0.0;
  for (std::size_t e = first; e < last; ++e) {
    const Mat2 F_e = elements_.gradient(e, q), U = polar_rotation(F_e).transpose() * F_e;
    const Mat2 own = 0.5 * (U + U.transpose()) - Mat2::Identity(), difference = own - strain;
    const Mat2 ds = b.law.stress(difference), extra = elements_.initial_stress(e) - initial;
    const double A = elements_.area(e);
    const Mat2 G_e = elements_.gradient(e, v) * F_e.inverse();
    const Moments own_moments = moments(b.mesh.material(e - first));
    const std::int32_t cover = elements_.cover(e)[0];
    const Vec2 arm = node(q, cover) + F_e * (own_moments.centroid - b.mesh.star[local(cover)]) - c;
    const double J_e = (F_e * own_moments.second * F_e.transpose()).trace() + A * arm.squaredNorm();
    out.spin_squared += J_e * std::pow(0.5 * (G_e(1, 0) - G_e(0, 1)), 2);
    inertia += J_e;
    out.elastic_rest += 0.5 * A * ds.cwiseProduct(difference).sum();
    out.elastic_cross += A * (mean.cwiseProduct(difference).sum() + extra.cwiseProduct(own).sum());
  }
  out.spin_squared /= inertia;
  return out;
}

std::string NmmPool::implicit_obstacle(int body) const {
  if (of(body).onefold || of(body).form.mass != MassKind::affine_exact) return {};
  return "its mass is affine-exact, which couples all covers of a block; implicit steps take mass = \"consistent\" or "
         "\"lumped\"";
}

ChartRow NmmPool::chart_row(int body, const Row& row, std::span<const double>) const {
  return of(body).onefold ? of(body).onefold->chart_row(row) : of(body).implicit.chart_row(row);
}

void NmmPool::element_masses(int body, std::span<const double>, std::span<double> mass) const {
  if (of(body).onefold)
    of(body).onefold->form().mass(mass);
  else
    of(body).implicit.element_masses(mass);
}

void NmmPool::rates(int body, std::span<const double>, std::span<const double> v, std::span<double> rate) const {
  if (of(body).onefold)
    of(body).onefold->rates(v, rate);
  else
    of(body).implicit.rates(v, rate);
}

double NmmPool::linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                          std::span<double> force) const {
  if (const auto& cover = of(body).onefold) return cover->form().linearise(cover->gradient(q), kind, stiffness, force);
  const auto first = static_cast<std::size_t>(of(body).first_element), count = of(body).mesh.elements();
  return of(body).implicit.linearise(elements_.covers().subspan(first, count), q, kind, stiffness, force,
                                     [&](std::size_t e) {
                                       const std::size_t i = first + e;
                                       return StiffElement{elements_.gradients(i), elements_.area(i), of(body).law,
                                                           of(body).form.kinematics, elements_.initial_stress(i)};
                                     });
}

void NmmPool::retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
                      std::span<double> v) const {
  if (of(body).onefold)
    of(body).onefold->retract(d, rate, q, v);
  else
    of(body).implicit.retract(d, rate, q, v);
}

}  // namespace scree::nmm
