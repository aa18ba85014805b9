#include "replays/html/recorded_scene.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/models.hpp"
#include "replays/recording/call_words.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito {
namespace {

constexpr double kRowRate = 30.0;      // [Hz]
constexpr double kCommandRate = 10.0;  // [Hz]

/// The shapes of the bodies, read from the files in the recipe.
struct Shapes {
  RobotPreset robot;
  std::vector<ObstacleSpec> obstacles;
};

PageBody bodyOf(const RecordedBody& body, const Shapes& shapes, std::size_t& obstacle) {
  PageBody page{body.kind, body.id, false, 0.0, 0.0, shapes.robot.ball.radius};
  if (body.kind == BodyKind::kRobot) {
    page.box = true;
    page.length = shapes.robot.robot.length;
    page.width = shapes.robot.robot.width;
  } else if (body.kind == BodyKind::kObstacle && obstacle < shapes.obstacles.size()) {
    const ObstacleSpec& spec = shapes.obstacles[obstacle++];
    page.box = spec.shape == ObstacleShape::kBox;
    page.length = spec.length;
    page.width = spec.width;
    page.radius = spec.radius;
  }
  return page;
}

/// The first tick of a play at which its clock runs.
Tick signalOf(const ReplayTimeline& timeline, std::size_t play, ReplayMoment& moment) {
  const auto plays = timeline.plays();
  const Tick end = play + 1 < plays.size() ? plays[play + 1].tick : timeline.ticks() + 1;
  Tick tick = plays[play].tick;
  for (; tick < end; ++tick) {
    timeline.at(timeline.secondsAt(tick), moment);
    if (moment.playing) break;
  }
  return tick;
}

PagePlay pagePlay(const ReplayTimeline& timeline, std::size_t index, ReplayMoment& moment) {
  const RecordedPlay& from = timeline.plays()[index];
  PagePlay play;
  play.tick = from.tick;
  play.signal = signalOf(timeline, index, moment);
  play.clock = static_cast<double>(from.play_ticks) / timeline.header().control_rate;
  play.period = from.period;
  play.score = from.score;
  play.blue_side = from.blue_side;
  if (timeline.header().kind == RecordingKind::kMatch) {
    play.kind = nameOf(from.kind);
    play.team = from.team;
    play.favours = wordsOf(from.kind, from.team, {}).favours;
  }
  for (const RecordedStart& start : from.starts) play.present.push_back(start.present ? 1 : 0);
  return play;
}

PageRow startRow(const RecordedPlay& play) {
  PageRow row{play.tick, {}};
  for (const RecordedStart& start : play.starts) row.poses.push_back(start.pose);
  return row;
}

/// Adds rows for every play: its start, then samples. Samples in excess of the row rate are skipped.
void addRows(const ReplayTimeline& timeline, PageScene& scene) {
  const RecordingHeader& header = timeline.header();
  const double rate = static_cast<double>(header.control_rate) / header.sample_every;
  const auto stride = std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(rate / kRowRate + 0.5)));
  const auto samples = timeline.samples();
  ReplayMoment moment;
  std::size_t next = 0;
  for (std::size_t i = 0; i < timeline.plays().size(); ++i) {
    const RecordedPlay& play = timeline.plays()[i];
    const Tick end = i + 1 < timeline.plays().size() ? timeline.plays()[i + 1].tick : timeline.ticks();
    PagePlay& page = scene.plays.emplace_back(pagePlay(timeline, i, moment));
    page.row = scene.rows.size();
    scene.rows.push_back(startRow(play));
    while (next < samples.size() && samples[next].tick <= play.tick) ++next;
    for (std::size_t count = 1; next < samples.size() && samples[next].tick <= end; ++next, ++count) {
      const bool last = next + 1 == samples.size() || samples[next + 1].tick > end;
      if (count % stride == 0 || last) scene.rows.push_back({samples[next].tick, samples[next].poses});
    }
  }
}

