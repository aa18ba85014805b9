// What the browser tests compare with and what no match gives:
//   browser_pages positions FILE...   where everything is at 50 times of a recording, one JSON object a line
//   browser_pages hostile             a page of names and texts that want to break out, on stdout
//   browser_pages drawings            a page of a trial with drawings, and a team whose robot is away
//   browser_pages round               a page of a trial whose robots are round, on stdout
//   browser_pages calls               a page in which every clause is called, once against each team
//   browser_pages banners             what pictures show of the same calls, one JSON object a line

#include <cstdio>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/picture.hpp"
#include "fulbito/recording.hpp"
#include "replays/html/html_page.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr int kTimes = 50;

std::string bodiesOf(const ReplayMoment& moment) {
  std::string text;
  for (const auto& body : moment.bodies) {
    if (!text.empty()) text += ",";
    text += body ? fmt::format("[{},{},{}]", body->position.x, body->position.y, body->heading) : "null";
  }
  return text;
}

int positions(const char* file) {
  const auto recording = RecordingReader::open(file);
  const auto timeline =
      recording ? ReplayTimeline::read(*recording) : tl::unexpected<Error>(recording.error());
  if (!timeline) {
    fmt::print(stderr, "{}\n", timeline.error().message);
    return 1;
  }
  Rng rng(4, test::kTestStream, 0);
  for (int i = 0; i < kTimes; ++i) {
    const double seconds = rng.uniform(0.0, timeline->seconds());
    const ReplayMoment moment = timeline->at(seconds);
    fmt::print(
        R"({{"file":"{}","seconds":{},"tick":{},"clock":{},"playing":{},"period":{},"score":[{},{}],"bodies":[{}]}})"
        "\n",
        file, seconds, moment.tick, moment.play_seconds, moment.playing, moment.period, moment.score[0],
        moment.score[1], bodiesOf(moment));
  }
  return 0;
}

/// Four robots and a ball that drive in circles for ten seconds.
PageScene circles() {
  PageScene scene;
  scene.title = "circles";
  scene.ticks = 600;
  for (const TeamId team : kTeams) {
    for (std::uint8_t number = 0; number < 2; ++number) {
      scene.bodies.push_back({BodyKind::kRobot, RobotId{team, number}, true, 0.075, 0.075, 0.0});
    }
  }
  scene.bodies.push_back({BodyKind::kBall, {}, false, 0.0, 0.0, 0.0215});
  for (Tick tick = 0; tick <= scene.ticks; tick += 2) {
    PageRow row{tick, {}};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const auto offset = static_cast<double>(i);
      const double angle = 0.01 * static_cast<double>(tick) + offset;
      row.poses.push_back({math::unit(angle) * (0.1 + 0.1 * offset), angle});
    }
    scene.rows.push_back(row);
  }
  PagePlay play;
  play.kind = "kick-off";
  play.present = {1, 1, 1, 0, 1};
  scene.plays.push_back(play);
  return scene;
}

int print(const Page& page) {
  const auto html = htmlPage(page);
  if (!html) return 1;
  std::fwrite(html->data(), 1, html->size(), stdout);
  return 0;
}

int hostile() {
  const std::string escape = "</script><script>window.broken=1</script><img src=x onerror=window.broken=1>";
  PageScene scene = circles();
  scene.title = escape;
  scene.teams = {escape + std::string(200, 'W'),
                 "\u202e\u0627\u0644\u0641\u0631\u064a\u0642 \u05e7\u05d1\u05d5\u05e6\u05d4 " +
                     std::string(200, 'x') + "\xff\xfe"};
  scene.facts = {{escape, escape}, {"<!--", "]]>"}};
  RecordedEvent event;
  event.tick = 60;
  event.clause = "<b onclick=alert(1)>" + escape;
  event.law = "{{data}}" + std::string(300, 'L');
  scene.events = {event, event};
  scene.events[1].tick = 120;
  scene.events[1].clause = "goal";
  scene.events[1].team = TeamId::kYellow;
  for (Tick tick = 2; tick < 600; tick += 2) {
    RecordedDrawing drawing{tick, TeamId::kBlue, RecordedDrawing::Kind::kText, {0.05, 0.05}, {}, 0.0, escape};
    scene.drawings.push_back(drawing);
  }
  return print({PageKind::kReplay, escape, {scene}});
}

