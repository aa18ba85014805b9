#include <cmath>

#include "engine/core/math.hpp"
#include "engine/core/random.hpp"
#include "match/match.hpp"
#include "navigation/limiter.hpp"
#include "referee/restart_call.hpp"
#include "strategies/libero_approach.hpp"
#include "strategies/libero_areas.hpp"
#include "strategies/libero_bounds.hpp"
#include "strategies/registry.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

MatchConfig matchOf(const char* blue, const char* yellow, const char* rules, double half_seconds) {
  MatchConfig config;
  config.teams = {*parseTeam(blue), *parseTeam(yellow)};
  config.rules = *loadRules(rules);
  config.rules.half_seconds = half_seconds;
  config.field = *loadField(config.rules.field);
  config.robot = *loadRobot("vsss");
  config.physics = *loadPhysics("standard");
  return config;
}

PerTeam<int> scoreOf(const MatchConfig& config) {
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->step()) {
  }
  return match->referee().score;
}

/// Goals that libero is ahead of `opponent` after `pairs` swapped pairs.
int goalsAhead(const char* opponent, int pairs, double half_seconds) {
  int ahead = 0;
  for (int i = 0; i < pairs; ++i) {
    auto config = matchOf("libero", opponent, "vsss-3v3", half_seconds);
    config.seed = static_cast<std::uint64_t>(i) + 1;
    const auto first = scoreOf(config);
    std::swap(config.teams[0], config.teams[1]);
    const auto second = scoreOf(config);
    ahead += first[0] - first[1] + second[1] - second[0];
  }
  return ahead;
}

MatchInfo infoOf(int team_size) {
  MatchInfo info;
  info.field = *loadField(team_size == 3 ? "vsss-3v3" : "vsss-5v5");
  info.robot = loadRobot("vsss")->robot;
  info.ball = loadRobot("vsss")->ball;
  info.team_size = team_size;
  return info;
}

Observation anything(Rng& rng, const MatchInfo& info) {
  const double x = info.field.length / 2 + 0.09, y = info.field.width / 2;
  Observation seen;
  seen.team_size = info.team_size;
  const auto put = [&](ObservedRobot& robot) {
    robot.present = rng.uniform(0.0, 1.0) < 0.8;
    robot.state.pose = {{rng.uniform(-x, x), rng.uniform(-y, y)}, rng.uniform(-3.14, 3.14)};
    robot.state.velocity = {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
    robot.state.angular_velocity = rng.uniform(-30.0, 30.0);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(info.team_size); ++i) {
    put(seen.own[i]);
    put(seen.opponents[i]);
  }
  seen.ball.position = {rng.uniform(-x, x), rng.uniform(-y, y)};
  seen.ball.velocity = {rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)};
  // Now and then what is degenerate: a robot on the ball, a ball in a corner.
  if (rng.uniform(0.0, 1.0) < 0.1) seen.own[1].state.pose.position = seen.ball.position;
  if (rng.uniform(0.0, 1.0) < 0.1) seen.ball = {{x, y}, {}, {}};
  seen.since_restart = rng.uniform(0.0, 1.0);
  seen.restart = static_cast<RestartKind>(static_cast<int>(rng.uniform(0.0, 5.99)));
  return seen;
}

ObservedRobot standingAt(const Pose2& pose) {
  ObservedRobot robot;
  robot.present = true;
  robot.state.pose = pose;
  return robot;
}

/// Where libero's robots, the chaser's and the ball are a tenth of a second after a restart, libero being
/// `seat`.
std::vector<Vec2> afterRestart(RestartKind kind, bool ours, TeamId seat) {
  MatchConfig config = matchOf("libero", "chaser", "vsss-3v3", 10.0);
  if (seat == TeamId::kYellow) std::swap(config.teams[0], config.teams[1]);
  config.placement_error = {0.0, 0.0};
  const double own = seat == TeamId::kBlue ? -1.0 : 1.0;
  config.opening = makeCall(refereeSetup(config), {},
                            {kind, ours ? seat : other(seat), {ours ? -own * 0.3 : own * 0.3, 0.3}, nullptr});
  auto match = Match::create(config);
  REQUIRE(match);
  for (int tick = 0; tick < 6; ++tick) match->step();
  std::vector<Vec2> bodies{match->world().balls.front().position};
  for (const TeamId team : {seat, other(seat)}) {
    for (std::size_t i = 0; i < match->ids().size(); ++i) {
      if (match->ids()[i].team == team) bodies.push_back(match->world().robots[i].pose.position);
    }
  }
  return bodies;
}

