#include "referee/restarts/restart_placement.hpp"

#include <cmath>
#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "referee/restarts/restart_call.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/referee/referee_samples.hpp"

namespace fulbito {
namespace {

using testing::setupOf;

constexpr RestartKind kKinds[] = {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kFreeKick,
                                  RestartKind::kPenalty, RestartKind::kGoalKick};

std::string reasonOf(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                     const Placement& placement) {
  const auto flaw = findPlacementFlaw(setup, state, call, placement);
  if (!flaw) return "";
  return std::string(nameOf(call.kind)) + " for " + nameOf(call.team) + ": " + nameOf(flaw->team) + " " +
         std::to_string(flaw->robot) + " " + std::string(flaw->reason);
}

double coordinate(Rng& rng, double scale) {
  const std::uint32_t kind = rng.below(40);
  if (kind == 0) return std::numeric_limits<double>::quiet_NaN();
  if (kind == 1) return std::numeric_limits<double>::infinity();
  if (kind == 2) return -1e300;
  return rng.uniform(-scale, scale);
}

/// Wishes of one team: anywhere, outside, in a heap, or not numbers at all; some robots without a wish.
std::optional<TeamPoses> randomProposal(Rng& rng) {
  if (rng.below(8) == 0) return std::nullopt;
  TeamPoses poses;
  const bool heap = rng.below(3) == 0;
  const double scale = heap ? 0.05 : 1.4;
  const Vec2 about = heap ? Vec2{rng.uniform(-1.2, 1.2), rng.uniform(-1.0, 1.0)} : Vec2{};
  for (auto& pose : poses) {
    if (rng.below(6) == 0) continue;
    pose = Pose2{about + Vec2{coordinate(rng, scale), coordinate(rng, scale)}, coordinate(rng, 4.0)};
  }
  return poses;
}

/// A moment of play with robots that do not overlap.
struct Moment {
  std::vector<RobotId> ids;
  std::vector<RobotState> robots;
  BallState ball;
  MatchView view() const { return {100, ids, robots, ball, {}}; }
};

Moment randomMoment(const RefereeSetup& setup, Rng& rng) {
  Moment moment;
  const double x = setup.field.length / 2 - 0.06, y = setup.field.width / 2 - 0.1;
  moment.ball.position = {rng.uniform(-x, x), rng.uniform(-y, y)};
  for (const TeamId team : kTeams) {
    for (int n = 0; n < setup.rules.team_size; ++n) {
      RobotState robot;
      bool free = false;
      while (!free) {
        robot.pose = {{rng.uniform(-x, x), rng.uniform(-y, y)}, rng.uniform(-3.0, 3.0)};
        free = distance(robot.pose.position, moment.ball.position) > 0.08 &&
               wallClearance(setup.field, robot.pose.position) > 0.054;
        for (const RobotState& placed : moment.robots) {
          free = free && distance(placed.pose.position, robot.pose.position) > 0.107;
        }
      }
      moment.ids.push_back({team, static_cast<std::uint8_t>(n)});
      moment.robots.push_back(robot);
    }
  }
  return moment;
}

Pose2 mirrored(const Pose2& pose) {
  return {{-pose.position.x, pose.position.y}, math::wrapAngle(math::kPi - pose.heading)};
}

TeamPoses mirrored(TeamPoses poses) {
  for (auto& pose : poses) {
    if (pose) pose = mirrored(*pose);
  }
  return poses;
}

bool samePoses(const TeamPoses& a, const TeamPoses& b, double tolerance) {
  for (std::size_t n = 0; n < a.size(); ++n) {
    if (a[n].has_value() != b[n].has_value()) return false;
    if (a[n] && !(distance(a[n]->position, b[n]->position) <= tolerance)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("whatever teams propose, the result is legal, repeatable, and alike for both sides",
          "[unit][repeated]") {
  const auto moments = static_cast<std::uint64_t>(250 * test::repetitions());
  int repaired = 0;
  for (const std::string profile : {"vsss-3v3", "vsss-5v5", "league-program-2021"}) {
    const RefereeSetup setup = setupOf(profile);
    for (std::uint64_t i = 0; i < moments; ++i) {
      Rng rng(7, test::kTestStream, i);
      RefereeState state;
      state.blue_side = rng.below(2) == 0 ? Side::kLeft : Side::kRight;
      const Moment moment = randomMoment(setup, rng);
      const MatchView view = moment.view();
      const RestartKind kind = kKinds[rng.below(5)];
      const TeamId team = kTeams[rng.below(2)];
      RestartCall call = makeCall(setup, state, {kind, team, moment.ball.position, &view});
      call.defenders_back = rng.below(4) == 0;
      const Proposals proposals{randomProposal(rng), randomProposal(rng)};
      std::vector<GameEvent> log, again, other_log;
      const Placement placement = place(setup, state, call, proposals, log);
      INFO(profile << " " << i);
      REQUIRE(reasonOf(setup, state, call, placement) == "");
      for (const TeamId t : kTeams) {
        for (int n = 0; n < setup.rules.team_size; ++n) {
          REQUIRE(placement.robots[indexOf(t)][static_cast<std::size_t>(n)]);
        }
      }
      repaired += static_cast<int>(log.size());

      const Placement second = place(setup, state, call, proposals, again);
      REQUIRE(samePoses(placement.robots[0], second.robots[0], 0.0));
      REQUIRE(samePoses(placement.robots[1], second.robots[1], 0.0));
      REQUIRE(log.size() == again.size());

      // The first team's places do not depend on the other team's wishes.
      Proposals alone = proposals;
      alone[indexOf(other(call.team))].reset();
      const Placement early = place(setup, state, call, alone, other_log);
      REQUIRE(samePoses(placement.robots[indexOf(call.team)], early.robots[indexOf(call.team)], 0.0));

      // Colours exchanged and x mirrored: the same picture.
      RestartCall twin = call;
      twin.team = other(call.team);
      twin.ball.x = -call.ball.x;
      twin.stays = {mirrored(call.stays[1]), mirrored(call.stays[0])};
      twin.rests = {call.rests[1], call.rests[0]};
      twin.defaults.robots = {mirrored(call.defaults.robots[1]), mirrored(call.defaults.robots[0])};
      Proposals swapped;
      for (const std::size_t t : {0u, 1u}) {
        if (proposals[1 - t]) swapped[t] = mirrored(*proposals[1 - t]);
      }
      const Placement mirror = place(setup, state, twin, swapped, other_log);
      REQUIRE(samePoses(mirrored(placement.robots[1]), mirror.robots[0], 1e-9));
      REQUIRE(samePoses(mirrored(placement.robots[0]), mirror.robots[1], 1e-9));
    }
  }
  CHECK(repaired > static_cast<int>(moments) * 3);
}

TEST_CASE("law 14: at a free ball robots stay, but those near the mark and one of each team", "[unit]") {
  const RefereeSetup setup = setupOf("vsss-3v3");
  RefereeState state;
  for (std::uint64_t i = 0; i < 500; ++i) {
    Rng rng(8, test::kTestStream, i);
    const Moment moment = randomMoment(setup, rng);
    const MatchView view = moment.view();
    const RestartCall call =
        makeCall(setup, state, {RestartKind::kFreeBall, TeamId::kBlue, moment.ball.position, &view});
    std::vector<GameEvent> log;
    const Placement placement = place(setup, state, call, {}, log);
    PerTeam<int> moved{};
    for (std::size_t r = 0; r < moment.ids.size(); ++r) {
      const RobotId id = moment.ids[r];
      const Vec2 before = moment.robots[r].pose.position;
      const Vec2 after = placement.robots[indexOf(id.team)][id.number]->position;
      const bool near_mark = distance(before, call.ball) < 0.35;
      if (after != before && !near_mark) ++moved[indexOf(id.team)];
    }
    INFO(i);
    CHECK(moved[0] <= 1);
    CHECK(moved[1] <= 1);
  }
}

namespace {

/// A free ball in the quarter x, y > 0, whose mark is at (0.375, 0.4): blue's robots, then yellow's.
struct FreeBall {
  RefereeSetup setup = setupOf("vsss-3v3");
  RefereeState state;
  Moment moment;
  RestartCall call;
  std::vector<GameEvent> log;
  Placement placement;

  explicit FreeBall(const std::vector<Vec2>& places) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      moment.ids.push_back({i < 3 ? TeamId::kBlue : TeamId::kYellow, static_cast<std::uint8_t>(i % 3)});
      moment.robots.push_back({{places[i], 0.2}, {}, 0.0, {}});
    }
    moment.ball.position = {0.3, 0.3};
    const MatchView view = moment.view();
    call = makeCall(setup, state, {RestartKind::kFreeBall, TeamId::kBlue, moment.ball.position, &view});
    placement = place(setup, state, call, {}, log);
  }
  Vec2 at(std::size_t i) const {
    return placement.robots[indexOf(moment.ids[i].team)][moment.ids[i].number]->position;
  }
};

}  // namespace

TEST_CASE("law 14: a heap of robots that touch or overlap stays as it is, and that is legal", "[unit]") {
  const std::vector<Vec2> places = {{-0.7, 0.0}, {0.0, 0.4},   {0.55, 0.58},
                                    {0.7, 0.0},  {0.55, 0.35}, {0.62, 0.58}};
  FreeBall free_ball(places);
  for (const std::size_t i : {0, 2, 3, 5}) CHECK(free_ball.at(i) == places[i]);
  CHECK(free_ball.placement.robots[0][2]->heading == 0.2);
  CHECK(free_ball.at(1) == Vec2{0.375 - 0.20, 0.4});
  CHECK(free_ball.at(4) == Vec2{0.375 + 0.20, 0.4});
  CHECK(free_ball.log.empty());
  CHECK(reasonOf(free_ball.setup, free_ball.state, free_ball.call, free_ball.placement) == "");
  // The same overlap at another place is still a flaw.
  free_ball.placement.robots[0][2]->position.y -= 0.001;
  CHECK(reasonOf(free_ball.setup, free_ball.state, free_ball.call, free_ball.placement) != "");
}

TEST_CASE("law 14: who takes the mark is chosen after those near it were moved back", "[unit]") {
  const FreeBall free_ball({{-0.7, 0.0}, {0.45, 0.41}, {0.20, 0.30}, {0.7, 0.0}, {0.6, 0.2}, {0.6, -0.2}});
  CHECK(free_ball.at(1) == Vec2{0.375 - 0.20, 0.4});
  CHECK(free_ball.at(2) == Vec2{0.20, 0.30});
}

TEST_CASE("law 14: who is moved into another goes further straight back, and the record says so", "[unit]") {
  const std::vector<Vec2> places = {{-0.7, 0.0}, {0.45, 0.5}, {0.16, 0.39},
                                    {0.7, 0.0},  {0.6, 0.2},  {0.17, 0.53}};
  const FreeBall free_ball(places);
  CHECK(free_ball.at(5) == places[5]);
  CHECK(free_ball.at(2) == Vec2{0.375 - 0.20, 0.4});
  CHECK(free_ball.at(1).y == 0.5);
  const double asked = 0.375 - std::sqrt(0.2 * 0.2 - 0.1 * 0.1);
  CHECK(free_ball.at(1).x < asked - 0.05);
  REQUIRE(free_ball.log.size() == 1);
  CHECK(free_ball.log[0].clause == "placement");
  CHECK(free_ball.log[0].team == TeamId::kBlue);
  CHECK(free_ball.log[0].robot == 1);
  CHECK(free_ball.log[0].value == Approx(asked - free_ball.at(1).x));
}

TEST_CASE("law 14: an opponent on the mark stays, the taker stands beside it", "[unit]") {
  const std::vector<Vec2> places = {{-0.7, 0.0}, {0.0, 0.4}, {-0.3, 0.3},
                                    {0.7, 0.0},  {0.6, 0.2}, {0.172, 0.43}};
  const FreeBall free_ball(places);
  CHECK(free_ball.at(5) == places[5]);
  CHECK(distance(free_ball.at(1), {0.175, 0.4}) > 0.03);
  CHECK(distance(free_ball.at(1), {0.175, 0.4}) < 0.15);
  REQUIRE(free_ball.log.size() == 1);
  CHECK(free_ball.log[0].robot == 1);
}

TEST_CASE("a goal kick is on the side where the keeper stands", "[unit]") {
  const RefereeSetup setup = setupOf("vsss-3v3");
  const RefereeState state;
  for (const double y : {0.2, -0.2}) {
    const std::vector<RobotId> ids{{TeamId::kBlue, 0}, {TeamId::kBlue, 1}};
    const std::vector<RobotState> robots{{{{-0.3, -y}, 0.0}, {}, 0.0, {}}, {{{-0.7, y}, 0.0}, {}, 0.0, {}}};
    const MatchView view{1, ids, robots, {}, {}};
    const RestartCall known = makeCall(setup, state, {RestartKind::kGoalKick, TeamId::kBlue, {}, &view, 1});
    CHECK(known.ball == Vec2{-0.60, y < 0.0 ? -0.35 : 0.35});
    CHECK(defaultPoses(known, TeamId::kBlue)[0]->position == Vec2{-0.675, y < 0.0 ? -0.27 : 0.27});
    // Robot 0 while nobody has kept the goal yet.
    const RestartCall unknown = makeCall(setup, state, {RestartKind::kGoalKick, TeamId::kBlue, {}, &view});
    CHECK(unknown.ball == Vec2{-0.60, y < 0.0 ? 0.35 : -0.35});
  }
}

TEST_CASE("law 14: a team may choose who takes its mark, and nothing else", "[unit]") {
  const RefereeSetup setup = setupOf("vsss-3v3");
  RefereeState state;
  Moment moment;
  for (const TeamId team : kTeams) {
    for (std::uint8_t n = 0; n < 3; ++n) {
      moment.ids.push_back({team, n});
      const double x = (team == TeamId::kBlue ? -0.2 : 0.2) * (n + 1);
      moment.robots.push_back({{{x, -0.4}, 0.0}, {}, 0.0, {}});
    }
  }
  moment.ball.position = {0.3, 0.3};
  const MatchView view = moment.view();
  const RestartCall call =
      makeCall(setup, state, {RestartKind::kFreeBall, TeamId::kBlue, moment.ball.position, &view});
  CHECK(defaultPoses(call, TeamId::kBlue)[0]->position.y == Approx(0.4));
  TeamPoses wish = defaultPoses(call, TeamId::kBlue);
  wish[0] = Pose2{{-0.2, -0.4}, 0.0};
  wish[1] = Pose2{{call.ball.x - 0.20, call.ball.y}, 0.0};
  wish[2] = Pose2{{0.1, 0.0}, 0.0};
  std::vector<GameEvent> log;
  const Placement placement = place(setup, state, call, {wish, std::nullopt}, log);
  CHECK(placement.robots[0][1]->position.x == Approx(0.175));
  CHECK(placement.robots[0][2]->position == Vec2{-0.2 * 3, -0.4});
  CHECK(log.size() == 1);
  CHECK(log.front().robot == 2);
  CHECK(log.front().clause == "placement");
}

TEST_CASE("a repaired place is near the one that was proposed", "[unit]") {
  const RefereeSetup setup = setupOf("vsss-3v3");
  RefereeState state;
  const RestartCall call = makeCall(setup, state, {RestartKind::kKickOff, TeamId::kBlue, {}, nullptr});
  TeamPoses wish;
  wish[1] = Pose2{{0.10, 0.5}, 1.0};     // the other half: back to the line
  wish[2] = Pose2{{-0.05, -0.01}, 0.0};  // free: beside the ball, in the circle
  std::vector<GameEvent> log;
  const Placement placement = place(setup, state, call, {wish, std::nullopt}, log);
  CHECK(placement.robots[0][1]->position.x == Approx(-0.0519).margin(0.001));
  CHECK(placement.robots[0][1]->position.y == Approx(0.5));
  CHECK(placement.robots[0][1]->heading == 1.0);
  CHECK(distance(placement.robots[0][2]->position, {-0.05, -0.01}) < 0.02);
  REQUIRE(log.size() >= 1);
  CHECK(log.front().value == Approx(0.1519).margin(0.001));
}

TEST_CASE("a crowd beyond the tables finds places too, on the field and apart", "[unit]") {
  for (const std::string profile : {"vsss-3v3", "vsss-5v5"}) {
    RefereeSetup setup = setupOf(profile);
    setup.rules.team_size = kMaxTeamSize;
    RefereeState state;
    for (const RestartKind kind : kKinds) {
      const RestartCall call = makeCall(setup, state, {kind, TeamId::kYellow, {0.3, 0.3}, nullptr});
      std::vector<GameEvent> log;
      const Placement placement = place(setup, state, call, {}, log);
      for (const TeamId team : kTeams) {
        for (const auto& pose : placement.robots[indexOf(team)]) CHECK(pose);
      }
      // A free kick asks for more room beside the area than ten defenders find.
      if (kind != RestartKind::kFreeKick) CHECK(reasonOf(setup, state, call, placement) == "");
      RestartCall anywhere = call;
      anywhere.kind = RestartKind::kGiven;
      CHECK(reasonOf(setup, state, anywhere, placement) == "");
    }
  }
}

TEST_CASE("each broken rule of a placement is named", "[unit]") {
  const RefereeSetup setup = setupOf("vsss-3v3");
  RefereeState state;
  struct Row {
    RestartKind kind;
    TeamId team;
    std::size_t robot;
    Vec2 place;
    std::string reason;
  };
  // Blue defends the left goal and takes each restart.
  constexpr auto kBlue = TeamId::kBlue, kYellow = TeamId::kYellow;
  const std::vector<Row> rows = {
      {RestartKind::kKickOff, kBlue, 1, {0.3, 0.0}, "is neither in its own half nor in the circle"},
      {RestartKind::kKickOff, kYellow, 1, {0.1, 0.1}, "is in the centre circle"},
      {RestartKind::kKickOff, kYellow, 1, {-0.3, 0.1}, "is not in its own half"},
      {RestartKind::kKickOff, kYellow, 1, {0.74, 0.64}, "is not on the field"},
      {RestartKind::kKickOff, kBlue, 1, {-0.03, 0.0}, "overlaps the ball"},
      {RestartKind::kKickOff, kBlue, 1, {-0.41, 0.0}, "overlaps a robot"},
      {RestartKind::kPenalty, kBlue, 1, {0.45, 0.0}, "is not behind the ball"},
      {RestartKind::kPenalty, kBlue, 2, {0.1, 0.4}, "is not beyond the half-way line"},
      {RestartKind::kPenalty, kYellow, 1, {0.1, 0.4}, "is not beyond the half-way line"},
      {RestartKind::kPenalty, kYellow, 0, {0.68, 0.0}, "is not on its goal line"},
      {RestartKind::kGoalKick, kBlue, 1, {-0.65, -0.3}, "is in the kicking team's goal area"},
      {RestartKind::kGoalKick, kYellow, 1, {-0.04, 0.3}, "is not in its own half"},
      {RestartKind::kFreeBall, kBlue, 1, {0.2, 0.35}, "is too close to the ball"},
      {RestartKind::kFreeKick, kBlue, 2, {0.1, 0.4}, "is not in its own half"},
      {RestartKind::kFreeKick, kYellow, 1, {0.5625, 0.12}, "does not touch its goal area next to the arc"},
      {RestartKind::kFreeKick, kYellow, 1, {0.50, 0.20}, "does not touch its goal area next to the arc"},
  };
  for (const Row& row : rows) {
    const RestartCall call = makeCall(setup, state, {row.kind, kBlue, {0.3, 0.3}, nullptr});
    Placement placement = call.defaults;
    placement.robots[indexOf(row.team)][row.robot]->position = row.place;
    const auto flaw = findPlacementFlaw(setup, state, call, placement);
    INFO(nameOf(row.kind) << ": " << row.reason);
    REQUIRE(flaw);
    CHECK(flaw->reason == row.reason);
    CHECK_FALSE(legalPlacement(setup, state, call, placement));
  }
}

TEST_CASE("the tables place every restart legally, for both teams and both sides", "[unit]") {
  for (const std::string profile : {"vsss-3v3", "vsss-5v5", "league-program-2021", "training"}) {
    const RefereeSetup setup = setupOf(profile);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      RefereeState state;
      state.blue_side = side;
      for (const RestartKind kind : kKinds) {
        for (const TeamId team : kTeams) {
          for (const Vec2 ball : {Vec2{0.3, 0.3}, Vec2{-0.3, 0.3}, Vec2{-0.3, -0.3}, Vec2{0.3, -0.3}}) {
            const RestartCall call = makeCall(setup, state, {kind, team, ball, nullptr});
            CHECK(reasonOf(setup, state, call, call.defaults) == "");
            std::vector<GameEvent> log;
            const Placement placement = place(setup, state, call, {}, log);
            CHECK(reasonOf(setup, state, call, placement) == "");
            CHECK(log.empty());
            for (const TeamId t : kTeams) {
              for (int n = 0; n < setup.rules.team_size; ++n) {
                const auto& pose = placement.robots[indexOf(t)][static_cast<std::size_t>(n)];
                REQUIRE(pose);
                const auto& own = defaultPoses(call, t)[static_cast<std::size_t>(n)];
                CHECK(pose->position == own->position);
              }
            }
          }
        }
      }
    }
  }
}

TEST_CASE("a free ball's table has one robot of each team beside the ball, toward its own goal", "[unit]") {
  for (const std::string profile : {"vsss-3v3", "vsss-5v5", "league-program-2021", "training"}) {
    const RefereeSetup setup = setupOf(profile);
    const RefereeState state;
    for (const Vec2 ball : {Vec2{0.3, 0.3}, Vec2{-0.3, 0.3}, Vec2{-0.3, -0.3}, Vec2{0.3, -0.3}}) {
      const RestartCall call = makeCall(setup, state, {RestartKind::kFreeBall, TeamId::kBlue, ball, nullptr});
      for (const TeamId team : kTeams) {
        const Vec2 beside = call.ball + Vec2{ownSign(state, team) * setup.rules.free_ball.distance, 0.0};
        CHECK(distance(defaultPoses(call, team)[1]->position, beside) < 1e-9);
      }
    }
  }
}

TEST_CASE("both sides are given the same places, x mirrored", "[unit]") {
  for (const std::string profile : {"vsss-3v3", "vsss-5v5", "league-program-2021", "training"}) {
    const RefereeSetup setup = setupOf(profile);
    RefereeState state, exchanged;
    exchanged.blue_side = opposite(state.blue_side);
    for (const RestartKind kind : kKinds) {
      for (const TeamId team : kTeams) {
        for (const Vec2 ball : {Vec2{0.3, 0.3}, Vec2{-0.3, 0.3}, Vec2{-0.3, -0.3}, Vec2{0.3, -0.3}}) {
          const RestartCall call = makeCall(setup, state, {kind, team, ball, nullptr});
          const RestartCall twin = makeCall(setup, exchanged, {kind, team, {-ball.x, ball.y}, nullptr});
          CAPTURE(profile, static_cast<int>(kind), ball.x, ball.y);
          CHECK(twin.team == call.team);
          CHECK(twin.ball == Vec2{-call.ball.x, call.ball.y});
          for (const TeamId t : kTeams) {
            for (int n = 0; n < setup.rules.team_size; ++n) {
              const auto number = static_cast<std::size_t>(n);
              const Pose2 wanted = mirrored(*defaultPoses(call, t)[number]);
              const Pose2 given = *defaultPoses(twin, t)[number];
              CHECK(given.position == wanted.position);
              CHECK(math::cos(given.heading - wanted.heading) == Approx(1.0));
            }
          }
        }
      }
    }
  }
}

}  // namespace fulbito
