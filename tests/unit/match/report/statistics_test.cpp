#include "fulbito/statistics.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// A match with one robot per team that the test moves: blue defends the left goal.
struct Scene {
  StatisticsObserver observer;
  MatchConfig config;
  WorldConfig placed;
  WorldState world;
  RefereeState referee;
  std::vector<RobotId> ids{{TeamId::kBlue, 0}, {TeamId::kYellow, 0}};
  std::vector<ContactEvent> contacts;
  std::vector<GameEvent> events;
  Tick tick = 0;

  Scene() {
    config.rules.team_size = 1;
    observer.onMatchStart(config);
    begin({-0.3, 0.0}, {0.3, 0.0});
  }

  void begin(Vec2 blue, Vec2 yellow, RestartKind kind = RestartKind::kKickOff, TeamId team = TeamId::kBlue) {
    placed.robots = {{{}, {blue, 0.0}, {}, 0.0}, {{}, {yellow, 0.0}, {}, 0.0}};
    world.robots.resize(2);
    world.balls.resize(1);
    put(blue, yellow);
    referee.playing = true;
    PlayStart start;
    start.call.kind = kind;
    start.call.team = team;
    start.ids = ids;
    start.world = &placed;
    start.events = {};
    start.referee = &referee;
    observer.onPlayStart(start);
  }
  void put(Vec2 blue, Vec2 yellow) {
    world.robots[0].pose.position = blue;
    world.robots[1].pose.position = yellow;
  }
  void ball(Vec2 position, Vec2 velocity = {}) { world.balls[0] = {position, velocity, {}}; }
  void touch(std::uint16_t robot, bool began = true) {
    contacts.push_back({{BodyKind::kRobot, robot}, {BodyKind::kBall, 0}, {}, {}, 0.1, began});
  }
  void foul(std::string_view clause, TeamId team) {
    GameEvent event;
    event.clause = clause;
    event.team = team;
    events.push_back(event);
    step();
  }
  void goalFor(TeamId team) {
    ++referee.score[indexOf(team)];
    GameEvent event;
    event.tick = tick + 1;
    event.clause = "goal";
    event.team = team;
    events.push_back(event);
  }
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      ++tick;
      if (referee.playing) ++referee.match_ticks;
      MatchTick now;
      now.tick = tick;
      now.ids = ids;
      now.world = &world;
      now.contacts = contacts;
      now.events = events;
      now.referee = &referee;
      observer.onTick(now);
      contacts.clear();
      events.clear();
    }
  }
  const MatchStatistics& stats() const { return observer.statistics(); }
  const TeamStatistics& of(TeamId team) const { return stats().teams[indexOf(team)]; }
};

}  // namespace

TEST_CASE("possession goes to the clearly nearer team and does not flicker", "[unit]") {
  Scene scene;
  scene.step(5);
  CHECK(scene.of(TeamId::kBlue).possession == 0);  // equally far: nobody has had it yet
  scene.ball({-0.1, 0.0});
  scene.step(10);
  CHECK(scene.of(TeamId::kBlue).possession == 10);
  scene.ball({0.005, 0.0});  // yellow is nearer by 1 cm: not enough
  scene.step(10);
  CHECK(scene.of(TeamId::kBlue).possession == 20);
  scene.ball({0.02, 0.0});
  scene.step(20);
  CHECK(scene.stats().possession(TeamId::kYellow) == Approx(0.5));
}

TEST_CASE("territory counts thirds from each team's own goal, wherever it stands", "[unit]") {
  Scene scene;
  scene.ball({0.6, 0.0});
  scene.step(3);
  scene.ball({0.0, 0.0});
  scene.step(1);
  CHECK(scene.stats().third(TeamId::kBlue, 2) == Approx(0.75));
  CHECK(scene.stats().third(TeamId::kYellow, 0) == Approx(0.75));
  CHECK(scene.stats().meanBallX(TeamId::kBlue) == Approx(0.45));
  scene.referee.blue_side = Side::kRight;
  scene.step(4);
  scene.ball({0.6, 0.0});
  scene.step(3);
  CHECK(scene.stats().third(TeamId::kBlue, 0) == Approx(3.0 / 11.0));
  CHECK(scene.stats().meanBallX(TeamId::kYellow) == Approx(0.0).margin(1e-12));
}

