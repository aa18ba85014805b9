#include <fstream>
#include <sstream>

#include "fulbito/detail/math.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/skills/ball_posture.hpp"
#include "strategies/skills/interception.hpp"
#include "strategies/skills/positions.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

// The team of docs/strategies.md, to the letter: the last test compares them.
// example
class Pair final : public Strategy {
 public:
  void begin(const MatchInfo& info) override { info_ = info, foresight_ = Foresight(info); }
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& seen) override {
    const Observation& now = foresight_.update(seen);  // as of now, with the ball's way
    TeamCommand command;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!now.own[i].present) continue;
      GoTo keep;
      keep.position = keeperPoint(info_.field, foresight_.ball(), 0.06, 0.17);
      keep.stop = true;
      command.robots[i] = RobotCommand::drivingTo(i == 0 ? keep : attack(now.own[i].state));
    }
    return command;
  }

 private:
  GoTo attack(const RobotState& robot) const {
    const auto meeting = intercept(foresight_.ball(), foresight_.pace(), robot);
    const Vec2 ball = meeting ? meeting->ball : foresight_.ball().endOfWay();
    return approachBall(robot, ball, unitOr(opponentGoal(info_.field) - ball, {1.0, 0.0}), false).go_to;
  }
  MatchInfo info_;
  Foresight foresight_;
  std::vector<NavigatorChoice> navigators_ = {*parseNavigator("univector:follower=classic")};
};
// end of example

std::string textOf(const std::string& path) {
  std::ifstream in(std::string(FULBITO_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("the documented team decides", "[unit]") {
  Pair team;
  team.begin(test::matchInfo());
  Observation seen;
  for (std::size_t i = 0; i < 3; ++i) seen.own[i].present = true;
  seen.own[1].state.pose.position = {-0.4, 0.1};
  seen.ball.position = {0.2, 0.1};
  const TeamCommand command = team.decide(seen);
  CHECK(command.robots[0].go_to.position.x == Approx(-0.69));
  CHECK(command.robots[1].go_to.position.x == Approx(0.2).margin(0.05));
  CHECK(command.robots[1].go_to.heading.value() == Approx(-0.18).margin(0.02));
}

TEST_CASE("the documented team is this one", "[unit]") {
  const std::string source = textOf("tests/unit/strategies/teams/example_team_test.cpp");
  const std::string mark = "// example\n";
  const std::size_t begin = source.find(mark) + mark.size();
  const std::string code = source.substr(begin, source.find("// end of "
                                                            "example") -
                                                    begin);
  CHECK(code.size() > 500);
  CHECK(textOf("docs/strategies.md").find(code) != std::string::npos);
}

}  // namespace fulbito
