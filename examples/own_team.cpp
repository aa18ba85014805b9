// Plays a team of your own against a built-in one: two robots follow the ball, the first one stays in front
// of its goal.
#include <cstdio>
#include <fulbito/match.hpp>

class Followers final : public fulbito::Strategy {
 public:
  void begin(const fulbito::MatchInfo& info) override {
    goal_line_ = -info.field.length / 2;
    navigator_ = *fulbito::parseNavigator("tangent-field");
  }
  std::span<const fulbito::NavigatorChoice> navigators() const override { return {&navigator_, 1}; }
  fulbito::TeamCommand decide(const fulbito::Observation& seen) override {
    fulbito::TeamCommand command;
    for (int i = 0; i < seen.team_size; ++i) {
      fulbito::GoTo go_to;
      go_to.position =
          i == 0 ? fulbito::Vec2{goal_line_ + 0.08, seen.ball.position.y / 4} : seen.ball.position;
      go_to.stop = i == 0;
      command.robots[i] = fulbito::RobotCommand::drivingTo(go_to);
    }
    return command;
  }

 private:
  double goal_line_ = 0.0;  // [m] x of the own goal; teams see the field with their own goal at -x
  fulbito::NavigatorChoice navigator_;
};

int main() {
  auto config = fulbito::MatchConfig::standard("idle", "chaser");
  if (!config) return 1;
  config->teams[0] = fulbito::TeamChoice::own("followers", [] { return std::make_unique<Followers>(); });
  config->rules.half_seconds = 60.0;
  auto match = fulbito::Match::create(*config);
  if (!match) return std::fprintf(stderr, "%s\n", match.error().message.c_str()), 1;
  while (match->step()) {
  }
  std::printf("followers - chaser %d : %d\n", match->referee().score[0], match->referee().score[1]);
}
