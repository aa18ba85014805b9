#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "engine/core/base/assert.hpp"
#include "engine/core/config/config_document.hpp"
#include "engine/core/config/embedded_files.hpp"
#include "engine/core/config/schema.hpp"
#include "engine/core/config/suggest.hpp"
#include "engine/core/system/io_code.hpp"
#include "engine/core/system/text_file.hpp"
#include "match/drills/drill.hpp"
#include "match/drills/ideal.hpp"

namespace fulbito {

std::span<const EmbeddedFile> embeddedDrills();

namespace {

constexpr double kFar = 12.0;  // [m] half of the largest field with a goal, plus a margin
constexpr int kMaxTrials = 1000000;
constexpr double kLongName = 100;
constexpr double kLongText = 300;

Schema schemaOf(Drill& d, std::string& repeats) {
  return {
      {"number", &d.number, 1, 9999, "", "number for selecting the drill", true},
      {"name", Label{&d.name}, 1, kLongName, "", "name for selecting the drill"},
      {"what", &d.what, 1, kLongText, "", "one line", true},
      {"source", &d.source, 0, kLongText, "", "where the bar comes from"},
      {"rules", &d.rules, 1, kLongText, "", "profile of the rules"},
      {"referee", &d.referee, 0, 1, "", "false: only goals stop play"},
      {"trials", &d.trials, 1, kMaxTrials, "", "or matches"},
      {"agent", &d.agent, -1, kMaxTeamSize - 1, "", "robot of an environment's agent; -1: the lowest number"},
      {"duration", &d.duration, 0.1, 600.0, "s", "of a trial"},
      {"after", &d.after, 0.0, 60.0, "s", "watched after a success"},
      {"latency", &d.latency, 0.0, 1.0, "s", "T of the least savable distance"},
      {"acceleration_share", &d.acceleration_share, 0.01, 1.0, "",
       "a of the same, as a share of the robot's"},
      {"tolerance", &d.tolerance, 0.0, 1.0, "m", "of the task"},
      {"heading_tolerance", Angle{&d.heading_tolerance}, 0.0, 180.0, "", "of the task"},
      {"match_opponent", &d.match_opponent, 0, kLongText, "", "whole matches against it"},
      {"half_seconds", &d.half_seconds, 1.0, 3600.0, "s", "of such a match"},
      {"repeats", &repeats, 0, kLongText, "", "numbers of the drills to repeat under [sight]"},
  };
}

Schema schemaOf(DrillStart& s) {
  return {
      {"name", Label{&s.name}, 1, kLongName, "", ""},
      {"task", choice(s.task, {"play", "reach-pose", "turn", "reach-ball", "push", "predict-ball"}), 0, 0, "",
       "the team's task"},
      {"restart",
       Choice{{"none", "kick-off", "free-ball", "free-kick", "penalty", "goal-kick"},
              [&s] { return s.restart + 1; },
              [&s](int index) { s.restart = index - 1; }},
       0, 0, "", "that play begins with; without robots of the drill's own, the referee places all"},
      {"ours", &s.ours, 0, 1, "", "the tested team takes it"},
      {"opponents", &s.opponents, 0, kLongText, "", "a team, or 'itself'"},
      {"duration", &s.duration, 0.0, 600.0, "s", "instead of the drill's"},
      {"ball", &s.ball, -kFar, kFar, "m", "places"},
      {"ball_spread", &s.ball_spread, 0.0, kFar, "m", "to either side"},
      {"toward", &s.toward, -kFar, kFar, "m", "the ball rolls toward a point between the first and the last"},
      {"speed_min", &s.speed_min, 0.0, 6.0, "m/s", "of the ball"},
      {"speed_max", &s.speed_max, 0.0, 6.0, "m/s", "of the ball"},
      {"distance_min", &s.distance_min, 0.0, kFar, "m", "of the ball from that point"},
      {"distance_max", &s.distance_max, 0.0, kFar, "m", "of the ball from that point"},
      {"savable", &s.savable, 0.0, 10.0, "", "least savable distances added to it"},
      {"savable_speed", &s.savable_speed, 0.0, 6.0, "m/s",
       "of the shot that they are for; 0: each shot's own"},
      {"angle", Angle{&s.angle}, 0.0, 89.0, "", "largest one between the ball's way and the goal's normal"},
      {"enters", &s.enters, 0, 1, "", "the untouched ball goes into the own goal"},
      {"bounces", &s.bounces, -1, 100, "", "of the ball against walls; -1: any"},
      {"decided", &s.decided, 0, 1, "", "trials without success and failure do not count"},
      {"target_min", &s.target_min, 0.0, kFar, "m", "distance of the task's target"},
      {"target_max", &s.target_max, 0.0, kFar, "m", "distance of the task's target"},
      {"turn_min", Angle{&s.turn_min}, -180.0, 180.0, "", "from the robot's heading to the task's"},
      {"turn_max", Angle{&s.turn_max}, -180.0, 180.0, "", "from the robot's heading to the task's"},
      {"task_speed", &s.task_speed, 0.0, 10.0, "m/s", "asked for"},
      {"horizon", &s.horizon, 0.0, 10.0, "s", "of a prediction"},
  };
}

Schema schemaOf(DrillRobot& r) {
  return {
      {"team", choice(r.team, {"own", "opponent"}), 0, 0, "", ""},
      {"number", &r.number, -1, kMaxTeamSize - 1, "", "in its team; -1: the next one"},
      {"plays", choice(r.plays, {"team", "stand", "chase", "keep", "press"}), 0, 0, "", ""},
      {"start", &r.start, 0, kLongName, "", "only in that start"},
      {"at", &r.at, -kFar, kFar, "m", "places", true},
      {"spread", &r.spread, 0.0, kFar, "m", "to either side"},
      {"from_ball", &r.from_ball, 0, 1, "", "places count from the ball"},
      {"behind_ball", &r.behind_ball, 0, 1, "", "with x toward the opponents' goal"},
      {"equal_gap", &r.equal_gap, 0, 1, "", "y leaves equal gaps to both posts as seen from the ball"},
      {"face_ball", &r.face_ball, 0, 1, "", "the heading counts from the ball's direction"},
      {"heading", Angle{&r.heading}, -180.0, 180.0, "", ""},
      {"heading_spread", Angle{&r.heading_spread}, 0.0, 180.0, "", "to either side"},
  };
}

Schema schemaOf(DrillEnd& e) {
  return {
      {"what",
       choice(e.what, {"goal", "conceded", "touched", "gained", "driven", "off-wall", "away", "near-mouth",
                       "cleared", "lasted"}),
       0, 0, "", "", true},
      {"start", &e.start, 0, kLongName, "", "only in that start"},
      {"value", &e.value, 0.0, kFar, "m", ""},
      {"within", &e.within, 0.0, 1e9, "s", ""},
  };
}

Schema schemaOf(DrillBar& b) {
  return {
      {"value",
       choice(b.value,
              {"success", "time", "excess", "error", "on-target", "own-goal", "conceded", "illegal",
               "early-goal", "area-foul", "own-stall", "switch", "flap", "win", "margin", "bias", "kept"}),
       0, 0, "", "", true},
      {"statistic", choice(b.statistic, {"rate", "count", "mean", "median", "p95"}), 0, 0, "", "", true},
      {"start", &b.start, 0, kLongName, "", "only of that start"},
      {"within", &b.within, -1e6, 1e6, "", "rate of values up to that"},
      {"at_least", &b.at_least, -1e6, 1e6, "", ""},
      {"at_most", &b.at_most, -1e6, 1e6, "", ""},
      {"by_value", &b.by_value, 0, 1, "", "not by the interval"},
      {"of_least", &b.of_least, 0, 1, "", "times as multiples of the least times"},
  };
}

Schema schemaOf(VisionModel& v) {
  return {
      {"latency_ticks", &v.latency_ticks, 0, kMaxLatencyTicks, "", "age of observations"},
      {"position_noise", &v.position_noise, 0.0, kMaxPositionNoise, "m", "standard deviation"},
      {"heading_noise", Angle{&v.heading_noise}, 0.0, 57.0, "", "standard deviation"},
      {"dropout", &v.dropout, 0.0, kMaxDropout, "", "chance that a body is not seen"},
  };
}

template <typename T>
Result<void> readAll(const ConfigDocument& document, const std::string& table, std::vector<T>& values) {
  const auto count = document.count(table);
  if (!count) return tl::unexpected<Error>(count.error());
  for (int i = 0; i < *count; ++i) {
    T value;
    if (auto read = document.readElement(table, i, schemaOf(value)); !read) return read;
    values.push_back(std::move(value));
  }
  return {};
}

/// The flaw of the first value whose `start` is no name of a start.
template <typename T>
std::optional<Flaw> unknownStart(const Drill& drill, const std::string& table, const std::vector<T>& values) {
  std::vector<std::string> names;
  names.reserve(drill.starts.size());
  for (const DrillStart& start : drill.starts) names.push_back(start.name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& name = values[i].start;
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) continue;
    return Flaw{table, static_cast<int>(i), "start",
                fmt::format("names no [[start]] of this file: '{}'.{}", name, suggestion(name, names))};
  }
  return std::nullopt;
}

std::optional<Flaw> startFlaw(const DrillStart& start, int index) {
  if (start.restart < 0 && start.ball.empty() && start.toward.empty())
    return Flaw{"start", index, "ball", "is missing"};
  if (start.speed_max < start.speed_min) return Flaw{"start", index, "speed_max", "is less than speed_min"};
  if (start.distance_max < start.distance_min)
    return Flaw{"start", index, "distance_max", "is less than distance_min"};
  if (start.target_max < start.target_min)
    return Flaw{"start", index, "target_max", "is less than target_min"};
  if (start.speed_max > 0.0 && start.toward.empty())
    return Flaw{"start", index, "toward", "is missing: the ball moves"};
  return std::nullopt;
}

/// The flaw of a bar that counts in least times where there are none.
std::optional<Flaw> leastTimeFlaw(const Drill& drill, const DrillBar& bar, int index) {
  if (!bar.of_least) return std::nullopt;
  if (bar.value != DrillMeasure::kTime || bar.statistic == DrillStatistic::kRate ||
      bar.statistic == DrillStatistic::kCount)
    return Flaw{"pass", index, "of_least", "asks for a mean, median or p95 of 'time'"};
  if (drill.starts.empty() || drill.robots.empty())
    return Flaw{"pass", index, "of_least",
                "finds no least time without starts and robots of the drill's own"};
  for (const DrillStart& start : drill.starts) {
    if ((bar.start.empty() || bar.start == start.name) && !hasLeastTime(drill, start))
      return Flaw{"pass", index, "of_least",
                  fmt::format("finds no least time in start '{}': no pose, turn or touch, and no goal "
                              "with a ball that rests",
                              start.name)};
  }
  return std::nullopt;
}

std::optional<Flaw> barFlaw(const DrillBar& bar, int index) {
  const bool low = std::isfinite(bar.at_least);
  const bool high = std::isfinite(bar.at_most);
  if (!low && !high) return Flaw{"pass", index, "", "needs at_least or at_most"};
  return std::nullopt;
}

std::optional<Flaw> findFlaw(const Drill& drill) {
  const bool trials = drill.match_opponent.empty() && drill.repeats.empty();
  if (trials && drill.starts.empty()) return Flaw{"start", -1, "", "is missing: where is the ball?"};
  if (drill.bars.empty()) return Flaw{"pass", -1, "", "is missing: what is to be reached?"};
  for (std::size_t i = 0; i < drill.starts.size(); ++i) {
    if (auto flaw = startFlaw(drill.starts[i], static_cast<int>(i))) return flaw;
  }
  for (std::size_t i = 0; i < drill.bars.size(); ++i) {
    if (auto flaw = barFlaw(drill.bars[i], static_cast<int>(i))) return flaw;
    if (auto flaw = leastTimeFlaw(drill, drill.bars[i], static_cast<int>(i))) return flaw;
  }
  for (std::size_t i = 0; i < drill.robots.size(); ++i) {
    if (drill.robots[i].at.empty()) return Flaw{"robot", static_cast<int>(i), "at", "has no place"};
  }
  if (auto flaw = unknownStart(drill, "robot", drill.robots)) return flaw;
  if (auto flaw = unknownStart(drill, "success", drill.successes)) return flaw;
  if (auto flaw = unknownStart(drill, "failure", drill.failures)) return flaw;
  return unknownStart(drill, "pass", drill.bars);
}

std::optional<Flaw> readRepeats(const std::string& text, std::vector<int>& numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (*at == ',' || *at == ' ') {
      ++at;
      continue;
    }
    int number = 0;
    const auto parsed = std::from_chars(at, end, number);
    if (parsed.ec != std::errc() || number < 1) {
      return Flaw{"drill", -1, "repeats", fmt::format("= '{}' is no list of drill numbers", text)};
    }
    numbers.push_back(number);
    at = parsed.ptr;
  }
  return std::nullopt;
}

}  // namespace