/// The picture mirrored across the long axis.
Observation acrossAxis(Observation seen) {
  const auto flip = [](Vec2& v) { v.y = -v.y; };
  const auto robots = [&](auto& team) {
    for (ObservedRobot& robot : team) {
      flip(robot.state.pose.position);
      flip(robot.state.velocity);
      robot.state.pose.heading = -robot.state.pose.heading;
      robot.state.angular_velocity = -robot.state.angular_velocity;
    }
  };
  robots(seen.own);
  robots(seen.opponents);
  flip(seen.ball.position);
  flip(seen.ball.velocity);
  return seen;
}

/// One robot alone with a resting ball: the seconds until it is in their goal; negative in its own; 0 never.
double secondsToScore(Vec2 robot, Vec2 ball) {
  auto config = matchOf("libero", "idle", "vsss-3v3", 10.0);
  Placement start;
  start.ball = ball;
  start.robots[0][1] = Pose2{robot, 1.0};
  config.start = start;
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->step()) {
    const PerTeam<int> score = match->referee().score;
    if (score[0] > 0) return match->seconds();
    if (score[1] > 0) return -match->seconds();
  }
  return 0.0;
}

/// One robot alone with a ball that rolls: the seconds until it touches it, which the ball's jump shows.
double secondsToTouch(const Pose2& robot, Vec2 ball, Vec2 velocity) {
  auto config = matchOf("libero", "idle", "vsss-3v3", 4.0);
  Placement start;
  start.ball = ball;
  start.ball_velocity = velocity;
  start.robots[0][1] = robot;
  config.start = start;
  auto match = Match::create(config);
  REQUIRE(match);
  Vec2 last = velocity;
  while (match->step()) {
    const Vec2 now = match->world().balls[0].velocity;
    if (norm(now - last) > 0.12) break;
    last = now;
  }
  return match->seconds();
}

/// When [s] a robot that is alone on the field has scored; 10 where it has not.
double scoresAlone(Vec2 ball, Pose2 robot, double side) {
  auto config = matchOf("libero", "idle", "vsss-3v3", 20.0);
  config.rules.stuck.seconds = config.rules.stuck.area_seconds = 20.0;
  Placement start;
  start.ball = {ball.x, side * ball.y};
  start.robots[0][1] = Pose2{{robot.position.x, side * robot.position.y}, side * robot.heading};
  config.start = start;
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->seconds() < 10.0 && match->referee().score[0] == 0 && match->step()) {
  }
  return match->seconds();
}

}  // namespace

TEST_CASE("libero beats the chaser and the classic team", "[unit]") {
  CHECK(goalsAhead("chaser", 4, 150.0) > 0);
  CHECK(goalsAhead("classic", 4, 150.0) > 0);
}

TEST_CASE("libero against itself: a swapped pair cancels", "[unit]") {
  CHECK(goalsAhead("libero", 1, 20.0) == 0);
}

TEST_CASE("a lone libero brings a resting ball into the right goal", "[unit]") {
  int scored = 0;
  for (const Vec2 ball :
       {Vec2{0.4, 0.3}, Vec2{0.0, -0.45}, Vec2{-0.45, 0.2}, Vec2{-0.55, -0.4}, Vec2{0.55, -0.4}}) {
    const double seconds = secondsToScore({0.1, 0.1}, ball);
    CHECK(seconds >= 0.0);
    scored += seconds > 0.0 ? 1 : 0;
  }
  CHECK(scored == 5);
}

