#include "replays/html/page_json.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/detail/build_info.hpp"
#include "replays/html/scene_columns.hpp"
#include "replays/recording/call_words.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPageFormat = 1;

/// Rounded to 0.1 mm, so that JSON stores few digits.
double shortOf(double value) { return std::floor(value * 1e4 + 0.5) / 1e4; }

Json pointOf(Vec2 point) { return Json::array({shortOf(point.x), shortOf(point.y)}); }

Json fieldJson(const FieldGeometry& field) {
  Json contour = Json::array();
  for (const Vec2 point : innerContour(field)) contour.push_back(pointOf(point));
  return {{"name", field.name},
          {"length", field.length},
          {"width", field.width},
          {"goalWidth", field.goal_width},
          {"goalDepth", field.hasGoals() ? field.goal_depth : 0.0},
          {"area", {field.goal_area_depth, field.goal_area_width}},
          {"arc", {field.goal_area_arc_depth, field.goal_area_arc_width}},
          {"bigArea", {field.big_area_depth, field.big_area_width}},
          {"circle", field.centre_circle_radius},
          {"penaltyMark", field.penalty_mark},
          {"freeBall", pointOf(field.free_ball_mark)},
          {"contour", contour}};
}

Json bodyJson(const PageBody& body) {
  static constexpr const char* kNames[] = {"wall", "robot", "ball", "obstacle"};
  Json json{{"kind", kNames[static_cast<std::size_t>(body.kind)]}};
  if (body.id) {
    json["team"] = indexOf(body.id->team);
    json["number"] = body.id->number;
  }
  if (body.box) {
    json["size"] = {body.length, body.width};
  } else {
    json["radius"] = body.radius;
    // A round robot has a heading, a ball has none: the page reads the column of headings if `turns` is set.
    if (hasHeading(body)) json["turns"] = true;
  }
  return json;
}

Json playJson(const PagePlay& play) {
  Json json{{"row", play.row},
            {"tick", play.tick},
            {"signal", play.signal},
            {"clock", play.clock},
            {"period", play.period},
            {"score", play.score},
            {"side", play.blue_side == Side::kLeft ? 0 : 1}};
  if (!play.kind.empty()) json["kind"] = play.kind;
  if (play.team) json["team"] = indexOf(*play.team);
  if (play.favours) json["favours"] = indexOf(*play.favours);
  // Only absent bodies are listed, because usually all are present.
  Json absent = Json::array();
  for (std::size_t i = 0; i < play.present.size(); ++i) {
    if (play.present[i] == 0) absent.push_back(i);
  }
  if (!absent.empty()) json["absent"] = absent;
  return json;
}

Json eventJson(const RecordedEvent& event, const std::vector<std::string>& teams) {
  Json json{{"tick", event.tick},     {"clock", event.play_time}, {"period", event.period},
            {"clause", event.clause}, {"law", event.law},         {"place", pointOf(event.place)}};
  if (event.team) json["team"] = indexOf(*event.team);
  if (event.robot) json["robot"] = *event.robot;
  const CallWords words = wordsOf(event, teams);
  if (!words.title.empty()) json["title"] = words.title;
  if (!words.detail.empty()) json["detail"] = words.detail;
  if (words.favours) json["favours"] = indexOf(*words.favours);
  if (const std::string measured = measuredText(event); !measured.empty()) json["measured"] = measured;
  return json;
}

Json runJson(const PageRun& run) {
  return {{"label", run.label},
          {"outcome", run.outcome},
          {"success", run.success},
          {"seconds", shortOf(run.seconds)},
          {"length", shortOf(run.length)},
          {"timeRatio", shortOf(run.time_ratio)},
          {"lengthRatio", shortOf(run.length_ratio)}};
}

Json resultJson(const RecordingResult& result) {
  return {{"score", result.score},
          {"complete", result.complete},
          {"outcome", result.outcome},
          {"hash", fmt::format("{:016x}", result.final_hash)}};
}

