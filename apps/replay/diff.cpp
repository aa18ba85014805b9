#include "replays/verify/diff.hpp"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/replay/replay.hpp"
#include "engine/core/base/text_controls.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownBodies = 8;

Json toJson(const ReplayDiffCommand& options, const RecordingDifference& found, double dt) {
  Json json{{"schema_version", 1}, {"a", options.a}, {"b", options.b}, {"same", found.same()}};
  json["recipe"] = Json::array();
  for (const RecipeDifference& d : found.recipe) {
    json["recipe"].push_back({{"name", d.name}, {"a", d.a}, {"b", d.b}});
  }
  json["comparable"] = found.comparable;
  json["ticks"] = {found.ticks_a, found.ticks_b};
  json["tick"] = found.tick ? Json(*found.tick) : Json(nullptr);
  if (!found.tick) return json;
  json["time_s"] = static_cast<double>(*found.tick) * dt;
  json["play"] = found.play;
  json["start_of_play"] = found.start;
  json["bodies"] = Json::array();
  for (const BodyDifference& d : found.bodies) {
    json["bodies"].push_back({{"body", d.body_name}, {"field", d.field}, {"a", d.a}, {"b", d.b}});
  }
  return json;
}

void printTicks(const RecordingDifference& found, double dt) {
  if (!found.comparable) {
    say("different bodies or control rates: the ticks cannot be compared\n");
    return;
  }
  if (!found.tick) {
    const Tick both = std::min(found.ticks_a, found.ticks_b);
    say("all {} ticks ({:.3f} s) are identical, bit for bit\n", both, static_cast<double>(both) * dt);
    if (found.ticks_a != found.ticks_b) {
      say("{} continues for {} more ticks\n", found.ticks_a > found.ticks_b ? "A" : "B",
          std::max(found.ticks_a, found.ticks_b) - both);
    }
    return;
  }
  say("first difference at tick {} ({:.3f} s), in play {}{}\n", *found.tick,
      static_cast<double>(*found.tick) * dt, found.play + 1,
      found.start ? ", whose start already differs" : "");
  std::size_t shown = 0;
  for (const BodyDifference& d : found.bodies) {
    if (shown++ == kShownBodies) {
      say("  and {} more\n", found.bodies.size() - kShownBodies);
      break;
    }
    say("  {} of {}: {:.9g} in A, {:.9g} in B\n", d.field, d.body_name, d.a, d.b);
  }
  if (found.bodies.empty()) say("  simulated again, both are identical there: see fulbito replay verify\n");
}

}  // namespace

CLI::App* addReplayDiff(CLI::App& replay, ReplayDiffCommand& options) {
  CLI::App* command = replay.add_subcommand("diff", "show the first difference between two recordings");
  command->footer(
      "Examples:\n"
      "  fulbito replay diff game.fbr other.fbr\n"
      "  fulbito replay diff game.fbr other.fbr --json\n"
      "Exit codes: 0 identical, 1 different.");
  command->add_option("a", options.a, "first recording (.fbr)")->required();
  command->add_option("b", options.b, "second recording (.fbr)")->required();
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int replayDiff(const ReplayDiffCommand& options) {
  const auto a = RecordingReader::open(options.a), b = RecordingReader::open(options.b);
  if (!a) return report(a.error());
  if (!b) return report(b.error());
  const auto found = diff(*a, *b);
  if (!found) return report(found.error());
  const double dt = 1.0 / a->header().control_rate;
  if (options.json) {
    writeOut(escapedJson(toJson(options, *found, dt).dump(2, ' ', false, Json::error_handler_t::replace)) +
             "\n");
  } else {
    say("A = {}, B = {}\n", options.a, options.b);
    for (const RecipeDifference& d : found->recipe) {
      say("{}: {} in A, {} in B\n", d.name, d.a.empty() ? "nothing" : d.a, d.b.empty() ? "nothing" : d.b);
    }
    printTicks(*found, dt);
  }
  return found->same() ? kOk : kTestFailed;
}

}  // namespace fulbito::app