TEST_CASE("libero meets a ball that rolls across, rather than to go round it while it leaves", "[unit]") {
  struct Crossing {
    Pose2 robot;
    Vec2 ball, velocity;
    double least;  // [s] by the time to reach of the reference page (2.1)
  };
  // With the best blow in mind these took 0.45 to 1.7 s more than the least.
  const Crossing crossings[] = {{{{-0.191, -0.126}, 0.51}, {-0.070, 0.484}, {0.10, -0.36}, 0.533},
                                {{{-0.224, -0.154}, -0.45}, {0.006, 0.530}, {0.06, -0.39}, 0.633},
                                {{{-0.153, 0.018}, -0.52}, {-0.065, -0.493}, {0.03, 0.44}, 0.433},
                                {{{-0.384, -0.111}, -0.19}, {0.376, -0.455}, {-0.12, 0.98}, 0.783},
                                {{{-0.349, -0.188}, -0.23}, {0.310, -0.533}, {-0.08, 0.98}, 0.700},
                                {{{-0.189, -0.049}, 0.09}, {-0.113, -0.423}, {0.17, 0.79}, 0.317}};
  for (const Crossing& c : crossings) {
    CHECK(secondsToTouch(c.robot, c.ball, c.velocity) <= c.least + 0.2);
    const Pose2 mirrored{{c.robot.position.x, -c.robot.position.y}, -c.robot.heading};
    CHECK(secondsToTouch(mirrored, {c.ball.x, -c.ball.y}, {c.velocity.x, -c.velocity.y}) <= c.least + 0.2);
  }
}

TEST_CASE("libero's decisions are finite whatever it sees", "[unit]") {
  for (const int size : {3, 5}) {
    const MatchInfo info = infoOf(size);
    auto team = makeTeam(*parseTeam("libero"));
    REQUIRE(team);
    (*team)->begin(info);
    Rng rng{5, Stream::kTest, static_cast<std::uint64_t>(size)};
    for (int i = 0; i < 20'000; ++i) {
      const TeamCommand command = (*team)->decide(anything(rng, info));
      for (const RobotCommand& robot : command.robots) {
        REQUIRE(std::isfinite(robot.twist.linear));
        REQUIRE(std::isfinite(robot.twist.angular));
      }
    }
  }
}

TEST_CASE("libero's taker of a free ball drives straight at it, also where its mark is at our area's edge",
          "[unit]") {
  const MatchInfo info = infoOf(3);
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  for (const double mark : {-0.375, 0.375}) {
    (*team)->begin(info);
    Observation seen;
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 0.0;
    seen.ball.position = {mark, -0.4};
    const Vec2 places[] = {{-0.71, 0.0}, {mark - 0.2, -0.4}, {-0.3, 0.3}};
    for (std::size_t i = 0; i < 3; ++i) {
      seen.own[i].present = seen.opponents[i].present = true;
      seen.own[i].state.pose.position = places[i];
      seen.opponents[i].state.pose = {{mark + 0.2 + 0.1 * static_cast<double>(i), -0.4}, math::kPi};
    }
    const Twist taker = (*team)->decide(seen).robots[1].twist;
    CHECK(taker.linear > 0.9 * info.robot.maxSpeed());
    CHECK(std::abs(taker.angular) < 0.1);
  }
}