Result<void> addCommands(const RecordingReader& recording, PageCommands& commands) {
  const RecordingHeader& header = recording.header();
  const auto robots = static_cast<std::size_t>(countOf(header, BodyKind::kRobot));
  commands.every = std::max(1, static_cast<int>(std::floor(header.control_rate / kCommandRate + 0.5)));
  for (std::size_t i = 0; i < recording.chunkCount(); ++i) {
    const auto chunk = recording.chunk(i);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    for (int tick = 0; tick < chunk->ticks; ++tick) {
      if ((chunk->first_tick + tick) % commands.every != 0) continue;
      const auto first = chunk->commands.begin() + static_cast<std::ptrdiff_t>(robots) * tick;
      commands.values.insert(commands.values.end(), first, first + static_cast<std::ptrdiff_t>(robots));
    }
  }
  return {};
}

/// The name of the rules profile: the first key of its table. The parser of rules is not available in this
/// layer.
std::string nameOfRules(std::string_view toml) {
  constexpr std::string_view kKey = "name = \"";
  const std::size_t at = toml.find(kKey);
  if (at == std::string_view::npos) return {};
  toml.remove_prefix(at + kKey.size());
  return std::string(toml.substr(0, toml.find('"')));
}

void addFacts(const RecordingReader& recording, const RobotPreset& robot, PageScene& scene) {
  const RecordingHeader& header = recording.header();
  const RecordingRecipe& recipe = header.recipe;
  const auto fact = [&](const char* name, std::string text) {
    if (!text.empty()) scene.facts.emplace_back(name, std::move(text));
  };
  fact("Rules", nameOfRules(recipe.rules));
  fact("Field", scene.field.name);
  fact("Robot", robot.robot.name);
  const auto physics = parsePhysics(recipe.physics, "the recording's physics");
  if (physics) fact("Physics", physics->name);
  fact("Navigator", recipe.navigator);
  fact("Control rate", fmt::format("{} Hz", header.control_rate));
  for (auto& [name, text] : visionWords(recipe)) fact(name.c_str(), std::move(text));
  if (const auto& result = recording.result()) {
    if (header.kind == RecordingKind::kTrial) fact("Outcome", result->outcome);
    for (const auto& [name, value] : result->figures) {
      if (name == "edits")
        fact("Edited", fmt::format("{:.0f} times by hand, so the score is no result", value));
    }
  }
  if (!recording.finished()) fact("File", "cut off: the last seconds are missing");
  fact("Made by", fmt::format("Fulbito {}", header.build.version));
  fact("Compiler", header.build.compiler);
  fact("Box2D", header.build.box2d);
}

Result<Shapes> addLayout(const RecordingRecipe& recipe, PageScene& scene) {
  Shapes shapes;
  auto field = parseField(recipe.field, "the recording's field");
  if (!field) return tl::unexpected<Error>(field.error());
  scene.field = std::move(*field);
  auto robot = parseRobot(recipe.robot, "the recording's robot");
  if (!robot) return tl::unexpected<Error>(robot.error());
  shapes.robot = std::move(*robot);
  if (recipe.layout.empty()) return shapes;
  auto layout = parseLayout(recipe.layout, "the recording's layout");
  if (!layout) return tl::unexpected<Error>(layout.error());
  scene.task = PageTask{layout->start, layout->goal, layout->goal_tolerance, layout->goal_heading};
  scene.title = fmt::format("{}, {}", layout->name, recipe.navigator);
  shapes.obstacles = std::move(layout->obstacles);
  return shapes;
}

}  // namespace

Result<PageScene> recordedScene(const RecordingReader& recording, const ReplayTimeline& timeline) {
  const RecordingHeader& header = timeline.header();
  PageScene scene;
  auto shapes = addLayout(header.recipe, scene);
  if (!shapes) return tl::unexpected<Error>(shapes.error());
  std::size_t obstacle = 0;
  for (const RecordedBody& body : header.bodies) scene.bodies.push_back(bodyOf(body, *shapes, obstacle));
  scene.rate = header.control_rate;
  scene.ticks = timeline.ticks();
  scene.teams = teamNames(header.recipe);
  scene.seed = header.recipe.seed;
  scene.result = timeline.result();
  scene.events.assign(timeline.events().begin(), timeline.events().end());
  scene.drawings.assign(timeline.drawings().begin(), timeline.drawings().end());
  scene.drawing_ticks = drawingTicks(header);
  addRows(timeline, scene);
  if (auto added = addCommands(recording, scene.commands); !added) {
    return tl::unexpected<Error>(added.error());
  }
  addFacts(recording, shapes->robot, scene);
  return scene;
}

}  // namespace fulbito
