#include "replays/html/page_json.hpp"

#include <nlohmann/json.hpp>

#include "replays/html/scene_columns.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/html/sample_scene.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::json;

Json jsonOf(const PageScene& scene) {
  return Json::parse(pageJson({PageKind::kReplay, "title", {scene}}, {{7}, 7, 5, 3}));
}

RecordedEvent goalAt(Tick tick, TeamId team) {
  RecordedEvent event;
  event.tick = tick;
  event.clause = "goal";
  event.team = team;
  return event;
}

}  // namespace

TEST_CASE("whatever a text holds, it cannot leave its element", "[unit]") {
  PageScene scene = test::sampleScene();
  const std::string text = "</script><!--&\u2028\u00e9\xff";
  scene.title = text;
  scene.teams = {text, text};
  scene.facts = {{text, text}};
  scene.events = {goalAt(3, TeamId::kBlue)};
  scene.events[0].law = text;
  const std::string json = pageJson({PageKind::kReplay, text, {scene}}, {{7}, 7, 5, 3});
  CHECK(json.find_first_of("<>&") == std::string::npos);
  CHECK(std::all_of(json.begin(), json.end(), [](char c) { return c >= 0x20 && c < 0x7f; }));
  CHECK(Json::parse(json)["scenes"][0]["teams"][0] == "</script><!--& \u00e9 ");
}

TEST_CASE("the description says what the columns are", "[unit]") {
  const Json json = jsonOf(test::sampleScene());
  CHECK(json["format"] == 1);
  CHECK(json["payload"] == Json({{"packed", 5}, {"raw", 7}, {"crc", 3}}));
  const Json& scene = json["scenes"][0];
  CHECK(scene["rows"] == 22);
  CHECK(scene["bytes"] == 7);
  CHECK(scene["seed"] == "18364758544493064720");
  CHECK(scene["plays"][1]["row"] == 11);
  CHECK(scene["plays"][1]["absent"] == Json({1}));
  CHECK_FALSE(scene["plays"][0].contains("absent"));
  CHECK(scene["commands"] == Json({{"every", 10}, {"values", 8}}));
  CHECK(scene["bodies"][2] == Json({{"kind", "ball"}, {"radius", 0.0215}}));
}

TEST_CASE("a body without a size says whether it turns, as the columns have it", "[unit]") {
  PageScene scene = test::sampleScene();
  scene.bodies[0].box = false;
  scene.bodies[0].radius = 0.04;
  scene.bodies[3].box = false;
  scene.bodies[3].radius = 0.1;
  const Json bodies = jsonOf(scene)["scenes"][0]["bodies"];
  CHECK(bodies[0]["radius"] == 0.04);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    CHECK((bodies[i].contains("size") || bodies[i].value("turns", false)) == hasHeading(scene.bodies[i]));
}

TEST_CASE("the score changes with goals, at restarts and at the table", "[unit]") {
  PageScene scene = test::sampleScene();
  scene.events = {goalAt(19, TeamId::kYellow), goalAt(35, TeamId::kBlue)};
  scene.plays[1].score = {0, 1};
  scene.result = RecordingResult{40, true, {1, 1}, 0, "draw", {}};
  CHECK(jsonOf(scene)["scenes"][0]["scores"] == Json({{0, 0, 0}, {19, 0, 1}, {35, 1, 1}}));
  scene.result->score = {0, 3};  // a walk-over changes the score at the end
  CHECK(jsonOf(scene)["scenes"][0]["scores"].back() == Json({40, 0, 3}));
  scene.plays[1].score = {2, 1};
  CHECK(jsonOf(scene)["scenes"][0]["scores"][2] == Json({20, 2, 1}));
}

TEST_CASE("a call's words and colour are in the data, not in the page", "[unit]") {
  PageScene scene = test::sampleScene();
  RecordedEvent charged;
  charged.tick = 3;
  charged.clause = "goal-kick.keeper-charged";
  charged.team = TeamId::kBlue;
  charged.value = 0.12;
  charged.threshold = 0.02;
  scene.events = {charged, goalAt(19, TeamId::kYellow)};
  const Json events = jsonOf(scene)["scenes"][0]["events"];
  CHECK(events[0]["title"] == "Goal kick");
  CHECK(events[0]["detail"] == "keeper charged");
  CHECK(events[0]["favours"] == 1);  // the team that takes the kick; `team` is at fault
  CHECK(events[0]["team"] == 0);
  CHECK(events[0]["measured"] == "pressed with 0.12 N s (limit 0.02 N s)");
  CHECK(events[1]["favours"] == 1);
  CHECK_FALSE(events[1].contains("measured"));
}

}  // namespace fulbito