TEST_CASE("libero's penalties: who stands to take it does, and runs on when the keeper comes out", "[unit]") {
  const MatchInfo info = infoOf(3);
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  (*team)->begin(info);
  constexpr std::uint8_t kStriker = 2;
  Observation seen;
  const auto put = [](ObservedRobot& robot, Pose2 pose) {
    robot.present = true;
    robot.state.pose = pose;
  };
  put(seen.own[0], {{-0.71, 0.0}, 0.0});
  put(seen.own[1], {{0.1, 0.4}, 0.0});
  put(seen.own[2], {{0.3, -0.4}, 0.0});
  put(seen.opponents[0], {{0.7, 0.0}, math::kPi});
  put(seen.opponents[1], {{-0.1, 0.25}, math::kPi});
  put(seen.opponents[2], {{-0.1, -0.4}, math::kPi});
  seen.since_restart = 5.0;
  seen.tick = 300;
  seen.ball.position = {0.4, -0.4};
  CHECK((*team)->decide(seen).roles[2] == kStriker);

  seen.restart = RestartKind::kPenalty;
  seen.restart_is_ours = true;
  seen.since_restart = 0.0;
  seen.tick = 301;
  seen.ball.position = {0.375, 0.0};
  put(seen.own[1], {{0.075, -0.03}, 0.1});
  put(seen.own[2], {{-0.06, 0.35}, 0.0});
  const auto taker = [&] {
    const TeamCommand command = (*team)->decide(seen);
    CHECK(command.roles[1] == kStriker);
    return command.robots[1].twist;
  };
  CHECK(taker().linear > 0.9 * info.robot.maxSpeed());
  seen.since_restart = 0.2;
  seen.tick = 313;
  put(seen.own[1], {{0.2, -0.0175}, 0.1});
  put(seen.opponents[0], {{0.55, 0.0}, math::kPi});
  CHECK(std::abs(taker().angular) < 0.1);
}

TEST_CASE("libero plays five a side, and with a navigator of the registry", "[unit]") {
  auto five = matchOf("libero", "libero", "vsss-5v5", 5.0);
  auto match = Match::create(five);
  REQUIRE(match);
  while (match->step()) {
  }
  for (const TeamFaults& team : match->faults().teams) CHECK(team.rejected() == 0);
  CHECK(parseTeam("libero:navigator=bezier,aggression=0.7"));
  CHECK_FALSE(parseTeam("libero:aggression=2"));
  CHECK_FALSE(parseTeam("libero:navigator=nosuch"));
}

TEST_CASE("libero's decisions allocate nothing", "[unit]") {
  const MatchInfo info = infoOf(3);
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  (*team)->begin(info);
  Rng rng{6, Stream::kTest};
  std::vector<Observation> pictures;
  for (int i = 0; i < 200; ++i) pictures.push_back(anything(rng, info));
  const std::uint64_t before = test::allocationCount();
  double sum = 0.0;
  for (const Observation& seen : pictures) sum += (*team)->decide(seen).robots[0].twist.linear;
  CHECK(test::allocationCount() == before);
  CHECK(std::isfinite(sum));
}

TEST_CASE("libero keeps its places legal at every restart", "[unit]") {
  for (const int size : {3, 5}) {
    auto team = makeTeam(*parseTeam("libero"));
    REQUIRE(team);
    const MatchInfo info = infoOf(size);
    (*team)->begin(info);
    for (int kind = 0; kind < 5; ++kind) {
      for (const bool ours : {true, false}) {
        PlacementRequest request{static_cast<RestartKind>(kind), ours, {-0.375, 0.4}, {}, {}};
        const auto placed = (*team)->place(request);
        REQUIRE(placed);
        for (const auto& pose : *placed) {
          if (pose) CHECK(insideField(info.field, pose->position, 0.03));
        }
      }
    }
  }
}

TEST_CASE("libero plays to both hands alike", "[unit]") {
  // The rules' places are mirrored between the sides: what has a hand of its own plays one side worse.
  for (const int size : {3, 5}) {
    const MatchInfo info = infoOf(size);
    Rng rng(11, Stream::kTest, 0);
    int odd = 0;
    for (int round = 0; round < 1000; ++round) {
      Observation seen = anything(rng, info);
      if (seen.own[1].state.pose.position == seen.ball.position) continue;  // no way is the shorter one
      seen.restart_is_ours = round % 2 == 0;
      auto team = makeTeam(*parseTeam("libero")), twin = makeTeam(*parseTeam("libero"));
      REQUIRE(team);
      REQUIRE(twin);
      (*team)->begin(info);
      (*twin)->begin(info);
      const TeamCommand command = (*team)->decide(seen), mirror = (*twin)->decide(acrossAxis(seen));
      for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
        const Twist one = command.robots[i].twist, other_hand = mirror.robots[i].twist;
        const bool alike = std::abs(one.linear - other_hand.linear) < 1e-6 &&
                           std::abs(one.angular + other_hand.angular) < 1e-6;
        odd += alike ? 0 : 1;
      }
    }
    // Where two ways are equally good, as in a corner, rounding may decide.
    CAPTURE(size, odd);
    CHECK(odd <= 2);
  }
}