TEST_CASE("distance is the way of the centre; a restart moves nobody", "[unit]") {
  Scene scene;
  scene.put({-0.3, 0.04}, {0.3, 0.0});
  scene.step();
  scene.put({-0.27, 0.08}, {0.3, 0.0});
  scene.step(5);
  CHECK(scene.of(TeamId::kBlue).distance() == Approx(0.04 + 0.05));
  CHECK(scene.of(TeamId::kYellow).distance() == 0.0);
  scene.begin({0.1, 0.1}, {0.5, 0.5}, RestartKind::kPenalty, TeamId::kYellow);
  scene.step();
  CHECK(scene.of(TeamId::kBlue).distance() == Approx(0.09));
  CHECK(scene.stats().restartCount(RestartKind::kPenalty) == 1);
  CHECK(scene.stats().restarts[static_cast<std::size_t>(RestartKind::kPenalty)][1] == 1);
}

TEST_CASE("nothing counts while a restart waits", "[unit]") {
  Scene scene;
  scene.referee.playing = false;
  scene.step();  // the tick in which play stopped
  scene.ball({-0.2, 0.0});
  scene.put({0.0, 0.0}, {0.3, 0.0});
  scene.touch(0);
  scene.step(9);
  CHECK(scene.stats().play_ticks == 1);
  CHECK(scene.stats().waiting_ticks == 9);
  CHECK(scene.of(TeamId::kBlue).touches() == 0);
  CHECK(scene.of(TeamId::kBlue).distance() == 0.0);
}

TEST_CASE("a shot needs speed, time, a mouth and a touch of the attacker", "[unit]") {
  Scene scene;
  const auto shots = [&] { return scene.of(TeamId::kBlue).shots; };
  scene.ball({0.3, 0.0}, {1.0, 0.0});
  scene.step();
  CHECK(shots() == 0);  // nobody touched it
  scene.touch(0);
  scene.ball({0.3, 0.0}, {0.39, 0.0});
  scene.step();
  CHECK(shots() == 0);  // too slow
  scene.ball({-0.3, 0.0}, {1.0, 0.0});
  scene.step();
  CHECK(shots() == 0);  // more than a second away
  scene.ball({0.3, 0.0}, {1.0, 0.8});
  scene.step();
  CHECK(shots() == 0);  // 36 cm off the middle
  scene.ball({0.3, 0.0}, {1.0, 0.55});
  scene.step();
  CHECK(shots() == 1);  // 25 cm off: beside the post
  CHECK(scene.of(TeamId::kBlue).shots_on_goal == 0);
  scene.ball({0.35, 0.0}, {1.0, 0.3});
  scene.step(10);
  CHECK(shots() == 1);  // the same shot
  CHECK(scene.of(TeamId::kBlue).shots_on_goal == 1);
  CHECK(scene.of(TeamId::kBlue).robots[0].shots == 1);
  scene.ball({0.35, 0.0});
  scene.step(20);
  scene.ball({0.35, 0.0}, {1.0, 0.0});
  scene.step();
  CHECK(shots() == 2);
  CHECK(scene.of(TeamId::kYellow).shots == 0);
}

TEST_CASE("goals have a scorer, and own goals are marked", "[unit]") {
  Scene scene;
  scene.touch(0);
  scene.ball({0.72, 0.0}, {0.1, 0.0});
  scene.goalFor(TeamId::kBlue);
  scene.step();
  REQUIRE(scene.stats().goals.size() == 1);
  CHECK(scene.stats().goals[0].scorer == RobotId{TeamId::kBlue, 0});
  CHECK_FALSE(scene.stats().goals[0].own_goal);
  CHECK(scene.of(TeamId::kBlue).shots_on_goal == 1);  // slow, but it went in
  CHECK(scene.stats().goals[0].score == PerTeam<int>{1, 0});

  scene.begin({-0.3, 0.0}, {0.3, 0.0});
  scene.touch(1);
  scene.ball({0.72, 0.0}, {0.1, 0.0});
  scene.goalFor(TeamId::kBlue);
  scene.step();
  REQUIRE(scene.stats().goals.size() == 2);
  CHECK(scene.stats().goals[1].own_goal);
  CHECK(scene.stats().goals[1].scorer == RobotId{TeamId::kYellow, 0});
  CHECK(scene.of(TeamId::kYellow).own_goals == 1);
  CHECK(scene.of(TeamId::kBlue).shots_on_goal == 1);
}