Result<Drill> parseDrill(std::string_view text, const std::string& origin) {
  static const std::vector<std::string> kTables{"drill",   "start", "robot", "success",
                                                "failure", "pass",  "sight", "sight_before"};
  const auto document = ConfigDocument::parse(text, origin, kTables);
  if (!document) return tl::unexpected<Error>(document.error());
  Drill drill;
  drill.file = origin;
  drill.name = document->fallbackName();
  std::string repeats;
  for (const Result<void>& read :
       {document->read("drill", schemaOf(drill, repeats), true), readAll(*document, "start", drill.starts),
        readAll(*document, "robot", drill.robots), readAll(*document, "success", drill.successes),
        readAll(*document, "failure", drill.failures), readAll(*document, "pass", drill.bars),
        document->read("sight", schemaOf(drill.sight), false),
        document->read("sight_before", schemaOf(drill.sight_before), false)}) {
    if (!read) return tl::unexpected<Error>(read.error());
  }
  if (const auto flaw = readRepeats(repeats, drill.repeats)) return document->locate(*flaw);
  if (const auto flaw = findFlaw(drill)) return document->locate(*flaw);
  return drill;
}

Result<std::vector<Drill>> loadDrills(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".toml") files.push_back(it->path().string());
  }
  if (error)
    return fail(ioCode(error.value()), fmt::format("cannot read the folder {}: {}", folder, error.message()));
  if (files.empty()) return fail(ErrorCode::kIo, fmt::format("{} has no *.toml files", folder));
  std::sort(files.begin(), files.end());
  std::vector<Drill> drills;
  for (const std::string& file : files) {
    const auto text = readFoundFile(file, kMaxTomlBytes);
    if (!text) return tl::unexpected<Error>(text.error());
    auto drill = parseDrill(*text, file);
    if (!drill) return tl::unexpected<Error>(drill.error());
    drills.push_back(std::move(*drill));
  }
  std::stable_sort(drills.begin(), drills.end(),
                   [](const Drill& a, const Drill& b) { return a.number < b.number; });
  return drills;
}

const std::vector<Drill>& builtInDrills() {
  static const std::vector<Drill> drills = [] {
    std::vector<Drill> parsed;
    for (const EmbeddedFile& file : embeddedDrills()) {
      auto drill = parseDrill(file.text, std::string(file.name) + ".toml");
      FULBITO_DEMAND(drill.has_value());
      parsed.push_back(std::move(*drill));
    }
    return parsed;
  }();
  return drills;
}

}  // namespace fulbito
