#include "match/record/recorded_events.hpp"

#include <algorithm>
#include <charconv>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/models.hpp"
#include "match/report/match_json.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito {
namespace {

ReplayEvent restartOf(const RecordedPlay& play, double dt) {
  ReplayEvent event;
  event.call.tick = play.tick;
  event.call.period = static_cast<std::uint8_t>(play.period);
  event.call.play_time = static_cast<double>(play.play_ticks) * dt;
  event.call.team = play.team;
  event.call.place = play.ball;
  event.restart = play.kind;
  event.score = play.score;
  return event;
}

/// The parts of a recording other than states.
struct Course {
  std::vector<RecordedPlay> plays;
  std::vector<RecordedEvent> calls;
};

Result<Course> courseOf(const RecordingReader& recording) {
  Course course;
  for (std::size_t i = 0; i < recording.chunkCount(); ++i) {
    auto chunk = recording.chunk(i);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    std::move(chunk->plays.begin(), chunk->plays.end(), std::back_inserter(course.plays));
    std::move(chunk->events.begin(), chunk->events.end(), std::back_inserter(course.calls));
  }
  return course;
}

std::vector<ReplayEvent> merged(Course course, const RecordingReader& recording) {
  const double dt = 1.0 / recording.header().control_rate;
  std::vector<ReplayEvent> events;
  PerTeam<int> score{};
  auto call = course.calls.begin();
  for (const RecordedPlay& play : course.plays) {
    // The next play begins with a score that includes the call that stopped the last play.
    for (; call != course.calls.end() && call->tick <= play.tick; ++call) {
      events.push_back({std::move(*call), {}, call->tick == play.tick ? play.score : score});
    }
    events.push_back(restartOf(play, dt));
    score = play.score;
  }
  const auto& result = recording.result();
  for (; call != course.calls.end(); ++call) {
    const bool last = result && call->tick == recording.ticks();
    events.push_back({std::move(*call), {}, last ? result->score : score});
  }
  return events;
}

/// The recipe as a match configuration. The teams need not exist on this machine.
Result<MatchConfig> configOf(const RecordingRecipe& recipe) {
  MatchConfig config;
  auto rules = parseRules(recipe.rules, "recorded rules");
  auto field = parseField(recipe.field, "recorded field");
  auto physics = parsePhysics(recipe.physics, "recorded physics");
  auto robot = parseRobot(recipe.robot, "recorded robot");
  if (!rules) return tl::unexpected<Error>(rules.error());
  if (!field) return tl::unexpected<Error>(field.error());
  if (!physics) return tl::unexpected<Error>(physics.error());
  if (!robot) return tl::unexpected<Error>(robot.error());
  config.rules = std::move(*rules);
  config.field = std::move(*field);
  config.physics = std::move(*physics);
  config.robot = std::move(*robot);
  std::copy_n(recipe.vision.begin(), std::min(recipe.vision.size(), config.vision.size()),
              config.vision.begin());
  return config;
}

bool givenStart(const RecordingRecipe& recipe) { return moreOf(recipe, "start") == "given"; }

Result<Json> headOf(const RecordingHeader& header) {
  const RecordingRecipe& recipe = header.recipe;
  const bool trial = header.kind == RecordingKind::kTrial;
  Json head = {{"schema_version", kMatchSchemaVersion}, {"event", trial ? "trial" : "match"}};
  const double dt = 1.0 / header.control_rate;
  if (trial) {
    head["navigator"] = recipe.navigator;
    head["index"] = recipe.index;
    head["seed"] = recipe.seed;
    head["dt_s"] = dt;
  } else {
    auto config = configOf(recipe);
    if (!config) return fail(ErrorCode::kBadInput, config.error().message);
    Json settings = matchConfigJson(*config);
    settings["given_start"] = givenStart(recipe);
    head["teams"] = {{"blue", recipe.teams.empty() ? "" : recipe.teams[0]},
                     {"yellow", recipe.teams.size() < 2 ? "" : recipe.teams[1]}};
    head["seed"] = recipe.seed;
    head["dt_s"] = dt;
    head["config"] = settings;
  }
  head["build"] = buildJson(header.build);
  return head;
}

Json lineOf(const ReplayEvent& event, double dt) {
  const RecordedEvent& from = event.call;
  LoggedEvent to;
  to.call.tick = from.tick;
  to.call.play_time = from.play_time;
  to.call.period = from.period;
  to.call.clause = from.clause;
  to.call.law = from.law;
  to.call.team = from.team;
  to.call.robot = from.robot;
  to.call.place = from.place;
  to.call.value = from.value;
  to.call.threshold = from.threshold;
  to.call.margin = from.margin;
  to.restart = event.restart;
  to.score = event.score;
  return eventJson(to, dt);
}

Json endOf(const RecordingReader& recording, const std::vector<ReplayEvent>& events, double dt) {
  const auto& result = recording.result();
  const PerTeam<int> known = events.empty() ? PerTeam<int>{} : events.back().score;
  const PerTeam<int> score = result ? result->score : known;
  Json end = {{"tick", recording.ticks()},
              {"time_s", static_cast<double>(recording.ticks()) * dt},
              {"period", events.empty() ? 1 : int{events.back().call.period}},
              {"event", "end"},
              {"complete", result && result->complete},
              {"score", {score[0], score[1]}}};
  if (result && recording.header().kind == RecordingKind::kTrial) end["outcome"] = result->outcome;
  return end;
}

}  // namespace

Result<std::vector<ReplayEvent>> eventsOf(const RecordingReader& recording) {
  auto course = courseOf(recording);
  if (!course) return tl::unexpected<Error>(course.error());
  std::vector<ReplayEvent> events = merged(std::move(*course), recording);
  // The play of a trial begins with no restart.
  if (recording.header().kind == RecordingKind::kTrial) {
    std::erase_if(events, [](const ReplayEvent& event) { return event.restart.has_value(); });
  }
  return events;
}

Result<void> writeEventLines(const RecordingReader& recording, const EventLines::Sink& sink) {
  const auto events = eventsOf(recording);
  if (!events) return tl::unexpected<Error>(events.error());
  const auto head = headOf(recording.header());
  if (!head) return tl::unexpected<Error>(head.error());
  const double dt = 1.0 / recording.header().control_rate;
  const auto write = [&sink](const Json& line) {
    sink(escapedJson(line.dump(-1, ' ', false, Json::error_handler_t::replace)) + '\n');
  };
  write(*head);
  for (const ReplayEvent& event : *events) write(lineOf(event, dt));
  write(endOf(recording, *events, dt));
  return {};
}

}  // namespace fulbito
