// The walls of the bench in Box2D, a solver for games, for comparison: the same blocks in running bond on a base that
// is held or shaken, friction of 31 degrees, no restitution, no sleeping; 8 velocity and 3 position iterations, as its
// manual recommends. It has no elasticity, no ledger and no equilibrium to a tolerance: it shows how fast contacts of
// blocks can be found and resolved at all.
//
//   usage: bench_box2d_wall COURSES STEPS SECONDS_A_STEP rest|shaken
// Prints the processor time per step in ms, after half a second of settling.
#include <box2d/box2d.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numbers>

namespace {

constexpr float kDensity = 2500.0F;
constexpr int kVelocityIterations = 8, kPositionIterations = 3;

void add_box(b2World& world, float x, float y, float width, float height) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position.Set(x + 0.5F * width, y + 0.5F * height);
  def.allowSleep = false;
  b2PolygonShape shape;
  shape.SetAsBox(0.5F * width, 0.5F * height);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = kDensity;
  fixture.friction = static_cast<float>(std::tan(31.0 * std::numbers::pi / 180.0));
  fixture.restitution = 0.0F;
  world.CreateBody(&def)->CreateFixture(&fixture);
}

b2Body* add_base(b2World& world, float courses) {
  b2BodyDef def;
  def.type = b2_kinematicBody;
  b2PolygonShape shape;
  shape.SetAsBox(0.5F * (courses + 7.0F), 1.0F, b2Vec2(0.5F * (courses + 1.0F), -1.0F), 0.0F);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = static_cast<float>(std::tan(31.0 * std::numbers::pi / 180.0));
  b2Body* base = world.CreateBody(&def);
  base->CreateFixture(&fixture);
  return base;
}

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: bench_box2d_wall COURSES STEPS SECONDS_A_STEP rest|shaken\n", stderr);
    return 2;
  }
  const int courses = std::atoi(argv[1]), steps = std::atoi(argv[2]);
  const double dt = std::atof(argv[3]);
  const bool shaken = std::strcmp(argv[4], "shaken") == 0;
  b2World world(b2Vec2(0.0F, -9.81F));
  world.SetAllowSleeping(false);
  b2Body* base = add_base(world, static_cast<float>(courses));
  for (int j = 0; j < courses; ++j)
    for (int i = 0; i < (j % 2 == 0 ? courses + 1 : courses); ++i)
      add_box(world, static_cast<float>(i) + (j % 2 == 0 ? 0.0F : 0.5F), 0.5F * static_cast<float>(j), 1.0F, 0.5F);
  const auto step = [&] { world.Step(static_cast<float>(dt), kVelocityIterations, kPositionIterations); };
  for (double t = 0.0; t < 0.5; t += dt) step();
  constexpr double kOmega = 2.0 * std::numbers::pi * 2.0, kPeak = 4.0;  // 2 Hz, 4 m/s2
  const double begin = processor_time();
  for (int k = 0; k < steps; ++k) {
    if (shaken)
      base->SetLinearVelocity(b2Vec2(static_cast<float>(kPeak / kOmega * (1.0 - std::cos(kOmega * dt * k))), 0.0F));
    step();
  }
  std::printf("%d blocks, %d contacts, %s: %.3f ms a step\n", world.GetBodyCount() - 1, world.GetContactCount(),
              argv[4], 1e3 * (processor_time() - begin) / steps);
  return 0;
}
