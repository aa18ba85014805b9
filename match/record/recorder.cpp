#include "fulbito/recorder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fulbito/models.hpp"
#include "match/record/recorded_values.hpp"
#include "replays/header/header_setup.hpp"

namespace fulbito {
namespace {

RecordingRecipe recipeOf(const MatchConfig& config) {
  RecordingRecipe recipe;
  recipe.rules = toToml(config.rules);
  recipe.physics = toToml(config.physics);
  recipe.robot = toToml(config.robot);
  recipe.field = toToml(config.field);
  recipe.teams = {config.teams[0].text, config.teams[1].text};
  recipe.vision.assign(config.vision.begin(), config.vision.end());
  recipe.seed = config.seed;
  const auto more = [&recipe](const char* name, const auto& value) {
    recipe.more.emplace_back(name, fmt::format("{}", value));
  };
  more("placement_position_error", config.placement_error.position);
  more("placement_heading_error", config.placement_error.heading);
  if (config.decision_time) {
    more("decision_time", config.decision_time->decision);
    more("decision_bank", config.decision_time->bank);
    more("decision_held", config.decision_time->held);
  }
  for (const TeamId team : kTeams) {
    for (const Setting& from : config.teams[indexOf(team)].origin) {
      more(fmt::format("{}_team_{}", nameOf(team), from.name).c_str(), from.value);
    }
  }
  more("start", config.start ? "given" : "kick-off");
  more("scoreboard_blue", config.scoreboard.score[0]);
  more("scoreboard_yellow", config.scoreboard.score[1]);
  more("scoreboard_period", config.scoreboard.period);
  more("scoreboard_play_seconds", config.scoreboard.play_seconds);
  return recipe;
}

RecordedStart startOf(const RobotPlacement& robot) {
  return {true, robot.pose, robot.velocity, robot.angular_velocity, {}};
}

}  // namespace

RecordingHeader recordingHeader(const MatchConfig& config, RecordingLevel level) {
  RecordingHeader header = headerFor(RecordingKind::kMatch, config.physics);
  header.level = level;
  for (const TeamId team : kTeams) {
    for (int i = 0; i < config.rules.team_size; ++i) {
      header.bodies.push_back({BodyKind::kRobot, RobotId{team, static_cast<std::uint8_t>(i)}});
    }
  }
  header.bodies.push_back({BodyKind::kBall, {}});
  header.recipe = recipeOf(config);
  return header;
}

Result<MatchRecorder> MatchRecorder::create(const std::string& file, const MatchConfig& config,
                                            RecordingLevel level, bool replace) {
  auto writer = RecordingWriter::create(file, recordingHeader(config, level), replace);
  if (!writer) return tl::unexpected<Error>(writer.error());
  return MatchRecorder(std::move(*writer));
}

Result<MatchRecorder> MatchRecorder::create(RecordingWriter::Sink sink, const MatchConfig& config,
                                            RecordingLevel level) {
  auto writer = RecordingWriter::create(std::move(sink), recordingHeader(config, level));
  if (!writer) return tl::unexpected<Error>(writer.error());
  return MatchRecorder(std::move(*writer));
}

void MatchRecorder::keepDrawings(int per_second) {
  if (writer_.header().level != RecordingLevel::kFull) return;
  drawn_every_ = std::max(1, writer_.header().control_rate / std::max(1, per_second));
}

void MatchRecorder::onPlayStart(const PlayStart& start) {
  RecordedPlay play;
  play.tick = start.tick;
  play.kind = start.call.kind;
  play.team = start.call.team;
  play.ball = start.call.ball;
  play.delay = start.call.delay;
  play.defenders_back = start.call.defenders_back;
  play.period = start.referee->period;
  play.play_ticks = start.referee->play_ticks;
  play.score = start.referee->score;
  play.blue_side = start.referee->blue_side;
  play.hash = hash_;
  std::size_t next = 0;
  for (const RecordedBody& body : writer_.header().bodies) {
    RecordedStart& place = play.starts.emplace_back();
    if (body.kind == BodyKind::kBall) {
      const BallPlacement& ball = start.world->balls.front();
      place = {true, {ball.position, 0.0}, ball.velocity, 0.0, ball.spin};
    } else if (next < start.ids.size() && body.id == start.ids[next]) {
      place = startOf(start.world->robots[next++]);
    }
  }
  if (start.edited) ++edits_;
  writer_.beginPlay(play);
  for (const GameEvent& event : start.events) add(event);
}

void MatchRecorder::onTick(const MatchTick& tick) {
  hash_ = tick.hash;
  writer_.add(RecordingTick{tick.world, tick.commands, tick.hash, tick.referee->playing});
  for (const GameEvent& event : tick.events) add(event);
  if (wantsDrawings(tick.tick)) addDrawings(tick);
}

void MatchRecorder::add(const GameEvent& event) {
  describe(event, event_);
  writer_.add(event_);
}

void MatchRecorder::addDrawings(const MatchTick& tick) {
  forEachDrawing(tick, [&](const DebugDrawing& drawing, TeamId team) {
    describe(drawing, tick.tick, team, tick.referee->sideOf(team), drawing_);
    writer_.add(drawing_);
  });
}

void MatchRecorder::onMatchEnd(const RefereeState& referee, Tick) {
  RecordingResult result;
  result.complete = referee.ended;
  result.score = referee.score;
  result.final_hash = hash_;
  if (referee.ended) result.outcome = referee.winner ? nameOf(*referee.winner) : "draw";
  if (edits_ > 0) result.figures.emplace_back("edits", edits_);
  written_ = writer_.finish(result);
}

}  // namespace fulbito