int drawings() {
  PageScene scene = circles();
  scene.teams = {"one", "two"};
  for (Tick tick = 2; tick <= 600; tick += 2) {
    const double x = 0.001 * static_cast<double>(tick);
    using Kind = RecordedDrawing::Kind;
    scene.drawings.push_back({tick, TeamId::kBlue, Kind::kLine, {0, 0}, {x, 0.3}, 0.0, ""});
    scene.drawings.push_back({tick, TeamId::kYellow, Kind::kCircle, {-x, 0}, {}, 0.1, ""});
    scene.drawings.push_back({tick,
                              TeamId::kBlue,
                              Kind::kText,
                              scene.rows[tick / 2].poses[0].position,
                              {},
                              0.0,
                              fmt::format("at {}", tick)});
  }
  return print({PageKind::kReplay, "drawings", {scene}});
}

int round() {
  PageScene scene = circles();
  for (PageBody& body : scene.bodies) {
    if (body.kind != BodyKind::kRobot) continue;
    body.box = false;
    body.radius = 0.04;
  }
  return print({PageKind::kReplay, "round robots", {scene}});
}

constexpr Tick kBetweenCalls = 180;  // longer than any banner stays

/// Every clause that has words, once against or for each team, a call every three seconds.
std::vector<RecordedEvent> everyCall() {
  std::vector<RecordedEvent> events;
  for (const char* clause :
       {"goal", "free-ball", "goal-kick.attackers", "goal-kick.keeper-charged", "goal-kick.stuck",
        "penalty.defenders", "penalty.keeper-holds", "penalty.holding", "penalty.stuck", "free-kick.push",
        "free-kick.holding", "half", "full-time", "overtime", "shoot-out", "false-start", "mercy",
        "walk-over"}) {
    for (const TeamId team : kTeams) {
      RecordedEvent event;
      event.tick = kBetweenCalls * static_cast<Tick>(events.size() + 1);
      event.clause = clause;
      event.law = "8";
      event.team = team;
      event.robot = 1;
      event.value = 0.12;
      event.threshold = 0.02;
      events.push_back(event);
    }
  }
  return events;
}

int calls() {
  PageScene scene = circles();
  scene.teams = {"one", "two"};
  scene.events = everyCall();
  scene.ticks = kBetweenCalls * static_cast<Tick>(scene.events.size() + 1);
  scene.plays.front().present.assign(scene.bodies.size(), 1);
  scene.rows.push_back({scene.ticks, scene.rows.back().poses});
  return print({PageKind::kReplay, "calls", {scene}});
}

int banners() {
  RecordingRecipe recipe;
  recipe.teams = {"one", "two"};
  for (const RecordedEvent& event : everyCall()) {
    const MatchBanner banner = bannerOf(event, recipe);
    fmt::print(R"({{"seconds":{},"title":"{}","detail":"{}","team":{}}})"
               "\n",
               static_cast<double>(event.tick) / 60.0, banner.title, banner.detail,
               banner.team ? fmt::format("{}", indexOf(*banner.team)) : "null");
  }
  return 0;
}

}  // namespace
}  // namespace fulbito

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "positions" && argc == 3) return fulbito::positions(argv[2]);
  if (what == "hostile") return fulbito::hostile();
  if (what == "drawings") return fulbito::drawings();
  if (what == "round") return fulbito::round();
  if (what == "calls") return fulbito::calls();
  if (what == "banners") return fulbito::banners();
  std::fputs("Usage: browser_pages positions FILE | hostile | drawings | calls | banners\n", stderr);
  return 2;
}
