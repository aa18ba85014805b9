#pragma once

#include <array>
#include <string>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "fulbito/models.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {

/// A header with two robots of each team, a ball and an obstacle. Blue's second robot is absent in the second
/// play.
inline RecordingHeader sampleHeader(RecordingLevel level = RecordingLevel::kFull) {
  RecordingHeader header;
  header.level = level;
  header.chunk_ticks = 20;
  header.control_rate = 10;
  header.sample_every = 3;
  for (const TeamId team : kTeams) {
    for (std::uint8_t number = 0; number < 2; ++number) {
      header.bodies.push_back({BodyKind::kRobot, RobotId{team, number}});
    }
  }
  header.bodies.push_back({BodyKind::kBall, {}});
  header.bodies.push_back({BodyKind::kObstacle, {}});
  header.recipe.rules = "[rules]\nname = \"own\"\n";
  header.recipe.teams = {"chaser", "idle:speed=0.5"};
  header.recipe.seed = 0xfedcba9876543210u;
  header.recipe.vision = {{3, 0.1 + 0.2, 0.5, 0.25}, {}};
  header.recipe.more = {{"book", "page 7"}};
  header.build = {"0.1.0", "gcc", "Release", "2.4.1"};
  return header;
}

/// The data given to the writer, to compare with the data that is read.
struct Told {
  RecordingHeader header;
  std::vector<RecordedPlay> plays;
  std::vector<std::vector<WheelSpeeds>> commands;  ///< per tick, in the order of the header's robots
  std::vector<WorldState> worlds;
  std::vector<std::uint64_t> hashes;
  std::vector<bool> playing;
  std::vector<RecordedEvent> events;
  RecordingResult result;
  std::string bytes;
};

class Teller {
 public:
  explicit Teller(Told& told)
      : Teller(told, *RecordingWriter::create(
                         [&told](std::string_view bytes) -> Result<void> {
                           told.bytes.append(bytes);
                           return {};
                         },
                         told.header)) {}
  Teller(Told& told, RecordingWriter writer) : told_(told), writer_(std::move(writer)) {}

  void tell(int ticks, bool finish) {
    for (int tick = 0; tick < ticks; ++tick) {
      if (tick % 23 == 0) play(tick, tick == 23);
      step(tick);
      if (tick % 7 == 0) event(tick + 1);
      if (tick % 9 == 0)
        writer_.add(RecordedDrawing{
            tick + 1, TeamId::kYellow, RecordedDrawing::Kind::kText, {0.1234, -0.5}, {}, 0.25, "pass"});
    }
    if (finish) (void)this->finish(ticks);
  }

  RecordingWriter& writer() { return writer_; }
  Result<void> finish(int ticks) {
    told_.result.ticks = ticks;
    told_.result.score = {3, 1};
    told_.result.final_hash = hash_.value();
    told_.result.figures = {{"length", 1.25}};
    return writer_.finish(told_.result);
  }

 private:
  double number() { return 2.0 * rng_.uniform() - 1.0; }
  Vec2 point() { return {number(), number()}; }

  void play(Tick tick, bool one_missing) {
    RecordedPlay play;
    play.tick = tick;
    play.kind = RestartKind::kGoalKick;
    play.team = TeamId::kYellow;
    play.ball = point();
    play.delay = 130;
    play.defenders_back = one_missing;
    play.period = 2;
    play.play_ticks = 3 * tick;
    play.score = {1, 2};
    play.blue_side = Side::kRight;
    play.hash = hash_.value();
    for (std::size_t body = 0; body < told_.header.bodies.size(); ++body) {
      present_[body] = !(one_missing && body == 1);
      RecordedStart start;
      start.present = present_[body];
      if (start.present) start = {true, {point(), number()}, point(), number(), {0.0, -0.0}};
      play.starts.push_back(start);
    }
    writer_.beginPlay(play);
    told_.plays.push_back(play);
  }

  void step(int tick) {
    WorldState world;
    world.tick = tick + 1;
    std::vector<WheelSpeeds> applied, all;
    for (std::size_t robot = 0; robot < 4; ++robot) {
      const WheelSpeeds command =
          roundedTo({50.0 * number(), tick % 11 == 0 ? -0.0 : 50.0 * number()}, told_.header.command_step);
      all.push_back(present_[robot] ? command : WheelSpeeds{});
      if (!present_[robot]) continue;
      applied.push_back(command);
      world.robots.push_back({{point(), 3.0 * number()}, point(), number(), command});
    }
    world.balls.push_back({point(), point(), point()});
    world.obstacles.push_back({{point(), number()}, point()});
    hash_.add(world);
    const bool playing = tick % 13 > 3;
    writer_.add(RecordingTick{&world, applied, hash_.value(), playing});
    told_.commands.push_back(all);
    told_.worlds.push_back(world);
    told_.hashes.push_back(hash_.value());
    told_.playing.push_back(playing);
  }

  void event(Tick tick) {
    RecordedEvent event;
    event.tick = tick;
    event.play_time = number();
    event.period = 2;
    event.clause = "goal-kick.attackers";
    event.law = "8.2";
    if (tick % 2 == 0) event.team = TeamId::kYellow;
    if (tick % 3 == 0) event.robot = std::uint8_t{1};
    event.place = point();
    event.value = number();
    event.threshold = 10.0;
    writer_.add(event);
    told_.events.push_back(event);
  }

  Told& told_;
  RecordingWriter writer_;
  Rng rng_{7, kTestStream, 0};
  StateHash hash_;
  std::array<bool, 6> present_{};
};

inline Told sample(int ticks = 70, bool finish = true, const RecordingHeader& header = sampleHeader()) {
  Told told;
  told.header = header;
  Teller(told).tell(ticks, finish);
  return told;
}

}  // namespace fulbito::test