TEST_CASE("libero begins restarts alike on both sides", "[unit]") {
  for (const RestartKind kind :
       {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kPenalty, RestartKind::kGoalKick}) {
    for (const bool ours : {true, false}) {
      const auto blue = afterRestart(kind, ours, TeamId::kBlue);
      const auto yellow = afterRestart(kind, ours, TeamId::kYellow);
      REQUIRE(blue.size() == yellow.size());
      // Turned where the rules' places are alike on both sides, otherwise mirrored as they are.
      const bool turned = kind == RestartKind::kKickOff;
      for (std::size_t i = 0; i < blue.size(); ++i) {
        CAPTURE(static_cast<int>(kind), ours, i);
        CHECK(yellow[i].x == Approx(-blue[i].x).margin(1e-3));
        CHECK(yellow[i].y == Approx(turned ? -blue[i].y : blue[i].y).margin(1e-3));
      }
    }
  }
}

TEST_CASE("libero plays kick-offs to either hand in turn", "[unit]") {
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  (*team)->begin(infoOf(3));
  for (const bool ours : {true, false}) {
    PlacementRequest request{RestartKind::kKickOff, ours, {}, {}, {}};
    const auto one = (*team)->place(request), next = (*team)->place(request);
    REQUIRE(one);
    REQUIRE(next);
    for (const std::size_t i : {1, 2}) {
      CHECK((*one)[i]->position.y != 0.0);
      CHECK((*one)[i]->position.x == Approx((*next)[i]->position.x));
      CHECK((*one)[i]->position.y == Approx(-(*next)[i]->position.y));
    }
  }
}

TEST_CASE("libero drives at a free ball from its mark beside the area", "[unit]") {
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  const MatchInfo info = infoOf(3);
  (*team)->begin(info);
  Observation seen;
  seen.own[0] = standingAt({{-0.71, 0.1}, 1.57});
  seen.own[1] = standingAt({{-0.575, 0.4}, 0.0});  // nearer to the area than a robot may come in play
  seen.own[2] = standingAt({{0.1, 0.0}, 0.0});
  seen.opponents[0] = standingAt({{-0.175, 0.4}, 3.14});
  seen.ball.position = {-0.375, 0.4};
  seen.restart = RestartKind::kFreeBall;
  for (int i = 0; i < 6; ++i) {
    seen.since_restart = i / 60.0;
    const RobotCommand command = (*team)->decide(seen).robots[1];
    CHECK(command.twist.linear > 0.9 * info.robot.maxSpeed());
    CHECK(std::abs(command.twist.angular) < 3.0);
  }
}

TEST_CASE("libero lets a free ball that is pinched between two slip out to the side wall", "[unit]") {
  const MatchInfo info = infoOf(3);
  for (const double side : {1.0, -1.0}) {
    auto team = makeTeam(*parseTeam("libero"));
    REQUIRE(team);
    (*team)->begin(info);
    Observation seen;
    seen.own[0] = standingAt({{-0.71, 0.0}, 1.57});
    seen.own[1] = standingAt({{-0.434, side * 0.4}, 0.0});
    seen.own[2] = standingAt({{0.1, 0.0}, 0.0});
    seen.opponents[0] = standingAt({{-0.316, side * 0.4}, math::kPi});
    seen.ball.position = {-0.375, side * 0.4};
    seen.restart = RestartKind::kFreeBall;
    Twist first, last;
    for (int i = 0; i < 24; ++i) {
      seen.tick = static_cast<Tick>(12 + i);
      seen.since_restart = static_cast<double>(seen.tick) / 60.0;
      last = (*team)->decide(seen).robots[1].twist;
      if (i == 0) first = last;
    }
    CHECK(std::abs(first.angular) < 0.2);
    CHECK(last.angular * side > 1.0);
    CHECK(last.linear > 0.9 * info.robot.maxSpeed());
  }
}