TEST_CASE("a shot on goal that a defender deflects is no own goal", "[unit]") {
  Scene scene;
  scene.touch(0);
  scene.ball({0.6, 0.0}, {1.0, 0.0});
  scene.step();
  scene.touch(1);
  scene.ball({0.7, 0.02}, {0.8, 0.1});
  scene.step();
  scene.goalFor(TeamId::kBlue);
  scene.step();
  REQUIRE(scene.stats().goals.size() == 1);
  CHECK_FALSE(scene.stats().goals[0].own_goal);
  CHECK(scene.stats().goals[0].scorer == RobotId{TeamId::kBlue, 0});
  CHECK(scene.of(TeamId::kBlue).shots == 1);
}

TEST_CASE("contacts are counted when they begin, by who touches whom", "[unit]") {
  Scene scene;
  scene.touch(0);
  scene.contacts.push_back({{BodyKind::kWall, 0}, {BodyKind::kRobot, 1}, {}, {}, 0.1, true});
  scene.contacts.push_back({{BodyKind::kRobot, 0}, {BodyKind::kRobot, 1}, {}, {}, 0.1, true});
  scene.contacts.push_back({{BodyKind::kWall, 0}, {BodyKind::kBall, 0}, {}, {}, 0.1, true});
  scene.step();
  scene.touch(0, false);
  scene.contacts.push_back({{BodyKind::kRobot, 0}, {BodyKind::kRobot, 1}, {}, {}, 0.1, false});
  scene.step();
  CHECK(scene.of(TeamId::kBlue).touches() == 1);
  CHECK(scene.of(TeamId::kYellow).wall_contacts == 1);
  CHECK(scene.stats().opponent_contacts == 1);
  CHECK(scene.of(TeamId::kBlue).mate_contacts == 0);
}

TEST_CASE("a goal within five seconds of play after a foul of who scores is put down to that foul",
          "[unit]") {
  Scene scene;
  const auto blue = [&] { return scene.of(TeamId::kBlue).goals_after_foul; };
  scene.foul("goal-kick.keeper-charged", TeamId::kBlue);
  scene.foul("penalty.defenders", TeamId::kYellow);
  scene.step(299);
  scene.goalFor(TeamId::kBlue);
  scene.step();
  CHECK(blue() == 0);  // a tick too late
  scene.foul("goal-kick.attackers", TeamId::kBlue);
  scene.foul("goal-kick.keeper-charged", TeamId::kBlue);
  scene.referee.playing = false;  // the clock does not run
  scene.step(600);
  scene.referee.playing = true;
  scene.step(299);
  scene.goalFor(TeamId::kBlue);
  scene.step();
  CHECK(blue() == 1);
  scene.goalFor(TeamId::kYellow);
  scene.step();
  CHECK(scene.of(TeamId::kYellow).goals_after_foul == 0);  // blue's foul
  for (const char* call : {"free-ball", "placement", "kick-off", "half"}) scene.foul(call, TeamId::kYellow);
  scene.goalFor(TeamId::kYellow);
  scene.step();
  CHECK(scene.of(TeamId::kYellow).goals_after_foul == 0);  // no fouls
  for (const CallCount& count : scene.stats().calls) {
    CHECK(count.paid == PerTeam<int>{count.clause == "goal-kick.keeper-charged" ? 1 : 0, 0});
  }
}

TEST_CASE("the referee's calls are counted by clause and team", "[unit]") {
  Scene scene;
  GameEvent foul;
  foul.clause = "free-kick.push";
  foul.team = TeamId::kYellow;
  GameEvent half;
  half.clause = "half";
  scene.events = {foul, half};
  scene.step();
  scene.events = {foul};
  scene.step();
  REQUIRE(scene.stats().calls.size() == 2);
  CHECK(scene.stats().calls[0].clause == "free-kick.push");
  CHECK(scene.stats().calls[0].against == PerTeam<int>{0, 2});
  CHECK(scene.stats().calls[1].neither == 1);
}

}  // namespace fulbito
