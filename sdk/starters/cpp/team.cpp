// @NAME@: a team for Fulbito. `make` builds it, `make test` plays it against `idle`, and
//
//     fulbito match ./team.so classic --view
//
// shows it. Units are SI. Your own goal is at -x, whatever the colour.
#include <algorithm>
#include <cmath>

#include "fulbito/@HEADER@"

using namespace fulbito::team;

class MyTeam : public Team {
 public:
  MyTeam() : Team("@NAME@", "1.0", "a keeper, an attacker and a supporter") {
    // Users set it: ./team.so:margin=0.05
    number("margin", margin_, 0.0, 0.3, "m", "how far behind the ball the attacker starts its run");
    takesNavigator("univector");
  }

  Commands decide(const Observation& seen) override {
    Commands commands;
    const int attacker = nearestToBall(seen);
    for (int i = 0; i < seen.team_size; ++i) {
      if (!robot(seen, i).present) continue;
      if (i == 0) {
        keep(seen, i, commands);
      } else if (i == attacker) {
        attack(seen, i, commands);
      } else {
        support(seen, i, commands);
      }
    }
    return commands;
  }

 private:
  static const Robot& robot(const Observation& seen, int i) { return seen.own[static_cast<std::size_t>(i)]; }

  // The robot nearest to the ball, without the keeper (robot 0); -1: none.
  static int nearestToBall(const Observation& seen) {
    int best = -1;
    for (int i = 1; i < seen.team_size; ++i) {
      if (!robot(seen, i).present) continue;
      if (best < 0 || distance(robot(seen, i).position, seen.ball.position) <
                          distance(robot(seen, best).position, seen.ball.position)) {
        best = i;
      }
    }
    return best;
  }

  // The keeper stays on a line in front of the goal, level with the ball.
  void keep(const Observation& seen, int i, Commands& commands) const {
    const Field& field = info().field;
    const double reach = field.goal_width / 2;
    GoTo target;
    target.position = {-field.length / 2 + info().robot.length, std::clamp(seen.ball.position.y, -reach, reach)};
    target.stop = true;
    target.avoid_mates = target.avoid_opponents = false;
    commands.goTo(i, target);
  }

  // The attacker drives behind the ball first, then through it toward the goal.
  void attack(const Observation& seen, int i, Commands& commands) const {
    const Vec2 ball = seen.ball.position, goal{info().field.length / 2, 0.0};
    const Vec2 way = (goal - ball) / std::max(distance(goal, ball), 1e-6);
    const Vec2 from = ball - robot(seen, i).position;
    const double behind = from.x * way.x + from.y * way.y;           // [m] along the direction to the goal
    const double beside = std::abs(from.x * way.y - from.y * way.x);  // [m] off that line
    GoTo target;
    target.heading = angleOf(way);
    target.avoid_opponents = false;
    if (behind > 0.0 && beside < info().robot.width / 2) {
      target.position = ball + way * 0.2;
    } else {
      target.position = ball - way * (info().robot.length + margin_);
      target.avoid_ball = true;
    }
    commands.goTo(i, target);
    if (seen.wants_drawings) commands.line(ball, goal);
  }

  // The supporter stays behind the ball on the other side, in case the attacker loses it.
  void support(const Observation& seen, int i, Commands& commands) const {
    GoTo target;
    target.position = {seen.ball.position.x - 0.35, -seen.ball.position.y / 2};
    target.stop = true;
    target.avoid_ball = true;
    commands.goTo(i, target);
  }

  double margin_ = 0.03;
};

@MACRO@(MyTeam)
