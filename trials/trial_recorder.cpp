#include "trials/trial_recorder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "replays/header/header_setup.hpp"

namespace fulbito {
namespace {

RecordingRecipe recipeOf(const TrialConfig& config) {
  RecordingRecipe recipe;
  recipe.physics = toToml(config.physics);
  recipe.robot = toToml(config.robot);
  recipe.field = toToml(config.field);
  recipe.layout = toToml(config.layout);
  recipe.navigator = config.navigator.text;
  recipe.vision = {config.sensors};
  recipe.seed = config.seed;
  recipe.index = config.index;
  recipe.more.emplace_back("layout", config.layout.name);
  recipe.more.emplace_back("speed", fmt::format("{}", config.robot.robot.maxSpeed()));
  recipe.more.emplace_back("limit_clearance", fmt::format("{}", config.limit_clearance));
  return recipe;
}

RecordingHeader headerOf(const TrialConfig& config) {
  RecordingHeader header = headerFor(RecordingKind::kTrial, config.robot.robot, config.physics);
  header.bodies.push_back({BodyKind::kRobot, {}});
  header.bodies.resize(1 + config.layout.obstacles.size(), {BodyKind::kObstacle, {}});
  header.recipe = recipeOf(config);
  return header;
}

}  // namespace

Result<TrialRecorder> TrialRecorder::create(const std::string& file, const TrialConfig& config,
                                            bool replace) {
  auto writer = RecordingWriter::create(file, headerOf(config), replace);
  if (!writer) return tl::unexpected<Error>(writer.error());
  return TrialRecorder(std::move(*writer));
}

Result<TrialRecorder> TrialRecorder::create(RecordingWriter::Sink sink, const TrialConfig& config) {
  auto writer = RecordingWriter::create(std::move(sink), headerOf(config));
  if (!writer) return tl::unexpected<Error>(writer.error());
  return TrialRecorder(std::move(*writer));
}

void TrialRecorder::begins(const WorldState& world) {
  RecordedPlay play;
  const RobotState& robot = world.robots.front();
  play.starts.push_back({true, robot.pose, robot.velocity, robot.angular_velocity, {}});
  for (const ObstacleState& obstacle : world.obstacles) {
    play.starts.push_back({true, obstacle.pose, {}, 0.0, {}});
  }
  writer_.beginPlay(play);
}

void TrialRecorder::keepGuidance() { drawn_every_ = std::max(1, writer_.header().control_rate / 10); }

void TrialRecorder::planned(const Guidance& guidance, Vec2 position, Vec2 goal) {
  strokes_.clear();
  if (drawn_every_ > 0 && (writer_.tick() + 1) % drawn_every_ == 0) {
    addStrokes(guidance, position, goal, strokes_);
  }
}

void TrialRecorder::ticked(const WorldState& world, WheelSpeeds command, std::uint64_t hash) {
  writer_.add(RecordingTick{&world, {&command, 1}, hash, true});
  for (const GuidanceStroke& stroke : strokes_) {
    RecordedDrawing drawing;
    drawing.tick = writer_.tick();
    drawing.from = stroke.from;
    drawing.to = stroke.to;
    writer_.add(drawing);
  }
}

Result<void> TrialRecorder::ends(const TrialResult& result) {
  const TrialScore& score = result.score;
  RecordingResult end;
  end.outcome = nameOf(score.outcome);
  end.final_hash = result.final_hash;
  end.figures = {{"time_s", score.time},
                 {"time_limit_s", score.time_limit},
                 {"length_m", score.length},
                 {"length_limit_m", score.length_limit},
                 {"obstacle_contacts", score.obstacle_contacts},
                 {"wall_contacts", score.wall_contacts},
                 {"min_clearance_m", score.min_clearance}};
  return writer_.finish(end);
}

}  // namespace fulbito
