#include "replays/export/tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTableSchemaVersion = 1;

/// The names of the bodies in columns and keys: ball, blue0, robot0, obstacle2.
std::vector<std::string> bodyNames(const RecordingHeader& header) {
  std::vector<std::string> names;
  std::size_t robots = 0, balls = 0, obstacles = 0;
  for (const RecordedBody& body : header.bodies) {
    if (body.kind == BodyKind::kBall) {
      names.push_back(balls == 0 ? "ball" : fmt::format("ball{}", balls));
      ++balls;
    } else if (body.kind == BodyKind::kObstacle) {
      names.push_back(fmt::format("obstacle{}", obstacles++));
    } else {
      names.push_back(body.id ? fmt::format("{}{}", nameOf(body.id->team), body.id->number)
                              : fmt::format("robot{}", robots));
      ++robots;
    }
  }
  return names;
}

/// The ticks of a table's rows, in order: starts of plays and samples.
std::vector<Tick> ticksBetween(const ReplayTimeline& timeline, double from, double to) {
  std::vector<Tick> ticks;
  const auto add = [&](Tick tick) {
    const double seconds = timeline.secondsAt(tick);
    if (seconds >= from && seconds <= to) ticks.push_back(tick);
  };
  for (const RecordedPlay& play : timeline.plays()) add(play.tick);
  for (const RecordedSample& sample : timeline.samples()) add(sample.tick);
  std::sort(ticks.begin(), ticks.end());
  ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());
  return ticks;
}

/// Rounded to 4 decimals, without a negative zero.
double rounded(double value) { return std::floor(value * 1e4 + 0.5) / 1e4 + 0.0; }

Json stateJson(const ReplayMoment& moment, const std::vector<std::string>& names,
               const RecordingHeader& header) {
  Json json{{"type", "state"},
            {"tick", moment.tick},
            {"time_s", rounded(moment.seconds)},
            {"period", moment.period},
            {"play_s", rounded(moment.play_seconds)},
            {"playing", moment.playing},
            {"score", moment.score}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!moment.bodies[i]) continue;
    const Pose2& pose = *moment.bodies[i];
    Json place{rounded(pose.position.x), rounded(pose.position.y)};
    if (header.bodies[i].kind != BodyKind::kBall) place.push_back(rounded(pose.heading));
    json["bodies"][names[i]] = std::move(place);
  }
  return json;
}

Json playJson(const RecordedPlay& play, const ReplayTimeline& timeline) {
  return {{"type", "play"},
          {"tick", play.tick},
          {"time_s", rounded(timeline.secondsAt(play.tick))},
          {"restart", nameOf(play.kind)},
          {"team", nameOf(play.team)},
          {"period", play.period},
          {"score", play.score},
          {"blue_side", play.blue_side == Side::kLeft ? "left" : "right"}};
}

Json eventJson(const RecordedEvent& event, const ReplayTimeline& timeline) {
  Json json{{"type", "event"},
            {"tick", event.tick},
            {"time_s", rounded(timeline.secondsAt(event.tick))},
            {"period", event.period},
            {"play_s", rounded(event.play_time)},
            {"clause", event.clause}};
  if (!event.law.empty()) json["law"] = event.law;
  if (event.team) json["team"] = nameOf(*event.team);
  if (event.robot) json["robot"] = *event.robot;
  json["x"] = rounded(event.place.x);
  json["y"] = rounded(event.place.y);
  json["value"] = event.value;
  json["threshold"] = event.threshold;
  return json;
}

Json headJson(const ReplayTimeline& timeline, const std::vector<std::string>& names) {
  const RecordingHeader& header = timeline.header();
  Json json{{"type", "recording"},
            {"schema_version", kTableSchemaVersion},
            {"kind", header.kind == RecordingKind::kMatch ? "match" : "trial"},
            {"control_rate", header.control_rate},
            {"seconds", timeline.seconds()},
            {"seed", header.recipe.seed}};
  if (header.kind == RecordingKind::kMatch) {
    json["teams"] = header.recipe.teams;
  } else {
    json["navigator"] = header.recipe.navigator;
  }
  json["bodies"] = names;
  return json;
}

std::string lineOf(const Json& json) {
  return escapedJson(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace

void writeCsv(const ReplayTimeline& timeline, double from, double to, const TableSink& sink) {
  const auto& bodies = timeline.header().bodies;
  std::string line = "tick,time_s,play,period,play_s,playing,score_blue,score_yellow";
  const std::vector<std::string> names = bodyNames(timeline.header());
  for (std::size_t i = 0; i < names.size(); ++i) {
    line += fmt::format(",{0}_x,{0}_y", names[i]);
    if (bodies[i].kind != BodyKind::kBall) line += fmt::format(",{}_heading", names[i]);
  }
  sink(line + '\n');
  ReplayMoment moment;
  for (const Tick tick : ticksBetween(timeline, from, to)) {
    timeline.at(timeline.secondsAt(tick), moment);
    line =
        fmt::format("{},{:.4f},{},{},{:.4f},{},{},{}", tick, moment.seconds, moment.play + 1, moment.period,
                    moment.play_seconds, moment.playing ? 1 : 0, moment.score[0], moment.score[1]);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool ball = bodies[i].kind == BodyKind::kBall;
      if (!moment.bodies[i]) {
        line += ball ? ",," : ",,,";
        continue;
      }
      const Pose2& pose = *moment.bodies[i];
      line += fmt::format(",{:.4f},{:.4f}", rounded(pose.position.x), rounded(pose.position.y));
      if (!ball) line += fmt::format(",{:.3f}", rounded(pose.heading));
    }
    sink(line + '\n');
  }
}

void writeJsonLines(const ReplayTimeline& timeline, double from, double to, const TableSink& sink) {
  const std::vector<std::string> names = bodyNames(timeline.header());
  sink(lineOf(headJson(timeline, names)));
  const auto within = [&](Tick tick) {
    const double seconds = timeline.secondsAt(tick);
    return seconds >= from && seconds <= to;
  };
  auto play = timeline.plays().begin();
  auto event = timeline.events().begin();
  const auto tell_up_to = [&](Tick tick) {
    for (; event != timeline.events().end() && event->tick <= tick; ++event) {
      if (within(event->tick)) sink(lineOf(eventJson(*event, timeline)));
    }
    for (; play != timeline.plays().end() && play->tick <= tick; ++play) {
      if (within(play->tick)) sink(lineOf(playJson(*play, timeline)));
    }
  };
  ReplayMoment moment;
  for (const Tick tick : ticksBetween(timeline, from, to)) {
    tell_up_to(tick);
    timeline.at(timeline.secondsAt(tick), moment);
    sink(lineOf(stateJson(moment, names, timeline.header())));
  }
  tell_up_to(timeline.ticks());
}

}  // namespace fulbito