TEST_CASE("libero waits for a kick-off on both sides of its line", "[unit]") {
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  const MatchInfo info = infoOf(3);
  (*team)->begin(info);
  for (const Vec2 taker : {Vec2{0.2, 0.0}, Vec2{0.165, 0.113}, Vec2{0.165, -0.113}}) {
    PlacementRequest request{RestartKind::kKickOff, false, {}, {}, TeamPlacement{}};
    (*request.opponents)[1] = Pose2{taker, 3.14};
    (*request.opponents)[2] = Pose2{{0.4, 0.0}, 3.14};
    const auto placed = (*team)->place(request);
    REQUIRE(placed);
    const Vec2 meeter = (*placed)[1]->position, support = (*placed)[2]->position;
    CHECK(cross(taker, meeter) * cross(taker, support) < 0.0);
    CHECK(norm(meeter) < norm(support));
    for (const Vec2 place : {meeter, support}) {
      CHECK(norm(place) >= info.field.centre_circle_radius);
      CHECK(place.x < -info.robot.length / 2);
    }
  }
}

TEST_CASE("libero stands at the ball of their goal kick, outside their area", "[unit]") {
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  const MatchInfo info = infoOf(3);
  (*team)->begin(info);
  for (const double side : {1.0, -1.0}) {
    const Vec2 ball{0.6, side * 0.35};
    const auto placed = (*team)->place({RestartKind::kGoalKick, false, ball, {}, {}});
    REQUIRE(placed);
    const Vec2 place = (*placed)[1]->position;
    CHECK(distance(place, ball) < 0.09);
    CHECK(std::abs(place.y) > info.field.goal_area_width / 2 + info.robot.circumradius());
  }
}

TEST_CASE("libero's keeper clears a ball that lies beside its goal, though two wait for it", "[unit]") {
  auto config = matchOf("libero", "idle", "vsss-3v3", 5.0);
  Placement start;
  start.ball = {-0.688, 0.225};
  start.robots[0] = {Pose2{{-0.70, 0.17}, math::kPi / 2}, Pose2{{0.2, 0.3}, 0.0}, Pose2{{0.2, -0.3}, 0.0}};
  start.robots[1] = {Pose2{{-0.50, 0.30}, 0.0}, Pose2{{-0.50, 0.42}, 0.0}};
  config.start = start;
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->seconds() < 1.0 && match->step()) {
  }
  CHECK(distance(match->world().balls[0].position, start.ball) > 0.15);
  CHECK(match->referee().score[1] == 0);
}

TEST_CASE("libero's keeper clears a ball that creeps off it, though two wait for it", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    auto config = matchOf("libero", "idle", "vsss-3v3", 5.0);
    Placement start;
    start.ball = {-0.645, side * -0.079};
    start.ball_velocity = {0.11, side * -0.07};
    start.robots[0] = {Pose2{{-0.745, side * -0.077}, math::kPi / 2}, Pose2{{-0.25, side * -0.45}, 0.0},
                       Pose2{{-0.25, side * 0.3}, 0.0}};
    start.robots[1] = {Pose2{{-0.445, side * -0.25}, 0.0}, Pose2{{-0.369, side * 0.085}, 0.0}};
    config.start = start;
    auto match = Match::create(config);
    REQUIRE(match);
    while (match->seconds() < 1.0 && match->step()) {
    }
    CHECK(distance(match->world().balls[0].position, start.ball) > 0.2);
    CHECK(match->referee().score[1] == 0);
  }
}