Json taskJson(const PageTask& task) {
  Json json{{"start", {shortOf(task.start.position.x), shortOf(task.start.position.y), task.start.heading}},
            {"goal", pointOf(task.goal)},
            {"tolerance", task.tolerance}};
  if (task.heading) json["heading"] = *task.heading;
  return json;
}

template <typename Items, typename Make>
Json listOf(const Items& items, const Make& make) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(make(item));
  return list;
}

/// The scores, each with the time from which it was valid.
Json scoresJson(const PageScene& scene) {
  Json scores = Json::array();
  PerTeam<int> score{};
  const auto note = [&](Tick tick) { scores.push_back({tick, score[0], score[1]}); };
  std::size_t next = 0;
  for (const PagePlay& play : scene.plays) {
    for (; next < scene.events.size() && scene.events[next].tick <= play.tick; ++next) {
      const RecordedEvent& event = scene.events[next];
      if (event.clause != "goal" || !event.team) continue;
      ++score[indexOf(*event.team)];
      note(event.tick);
    }
    if (scores.empty() || score != play.score) {
      score = play.score;
      note(play.tick);
    }
  }
  for (; next < scene.events.size(); ++next) {
    const RecordedEvent& event = scene.events[next];
    if (event.clause != "goal" || !event.team) continue;
    ++score[indexOf(*event.team)];
    note(event.tick);
  }
  if (scene.result && scene.result->complete && score != scene.result->score) {
    score = scene.result->score;
    note(scene.ticks);
  }
  return scores;
}

Json sceneJson(const PageScene& scene, std::size_t bytes) {
  Json texts = Json::array();
  for (const RecordedDrawing& drawing : scene.drawings) {
    if (drawing.kind == RecordedDrawing::Kind::kText) texts.push_back(drawing.text);
  }
  Json json{
      {"title", scene.title},
      {"teams", scene.teams},
      {"seed", fmt::format("{}", scene.seed)},
      {"rate", scene.rate},
      {"ticks", scene.ticks},
      {"rows", scene.rows.size()},
      {"bytes", bytes},
      {"field", fieldJson(scene.field)},
      {"bodies", listOf(scene.bodies, bodyJson)},
      {"plays", listOf(scene.plays, playJson)},
      {"events", listOf(scene.events, [&](const RecordedEvent& e) { return eventJson(e, scene.teams); })},
      {"scores", scoresJson(scene)},
      {"commands", {{"every", scene.commands.every}, {"values", scene.commands.values.size()}}},
      {"drawings", {{"ticks", scene.drawing_ticks}, {"count", scene.drawings.size()}, {"texts", texts}}},
      {"runs", listOf(scene.runs, runJson)},
      {"facts", scene.facts}};
  if (scene.result) json["result"] = resultJson(*scene.result);
  if (scene.task) json["task"] = taskJson(*scene.task);
  return json;
}

/// Makes each text one line, because texts from outside may contain characters that affect the layout.
void calm(Json& json) {
  if (json.is_string()) {
    json = oneLine(json.get_ref<const std::string&>());
  } else if (json.is_structured()) {
    for (Json& item : json) calm(item);
  }
}

/// Dumps JSON. Invalid UTF-8 is replaced, and the text cannot end the script element.
std::string dumped(Json json) {
  calm(json);
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<' || c == '>' || c == '&') {
      safe += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string pageJson(const Page& page, const PagePayload& payload) {
  static constexpr const char* kKinds[] = {"replay", "ghost", "races"};
  Json scenes = Json::array();
  for (std::size_t i = 0; i < page.scenes.size(); ++i) {
    scenes.push_back(sceneJson(page.scenes[i], payload.sizes[i]));
  }
  return dumped(Json{{"format", kPageFormat},
                     {"kind", kKinds[static_cast<std::size_t>(page.kind)]},
                     {"title", page.title},
                     {"build", buildInfo().version},
                     {"steps", {kPagePlaceStep, kPageHeadingStep, kPageCommandStep}},
                     {"payload", {{"packed", payload.packed}, {"raw", payload.raw}, {"crc", payload.crc}}},
                     {"scenes", scenes}});
}

}  // namespace fulbito
