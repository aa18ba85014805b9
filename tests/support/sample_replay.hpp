#pragma once

#include <optional>
#include <string>

#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {

/// Writes a recording tick by tick, without physics: two robots a team drive in circles, the ball goes to the
/// right from where each play begins.
class SampleRecording {
 public:
  static constexpr Tick kRate = 60;

  explicit SampleRecording(const std::vector<std::string>& teams)
      : writer_(*RecordingWriter::create(
            [this](std::string_view more) -> Result<void> {
              bytes_.append(more);
              return {};
            },
            headerOf(teams))) {}
  SampleRecording(const SampleRecording&) = delete;
  SampleRecording& operator=(const SampleRecording&) = delete;

  void begin(RestartKind kind, Tick tick, Tick delay, PerTeam<int> score) {
    RecordedPlay play;
    play.kind = kind;
    play.delay = delay;
    play.score = score;
    play.play_ticks = since_ = tick;
    for (std::size_t robot = 0; robot < 4; ++robot)
      play.starts.push_back({true, poseOf(robot, tick), {}, 0.0, {}});
    play.starts.push_back({true, {ballAt(tick), 0.0}, {}, 0.0, {}});
    writer_.beginPlay(play);
  }
  void call(const char* clause, std::optional<TeamId> team) {
    RecordedEvent event;
    event.tick = writer_.tick();
    event.clause = clause;
    event.team = team;
    writer_.add(event);
  }
  void add(Tick tick, bool playing) {
    WorldState world;
    for (std::size_t robot = 0; robot < 4; ++robot)
      world.robots.push_back({poseOf(robot, tick), {}, 0.0, {}});
    world.balls.push_back({ballAt(tick), {}, {}});
    const std::vector<WheelSpeeds> none(4);
    writer_.add(RecordingTick{&world, none, 0, playing});
  }
  ReplayTimeline finish(PerTeam<int> score) {
    RecordingResult result;
    result.score = score;
    REQUIRE(writer_.finish(result));
    const auto reader = RecordingReader::parse(bytes_, "sample");
    REQUIRE(reader);
    auto timeline = ReplayTimeline::read(*reader);
    REQUIRE(timeline);
    return std::move(*timeline);
  }

 private:
  static RecordingHeader headerOf(const std::vector<std::string>& teams) {
    RecordingHeader header;
    header.control_rate = kRate;
    header.recipe.teams = teams;
    header.recipe.field = toToml(FieldGeometry{});
    header.recipe.robot = toToml(RobotPreset{});
    for (const TeamId team : kTeams) {
      for (std::uint8_t number = 0; number < 2; ++number)
        header.bodies.push_back({BodyKind::kRobot, RobotId{team, number}});
    }
    header.bodies.push_back({BodyKind::kBall, {}});
    return header;
  }
  static Pose2 poseOf(std::size_t robot, Tick tick) {
    const double turn = 0.02 * static_cast<double>(tick) + 1.6 * static_cast<double>(robot);
    return {math::unit(math::wrapAngle(turn)) * (0.2 + 0.1 * static_cast<double>(robot)),
            math::wrapAngle(turn + math::kPi / 2)};
  }
  Vec2 ballAt(Tick tick) const { return {0.0015 * static_cast<double>(tick - since_), 0.1}; }

  std::string bytes_;
  RecordingWriter writer_;
  Tick since_ = 0;
};

/// A recorded match of 20 s: a goal for blue at 8 s, then 2 s before the kick-off's signal, and a goal kick
/// for blue at 15 s.
inline ReplayTimeline sampleReplay(const std::vector<std::string>& teams = {"libero", "classic"}) {
  constexpr Tick kRate = SampleRecording::kRate;
  SampleRecording recording(teams);
  recording.begin(RestartKind::kKickOff, 0, 0, {0, 0});
  for (Tick tick = 1; tick <= 20 * kRate; ++tick) {
    recording.add(tick, tick < 8 * kRate || tick >= 10 * kRate);
    if (tick == 8 * kRate) {
      recording.call("goal", TeamId::kBlue);
      recording.begin(RestartKind::kKickOff, tick, 2 * kRate, {1, 0});
    }
    if (tick == 15 * kRate) {
      recording.call("goal-kick.attackers", TeamId::kYellow);
      recording.begin(RestartKind::kGoalKick, tick, 0, {1, 0});
    }
  }
  return recording.finish({1, 0});
}

}  // namespace fulbito::test