TEST_CASE("libero's keeper does not push a ball in that lies behind it in the mouth", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    auto config = matchOf("libero", "idle", "vsss-3v3", 5.0);
    Placement start;
    start.ball = {-0.745, side * -0.006};
    start.robots[0] = {Pose2{{-0.712, side * 0.052}, math::kPi / 2}, Pose2{{-0.25, side * -0.45}, 0.0}};
    config.start = start;
    auto match = Match::create(config);
    REQUIRE(match);
    while (match->seconds() < 1.5 && match->step()) {
    }
    CHECK(match->referee().score[1] == 0);
  }
}

TEST_CASE("libero squeezes a ball that is pressed at the wall of its half out of there", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    auto config = matchOf("libero", "chaser", "vsss-3v3", 10.0);
    Placement start;
    start.ball = {-0.62, side * 0.628};
    start.robots[0][1] = Pose2{{-0.67, side * 0.57}, side * 0.66};
    start.robots[1][1] = Pose2{{-0.56, side * 0.607}, side * -1.9};
    config.start = start;
    auto match = Match::create(config);
    REQUIRE(match);
    while (match->seconds() < 4.0 && match->step()) {
    }
    CHECK(match->world().balls[0].position.x > start.ball.x + 0.15);
    CHECK(match->referee().score[1] == 0);
  }
}

TEST_CASE("libero's keeper goes with a slanting ball that runs on along its face", "[unit]") {
  struct Shot {
    Vec2 ball, velocity;
    double keeper;
  };
  for (const Shot& shot :
       {Shot{{-0.0899, 0.5091}, {-1.605, -1.039}, 0.0428}, Shot{{-0.1979, 0.4284}, {-1.537, -1.056}, 0.0431},
        Shot{{-0.1038, 0.5223}, {-1.500, -0.996}, 0.0448}}) {
    for (const double side : {1.0, -1.0}) {
      CAPTURE(shot.keeper, side);
      auto config = matchOf("libero", "idle", "vsss-3v3", 5.0);
      Placement start;
      start.ball = {shot.ball.x, side * shot.ball.y};
      start.ball_velocity = {shot.velocity.x, side * shot.velocity.y};
      start.robots[0] = {Pose2{{-0.695, side * shot.keeper}, math::kPi / 2}, Pose2{{0.6, -0.5}, 0.0}};
      config.start = start;
      auto match = Match::create(config);
      REQUIRE(match);
      while (match->seconds() < 2.0 && match->step()) {
      }
      CHECK(match->referee().score[1] == 0);
    }
  }
}

TEST_CASE("libero holds against one who presses on its ball head-on", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    auto config = matchOf("libero", "chaser", "vsss-3v3", 10.0);
    Placement start;
    start.ball = {-0.007, side * 0.046};
    start.robots[0][1] = Pose2{{-0.069, side * 0.050}, side * -0.02};
    start.robots[1][0] = Pose2{{0.053, side * 0.050}, side * 3.12};
    config.start = start;
    auto match = Match::create(config);
    REQUIRE(match);
    // Which way the ball leaves the two: sideways or up the field, not pushed back.
    Vec2 moved;
    while (norm(moved) < 0.04 && match->seconds() < 2.0 && match->step()) {
      moved = match->world().balls[0].position - start.ball;
    }
    CHECK(norm(moved) >= 0.04);
    CHECK(moved.x > -0.03);
  }
}

TEST_CASE("libero's striker waits outside their area until a mate has left it", "[unit]") {
  const MatchInfo info = infoOf(3);
  const auto speedToward = [&](Vec2 mate) {
    auto team = makeTeam(*parseTeam("libero"));
    REQUIRE(team);
    (*team)->begin(info);
    Observation seen;
    seen.team_size = 3;
    seen.playing = true;
    seen.since_restart = 5.0;
    seen.own[0] = standingAt({{-0.70, 0.0}, math::kPi / 2});
    seen.own[1] = standingAt({mate, 0.0});
    // The last moment at which it can still stop outside.
    seen.own[2] = standingAt({{0.50, 0.0}, 0.0});
    seen.own[2].state.velocity = {0.6, 0.0};
    seen.ball.position = {0.62, 0.0};
    return (*team)->decide(seen).robots[2].twist.linear;
  };
  CHECK(speedToward({0.20, -0.40}) > 0.3);
  CHECK(speedToward({0.70, -0.25}) < 0.1);
}

