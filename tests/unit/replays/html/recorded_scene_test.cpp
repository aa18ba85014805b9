#include "replays/html/recorded_scene.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

struct Golden {
  RecordingReader recording;
  ReplayTimeline timeline;
  PageScene scene;
};

Golden golden() {
  auto recording = RecordingReader::open(FULBITO_GOLDEN_RECORDINGS "/chaser-idle.fbr");
  REQUIRE(recording);
  auto timeline = ReplayTimeline::read(*recording);
  REQUIRE(timeline);
  auto scene = recordedScene(*recording, *timeline);
  REQUIRE(scene);
  return {std::move(*recording), std::move(*timeline), std::move(*scene)};
}

}  // namespace

TEST_CASE("a recording's scene has its rows at samples and at starts of plays", "[unit]") {
  const Golden g = golden();
  REQUIRE(g.scene.plays.size() == g.timeline.plays().size());
  CHECK(g.scene.rows.size() > 300);
  ReplayMoment moment;
  for (std::size_t p = 0; p < g.scene.plays.size(); ++p) {
    const std::size_t end = p + 1 < g.scene.plays.size() ? g.scene.plays[p + 1].row : g.scene.rows.size();
    REQUIRE(g.scene.rows[g.scene.plays[p].row].tick == g.timeline.plays()[p].tick);
    for (std::size_t r = g.scene.plays[p].row; r < end; ++r) {
      g.timeline.at(g.timeline.secondsAt(g.scene.rows[r].tick), moment);
      if (moment.play != p) continue;  // the end of a play is the start of the next one
      for (std::size_t body = 0; body < moment.bodies.size(); ++body) {
        REQUIRE(moment.bodies[body].has_value() == (g.scene.plays[p].present[body] != 0));
        if (!moment.bodies[body]) continue;
        CHECK(moment.bodies[body]->position.x ==
              Approx(g.scene.rows[r].poses[body].position.x).margin(1e-12));
        CHECK(moment.bodies[body]->position.y ==
              Approx(g.scene.rows[r].poses[body].position.y).margin(1e-12));
      }
    }
  }
}

TEST_CASE("a play's clock runs from its signal", "[unit]") {
  const Golden g = golden();
  ReplayMoment moment;
  for (Tick tick = 0; tick < g.timeline.ticks(); ++tick) {
    g.timeline.at(g.timeline.secondsAt(tick), moment);
    const PagePlay& play = g.scene.plays[moment.play];
    CHECK(moment.playing == (tick >= play.signal));
    const auto run = static_cast<double>(std::max<Tick>(0, tick - play.signal)) / g.scene.rate;
    CHECK(moment.play_seconds == Approx(play.clock + run).margin(1e-9));
  }
}

TEST_CASE("commands are those that drove the robots", "[unit]") {
  const Golden g = golden();
  CHECK(g.scene.commands.every == 6);
  REQUIRE(g.scene.commands.values.size() == 100 * 6);
  const auto chunk = g.recording.chunk(0);
  REQUIRE(chunk);
  for (std::size_t robot = 0; robot < 6; ++robot) {
    CHECK(g.scene.commands.values[6 * 20 + robot].left == chunk->commands[6 * 120 + robot].left);
  }
}

TEST_CASE("what is known of a recording is told", "[unit]") {
  const Golden g = golden();
  CHECK(g.scene.teams == std::vector<std::string>{"chaser", "idle"});
  CHECK(g.scene.field.name == "vsss-3v3");
  CHECK(g.scene.bodies.front().length == Approx(0.075));
  CHECK(g.scene.bodies.back().kind == BodyKind::kBall);
  const auto fact = [&](const std::string& name) {
    for (const auto& [known, text] : g.scene.facts) {
      if (known == name) return text;
    }
    return std::string();
  };
  CHECK(fact("Rules") == "vsss-3v3");
  CHECK(fact("Physics") == "standard");
  CHECK(fact("Robot") == "vsss");
  CHECK(fact("File").empty());
}

}  // namespace fulbito
