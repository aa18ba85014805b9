#include <cstdio>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/replay/replay.hpp"
#include "engine/core/base/text_controls.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "match/record/recorded_events.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers summed over the whole recording.
struct Tally {
  std::int64_t plays = 0;
  std::map<std::string, int> calls, restarts;
  std::size_t drawings = 0, samples = 0;
};

Result<Tally> tallyOf(const RecordingReader& recording) {
  Tally tally;
  for (std::size_t i = 0; i < recording.chunkCount(); ++i) {
    const auto chunk = recording.chunk(i);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    tally.plays += static_cast<std::int64_t>(chunk->plays.size());
    for (const RecordedPlay& play : chunk->plays) ++tally.restarts[nameOf(play.kind)];
    for (const RecordedEvent& event : chunk->events) ++tally.calls[event.clause];
    tally.drawings += chunk->drawings.size();
    tally.samples += chunk->samples.size();
  }
  return tally;
}

/// The names in the texts of the recipe; empty for a text that cannot be parsed.
struct RecipeNames {
  std::string rules, physics, robot, field;
};

template <typename T, typename Name>
std::string nameIn(const Result<T>& parsed, const Name& name) {
  return parsed ? name(*parsed) : std::string();
}

RecipeNames namesOf(const RecordingRecipe& recipe) {
  const auto own = [](const auto& value) { return value.name; };
  return {
      nameIn(parseRules(recipe.rules, "rules"), own), nameIn(parsePhysics(recipe.physics, "physics"), own),
      nameIn(parseRobot(recipe.robot, "robot"), [](const RobotPreset& robot) { return robot.robot.name; }),
      nameIn(parseField(recipe.field, "field"), own)};
}

const char* kindOf(const RecordingHeader& header) {
  return header.kind == RecordingKind::kTrial ? "trial" : "match";
}
const char* levelOf(const RecordingHeader& header) {
  return header.level == RecordingLevel::kFull ? "full" : "recipe";
}
/// How the recording ends: completed, stopped early, or cut off.
const char* endOf(const RecordingReader& recording) {
  if (!recording.finished()) return "cut";
  return recording.result()->complete ? "finished" : "stopped";
}

Json countsJson(const std::map<std::string, int>& counts) {
  Json json = Json::object();
  for (const auto& [name, count] : counts) json[name] = count;
  return json;
}

Json resultJson(const RecordingReader& recording) {
  if (!recording.result()) return nullptr;
  const RecordingResult& result = *recording.result();
  Json json{{"outcome", result.outcome}, {"complete", result.complete}};
  if (recording.header().kind == RecordingKind::kMatch) {
    json["score"] = {{"blue", result.score[0]}, {"yellow", result.score[1]}};
  }
  json["final_hash"] = fmt::format("{:016x}", result.final_hash);
  json["figures"] = Json::object();
  for (const auto& [name, value] : result.figures) json["figures"][name] = value;
  return json;
}

Json sensorsJson(const SensorModel& sensors) {
  return {{"latency_ticks", sensors.latency_ticks},
          {"position_noise_m", sensors.position_noise},
          {"heading_noise_rad", sensors.heading_noise},
          {"dropout", sensors.dropout}};
}

Json recipeJson(const RecordingHeader& header) {
  const RecordingRecipe& recipe = header.recipe;
  const RecipeNames names = namesOf(recipe);
  Json json{{"seed", recipe.seed}};
  if (header.kind == RecordingKind::kTrial) {
    json["navigator"] = recipe.navigator;
    json["index"] = recipe.index;
  } else {
    json["teams"] = recipe.teams;
    json["rules"] = names.rules;
  }
  json["physics"] = names.physics;
  json["robot"] = names.robot;
  json["field"] = names.field;
  for (std::size_t i = 0; i < recipe.vision.size(); ++i) {
    const bool trial = header.kind == RecordingKind::kTrial;
    json["vision"][trial ? "robot" : i == 0 ? "blue" : "yellow"] = sensorsJson(recipe.vision[i]);
  }
  json["more"] = Json::object();
  for (const auto& [name, text] : recipe.more) json["more"][name] = text;
  return json;
}

Json toJson(const std::string& file, const RecordingReader& recording, const Tally& tally) {
  const RecordingHeader& header = recording.header();
  Json json{{"schema_version", 1},
            {"file", file},
            {"format_version", kRecordingVersion},
            {"kind", kindOf(header)},
            {"level", levelOf(header)},
            {"heard", header.heard},
            {"end", endOf(recording)},
            {"control_rate", header.control_rate},
            {"ticks", recording.ticks()},
            {"simulated_s", static_cast<double>(recording.ticks()) / header.control_rate},
            {"plays", tally.plays},
            {"bodies", header.bodies.size()},
            {"recipe", recipeJson(header)},
            {"result", resultJson(recording)},
            {"restarts", countsJson(tally.restarts)},
            {"events", countsJson(tally.calls)},
            {"samples", tally.samples},
            {"drawings", tally.drawings},
            {"bytes", recording.sizeInBytes()},
            {"chunks", recording.chunkCount()}};
  for (const RecordingPart& part : recording.sizeByPart()) json["bytes_by_part"][part.name] = part.bytes;
  json["build"] = {{"version", header.build.version},
                   {"compiler", header.build.compiler},
                   {"type", header.build.type},
                   {"box2d", header.build.box2d}};
  return json;
}