TEST_CASE("libero's areas step never lets a robot in that can still stop outside", "[unit]") {
  const MatchInfo info = infoOf(3);
  libero::Pitch pitch(info);
  pitch.braking = pitch.acceleration;  // as `rolledForward`
  const libero::Settings settings;
  const libero::BallForecast ball;
  const double dt = 1.0 / 60.0;
  Rng rng{3, Stream::kTest, 0};
  int near = 0;
  for (int run = 0; run < 400; ++run) {
    const bool own = run % 2 == 0;
    const double sign = own ? 1.0 : -1.0;
    const double least = own ? libero::kOwnMargin : libero::kTheirMargin + pitch.robot_corner;
    const auto outside = [&](Vec2 p) { return libero::outsideOwnArea(pitch, p * sign); };
    Observation seen;
    seen.team_size = 3;
    RobotState& robot = seen.own[1].state;
    seen.own[1].present = true;
    // From rest anywhere, with whatever a skill asks for, changed at random times.
    do {
      robot.pose = {{-sign * rng.uniform(0.3, 0.7), rng.uniform(-0.6, 0.6)}, rng.uniform(-3.14, 3.14)};
    } while (outside(robot.pose.position) < least + 0.01);
    Twist wanted;
    for (int tick = 0; tick < 240; ++tick) {
      if (rng.uniform(0.0, 1.0) < 0.06) wanted = {rng.uniform(-1.2, 1.2), rng.uniform(-12.0, 12.0)};
      const libero::Picture picture{seen, pitch, settings, ball};
      const RobotCommand command = libero::keptOut(picture, 1, {own, !own}, wanted);
      const Twist limited = limitTwist(info.robot, bodyTwist(robot), command.twist, dt);
      const WheelSpeeds wheels = command.kind == RobotCommand::Kind::kWheels
                                     ? command.wheels
                                     : inverseKinematics(info.robot, limited);
      robot = rolledForward(info.robot, robot, saturate(info.robot, wheels), dt);
      const double room = outside(robot.pose.position);
      near += room < least + 0.02 ? 1 : 0;
      // A defender is inside with its centre at the line, an attacker with its corner.
      REQUIRE(room > (own ? 0.0 : pitch.robot_corner - 0.001));
    }
  }
  CHECK(near > 1000);
}

TEST_CASE("libero comes round a lying ball without sliding past it", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    CHECK(scoresAlone({0.533, 0.425}, {{-0.508, -0.193}, -2.98}, side) < 2.4);
    CHECK(scoresAlone({0.532, 0.488}, {{-0.611, -0.241}, 0.09}, side) < 2.4);
  }
}

TEST_CASE("libero turns a ball in that runs along their end wall", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const double y : {0.30, 0.34, 0.42}) {
      CAPTURE(side, y);
      CHECK(scoresAlone({0.7285, y}, {{0.68, y + 0.10}, -1.3}, side) < 3.0);
    }
  }
}

TEST_CASE("libero frees itself from a post of its goal", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    CHECK(scoresAlone({-0.626, 0.189}, {{-0.728, 0.157}, 1.40}, side) < 7.0);
    CHECK(scoresAlone({-0.638, 0.189}, {{-0.721, 0.163}, -1.55}, side) < 7.0);
  }
}

TEST_CASE("libero overtakes a rolling ball whose direction it has to mend", "[unit]") {
  const libero::Pitch pitch(infoOf(3));
  for (const double side : {1.0, -1.0}) {
    RobotState robot;
    robot.pose = {{-0.095, side * 0.01}, side * -0.2};
    robot.velocity = {0.72, 0.0};
    int hand = 0;
    const Twist twist = libero::driveThrough(pitch, robot, {}, {1.0, 0.0}, 0.09, {0.72, 0.0}, hand);
    CHECK(twist.linear > 1.1);
  }
}

}  // namespace fulbito
