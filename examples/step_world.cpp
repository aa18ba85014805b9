// Steps a world of one robot and one ball for two seconds: the robot drives straight on and pushes the ball.
#include <cstdio>
#include <fulbito/world.hpp>

int main() {
  fulbito::WorldConfig config;
  config.robots.emplace_back();
  config.balls.emplace_back().position = {0.2, 0.0};
  auto world = fulbito::World::create(config);
  if (!world) return std::fprintf(stderr, "%s\n", world.error().message.c_str()), 1;

  const fulbito::WheelSpeeds forward{20.0, 20.0};
  fulbito::StateHash hash;
  for (int tick = 1; tick <= 2 * config.physics.control_rate; ++tick) {
    world->step({&forward, 1});
    hash.add(world->state());
    for (const fulbito::ContactEvent& contact : world->contacts()) {
      if (contact.began && contact.b.kind == fulbito::BodyKind::kBall) std::printf("tick %d: touch\n", tick);
    }
  }
  const fulbito::BallState& ball = world->state().balls[0];
  std::printf("the ball is at x = %.3f m, hash %016llx\n", ball.position.x,
              static_cast<unsigned long long>(hash.value()));
}