std::string countsText(const std::map<std::string, int>& counts) {
  std::string text;
  for (const auto& [name, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", oneLine(name), count);
  }
  return text.empty() ? "none" : text;
}

std::string whoText(const RecordingReader& recording) {
  const RecordingRecipe& recipe = recording.header().recipe;
  const auto& result = recording.result();
  if (recording.header().kind == RecordingKind::kTrial) {
    return fmt::format("  navigator  {}{}\n", oneLine(recipe.navigator),
                       result ? ": " + oneLine(result->outcome) : "");
  }
  const auto team = [&](std::size_t i) { return i < recipe.teams.size() ? oneLine(recipe.teams[i]) : "?"; };
  if (!result) return fmt::format("  teams      {} (blue), {} (yellow)\n", team(0), team(1));
  return fmt::format("  teams      {} (blue) {} : {} {} (yellow)\n", team(0), result->score[0],
                     result->score[1], team(1));
}

std::string recipeText(const RecordingHeader& header) {
  const RecordingRecipe& recipe = header.recipe;
  const RecipeNames names = namesOf(recipe);
  std::string text = "  recipe     ";
  if (header.kind == RecordingKind::kMatch) text += fmt::format("rules {}, ", oneLine(names.rules));
  text += fmt::format("physics {}, robot {}, field {}, seed {}\n", oneLine(names.physics),
                      oneLine(names.robot), oneLine(names.field), recipe.seed);
  for (const auto& [name, value] : visionWords(recipe)) text += fmt::format("  {}: {}\n", name, value);
  for (const auto& [name, value] : recipe.more) {
    if (name.starts_with("cut_")) text += fmt::format("  {:<10} {}\n", oneLine(name), oneLine(value));
  }
  return text;
}

void print(const std::string& file, const RecordingReader& recording, const Tally& tally) {
  const RecordingHeader& header = recording.header();
  say("{}: {}, level {}, format {}, {}\n", file, kindOf(header), levelOf(header), kRecordingVersion,
      endOf(recording));
  if (header.heard) say("  heard      by fulbito record: another program's motion\n");
  say("{}{}", whoText(recording), recipeText(header));
  say("  length     {:.1f} s, {} ticks at {} Hz, {} plays\n",
      static_cast<double>(recording.ticks()) / header.control_rate, recording.ticks(), header.control_rate,
      tally.plays);
  if (header.kind == RecordingKind::kMatch) {
    say("  restarts   {}\n  events     {}\n", countsText(tally.restarts), countsText(tally.calls));
  }
  if (header.heard && recording.result()) {
    for (const auto& [name, value] : recording.result()->figures) say("  {:<10} {}\n", oneLine(name), value);
  }
  if (recording.result()) say("  hash       {:016x}\n", recording.result()->final_hash);
  say("  build      {}, {}, {}, Box2D {}\n", oneLine(header.build.version), oneLine(header.build.compiler),
      oneLine(header.build.type), oneLine(header.build.box2d));
  say("  size       {} bytes in {} chunks\n", recording.sizeInBytes(), recording.chunkCount());
  for (const RecordingPart& part : recording.sizeByPart()) {
    say("    {:<9}{:>10} {:>5.1f} %\n", part.name, part.bytes,
        100.0 * static_cast<double>(part.bytes) / static_cast<double>(recording.sizeInBytes()));
  }
}

}  // namespace

CLI::App* addReplayInfo(CLI::App& replay, ReplayInfoCommand& options) {
  CLI::App* command =
      replay.add_subcommand("info", "show what a recording contains and what takes its space");
  command->footer("Examples:\n  fulbito replay info game.fbr\n  fulbito replay info game.fbr --json");
  command->add_option("file", options.file, "recording (.fbr)")->required();
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int replayInfo(const ReplayInfoCommand& options) {
  const auto recording = RecordingReader::open(options.file);
  if (!recording) return report(recording.error());
  const auto tally = tallyOf(*recording);
  if (!tally) return report(tally.error());
  if (options.json) {
    writeOut(
        escapedJson(
            toJson(options.file, *recording, *tally).dump(2, ' ', false, Json::error_handler_t::replace)) +
        "\n");
  } else {
    print(options.file, *recording, *tally);
  }
  return kOk;
}

}  // namespace fulbito::app
