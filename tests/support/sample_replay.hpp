#pragma once

#include <optional>
#include <string>

#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {

/// A recorded match of 20 s without physics: two robots a team drive in circles, the ball goes to the right;
/// a goal for blue at 8 s, then 2 s before the kick-off's signal, and a goal kick for blue at 15 s.
inline ReplayTimeline sampleReplay(const std::vector<std::string>& teams = {"libero", "classic"}) {
  constexpr int kRate = 60;
  RecordingHeader header;
  header.control_rate = kRate;
  header.recipe.teams = teams;
  header.recipe.field = toToml(FieldGeometry{});
  header.recipe.robot = toToml(RobotPreset{});
  for (const TeamId team : kTeams) {
    for (std::uint8_t number = 0; number < 2; ++number) {
      header.bodies.push_back({BodyKind::kRobot, RobotId{team, number}});
    }
  }
  header.bodies.push_back({BodyKind::kBall, {}});
  std::string bytes;
  auto writer = RecordingWriter::create(
      [&bytes](std::string_view more) -> Result<void> {
        bytes.append(more);
        return {};
      },
      header);
  REQUIRE(writer);
  const auto poseOf = [](std::size_t robot, Tick tick) {
    const double turn = 0.02 * static_cast<double>(tick) + 1.6 * static_cast<double>(robot);
    return Pose2{math::unit(math::wrapAngle(turn)) * (0.2 + 0.1 * static_cast<double>(robot)),
                 math::wrapAngle(turn + math::kPi / 2)};
  };
  const auto ballAt = [](Tick tick, Tick since) {
    return Vec2{0.0015 * static_cast<double>(tick - since), 0.1};
  };
  Tick since = 0;
  const auto begin = [&](RestartKind kind, Tick tick, Tick delay, PerTeam<int> score) {
    RecordedPlay play;
    play.kind = kind;
    play.delay = delay;
    play.score = score;
    play.play_ticks = tick;
    since = tick;
    for (std::size_t robot = 0; robot < 4; ++robot)
      play.starts.push_back({true, poseOf(robot, tick), {}, 0.0, {}});
    play.starts.push_back({true, {ballAt(tick, since), 0.0}, {}, 0.0, {}});
    writer->beginPlay(play);
  };
  const auto call = [&](const char* clause, std::optional<TeamId> team) {
    RecordedEvent event;
    event.tick = writer->tick();
    event.clause = clause;
    event.team = team;
    writer->add(event);
  };
  begin(RestartKind::kKickOff, 0, 0, {0, 0});
  for (Tick tick = 1; tick <= 20 * kRate; ++tick) {
    WorldState world;
    for (std::size_t robot = 0; robot < 4; ++robot)
      world.robots.push_back({poseOf(robot, tick), {}, 0.0, {}});
    world.balls.push_back({ballAt(tick, since), {}, {}});
    const bool playing = tick < 8 * kRate || tick >= 10 * kRate;
    const std::vector<WheelSpeeds> none(4);
    writer->add(RecordingTick{&world, none, 0, playing});
    if (tick == 8 * kRate) {
      call("goal", TeamId::kBlue);
      begin(RestartKind::kKickOff, tick, 2 * kRate, {1, 0});
    }
    if (tick == 15 * kRate) {
      call("goal-kick.attackers", TeamId::kYellow);
      begin(RestartKind::kGoalKick, tick, 0, {1, 0});
    }
  }
  RecordingResult result;
  result.score = {1, 0};
  REQUIRE(writer->finish(result));
  const auto reader = RecordingReader::parse(bytes, "sample");
  REQUIRE(reader);
  auto timeline = ReplayTimeline::read(*reader);
  REQUIRE(timeline);
  return std::move(*timeline);
}

}  // namespace fulbito::test
