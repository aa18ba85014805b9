#include "apps/view/viewer.hpp"

#include "apps/view/match_stage.hpp"
#include "tests/unit/apps/view/test_stages.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr std::int64_t kSecond = 1'000'000'000;

std::string shortRecording(std::uint64_t seed = 1) {
  MatchConfig config = shortMatch("chaser", "chaser", 20.0);
  config.seed = seed;
  return recorded(config);
}

Viewer viewerOf(const std::vector<std::string>& recordings, const ViewSettings& settings = {}) {
  std::vector<std::unique_ptr<ViewStage>> stages;
  for (const std::string& bytes : recordings) {
    stages.push_back(replayStage(bytes, "file" + std::to_string(stages.size()) + ".fbr"));
  }
  return {std::move(stages), settings};
}

/// Advances the wall time in steps of 1/60 s.
void run(Viewer& viewer, double seconds, std::int64_t& now) {
  const auto steps = static_cast<int>(seconds * 60.0 + 0.5);
  for (int i = 0; i < steps; ++i) viewer.advance(now += kSecond / 60);
}

/// A live match in a viewer.
struct Live {
  Match match;
  Viewer viewer;
  explicit Live(const MatchConfig& config)
      : match(std::move(*Match::create(config))), viewer(stages(match), {}) {
    viewer.advance(0);
  }
  static std::vector<std::unique_ptr<ViewStage>> stages(Match& match) {
    std::vector<std::unique_ptr<ViewStage>> all;
    all.push_back(std::make_unique<MatchStage>(match));
    return all;
  }
};

void press(Viewer& viewer, ViewKey key, bool shift = false) { viewer.press({key, shift}); }

PointerEvent pointer(PointerEvent::Kind kind, Vec2 place, bool right = false) {
  PointerEvent event;
  event.kind = kind;
  event.place = place;
  event.right = right;
  return event;
}

}  // namespace

TEST_CASE("a recording plays in real time, and at the speed that is set", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  std::int64_t now = 5 * kSecond;
  viewer.advance(now);
  CHECK(viewer.stage().seconds() == 0.0);
  run(viewer, 2.0, now);
  CHECK(viewer.stage().seconds() == Approx(2.0).margin(1e-3));
  press(viewer, ViewKey::kPlus);
  press(viewer, ViewKey::kPlus);
  CHECK(viewer.settings().speed == 4.0);
  run(viewer, 1.0, now);
  CHECK(viewer.stage().seconds() == Approx(6.0).margin(1e-3));
  for (int i = 0; i < 9; ++i) press(viewer, ViewKey::kMinus);
  CHECK(viewer.settings().speed == 0.25);
  run(viewer, 2.0, now);
  CHECK(viewer.stage().seconds() == Approx(6.5).margin(1e-3));
  for (int i = 0; i < 9; ++i) press(viewer, ViewKey::kPlus);
  CHECK(viewer.settings().speed == 16.0);
}

TEST_CASE("a machine that slept does not skip the match", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  viewer.advance(0);
  viewer.advance(3600 * kSecond);
  CHECK(viewer.stage().seconds() == Approx(0.1));
  viewer.advance(3599 * kSecond);  // a clock that runs backwards has no effect
  CHECK(viewer.stage().seconds() == Approx(0.1));
}

TEST_CASE("the hint tells the speed, at 1x too, and the key of the help", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  CHECK(viewer.hint() == "1x speed,  H: keys");
  press(viewer, ViewKey::kMinus);
  CHECK(viewer.hint() == "1/2x speed,  H: keys");
  press(viewer, ViewKey::kPlus);
  CHECK(viewer.hint() == "1x speed,  H: keys");
}

TEST_CASE("a paused picture is drawn once", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  std::int64_t now = 0;
  ReplayMoment moment;
  MatchOverlays overlays;
  CHECK(viewer.stale());
  press(viewer, ViewKey::kSpace);
  viewer.advance(now);
  viewer.show(moment, overlays);
  CHECK(viewer.note() == "paused");
  run(viewer, 1.0, now);
  CHECK_FALSE(viewer.stale());
  CHECK_FALSE(viewer.moving());
  viewer.point(pointer(PointerEvent::Kind::kMove, {0.1, 0.1}));
  CHECK_FALSE(viewer.stale());
  press(viewer, ViewKey::kK);
  CHECK(viewer.stale());
  CHECK(viewer.moving());
}

TEST_CASE("keys seek", "[unit]") {
  ViewSettings settings;
  settings.paused = true;
  Viewer viewer = viewerOf({shortRecording()}, settings);
  const auto at = [&viewer] { return viewer.stage().seconds(); };
  press(viewer, ViewKey::kRight, true);
  CHECK(at() == Approx(10.0));
  press(viewer, ViewKey::kLeft);
  CHECK(at() == Approx(9.0));
  press(viewer, ViewKey::kPeriod);
  CHECK(at() == Approx(9.0 + 1.0 / 60.0));
  press(viewer, ViewKey::kComma);
  press(viewer, ViewKey::kComma);
  CHECK(at() == Approx(9.0 - 1.0 / 60.0));
  press(viewer, ViewKey::kLeft, true);
  CHECK(at() == 0.0);
  press(viewer, ViewKey::kRight);
  CHECK(at() == Approx(1.0));
  press(viewer, ViewKey::kEnd);
  CHECK(at() == viewer.stage().look().seconds);
  press(viewer, ViewKey::kHome);
  CHECK(at() == 0.0);
  press(viewer, ViewKey::kN);
  press(viewer, ViewKey::kN);
  const double second = at();
  CHECK(second == viewer.stage().eventAfter(*viewer.stage().eventAfter(0.0)));
  press(viewer, ViewKey::kP);
  CHECK(at() < second);
  press(viewer, ViewKey::kEnd);
  press(viewer, ViewKey::kN);
  CHECK(viewer.note().find("no more events") != std::string::npos);
}

TEST_CASE("previous event goes on back while play runs", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  std::int64_t now = 0;
  viewer.advance(now);
  press(viewer, ViewKey::kN);
  press(viewer, ViewKey::kN);
  const double event = viewer.stage().seconds();
  run(viewer, 0.2, now);
  press(viewer, ViewKey::kP);
  CHECK(viewer.stage().seconds() < event);
}

TEST_CASE("a step pauses, and play begins anew at the end", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  press(viewer, ViewKey::kPeriod);
  CHECK(viewer.settings().paused);
  press(viewer, ViewKey::kEnd);
  CHECK(viewer.note() == "end");
  press(viewer, ViewKey::kSpace);
  CHECK(viewer.stage().seconds() == 0.0);
  CHECK_FALSE(viewer.settings().paused);
}

TEST_CASE("keys change the look", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  const ViewSettings& s = viewer.settings();
  for (const ViewKey key : {ViewKey::kT, ViewKey::kO, ViewKey::kF, ViewKey::kD, ViewKey::kF11, ViewKey::kH}) {
    press(viewer, key);
  }
  CHECK_FALSE(s.trails);
  CHECK(s.drawings);
  CHECK(s.flipped);
  CHECK(s.theme == PictureTheme::kLight);
  CHECK(s.full_screen);
  CHECK(s.help);
  press(viewer, ViewKey::kEscape);  // first closes the help
  CHECK_FALSE(s.help);
  CHECK_FALSE(viewer.quits());
  press(viewer, ViewKey::kEscape);
  CHECK(viewer.quits());
  CHECK_FALSE(viewer.takeSave());
  press(viewer, ViewKey::kS);
  CHECK(viewer.takeSave());
  CHECK_FALSE(viewer.takeSave());
}

TEST_CASE("flipped, all is seen from the other side", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  viewer.stage().seek(3.0);
  ReplayMoment as_is, flipped;
  MatchOverlays first, second;
  viewer.show(as_is, first);
  press(viewer, ViewKey::kF);
  viewer.show(flipped, second);
  CHECK(flipped.blue_side == opposite(as_is.blue_side));
  for (std::size_t i = 0; i < as_is.bodies.size(); ++i) {
    CHECK(flipped.bodies[i]->position == -as_is.bodies[i]->position);
    CHECK(second.trails[i].points.front() == -first.trails[i].points.front());
  }
}

TEST_CASE("one file follows the other, and keys go between them", "[unit]") {
  Viewer viewer = viewerOf({shortRecording(1), shortRecording(2)});
  std::int64_t now = 0;
  viewer.advance(now);
  viewer.stage().seek(1e9);
  viewer.stage().seek(viewer.stage().seconds() - 0.1);
  run(viewer, 0.2, now);
  CHECK(viewer.current() == 1);
  CHECK(viewer.stage().seconds() == Approx(0.0).margin(0.15));
  CHECK(viewer.note().find("file 2 of 2") != std::string::npos);
  press(viewer, ViewKey::kPageDown);
  CHECK(viewer.current() == 1);
  press(viewer, ViewKey::kPageUp);
  CHECK(viewer.current() == 0);
  CHECK(viewer.stage().seconds() == 0.0);  // the recording was at its end, so it starts again
  press(viewer, ViewKey::kPageUp);
  CHECK(viewer.current() == 0);
  CHECK(viewer.title().find("file0.fbr") != std::string::npos);
}

TEST_CASE("the bar of time seeks, also while dragged off it", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  std::int64_t now = 0;
  viewer.advance(now);
  PointerEvent event = pointer(PointerEvent::Kind::kDown, {9.0, 9.0});
  event.on_bar = true;
  event.bar_seconds = 12.0;
  viewer.point(event);
  CHECK(viewer.stage().seconds() == 12.0);
  run(viewer, 0.5, now);
  CHECK(viewer.stage().seconds() == 12.0);  // time stands still while the bar is held
  event.kind = PointerEvent::Kind::kMove;
  event.on_bar = false;
  event.bar_seconds = 7.0;
  viewer.point(event);
  CHECK(viewer.stage().seconds() == 7.0);
  event.kind = PointerEvent::Kind::kUp;
  viewer.point(event);
  run(viewer, 0.5, now);
  CHECK(viewer.stage().seconds() == Approx(7.5).margin(1e-3));
  // A drag over the field of a recording has no effect.
  viewer.point(pointer(PointerEvent::Kind::kDown, {0.0, 0.0}));
  viewer.point(pointer(PointerEvent::Kind::kMove, {0.3, 0.0}));
  viewer.point(pointer(PointerEvent::Kind::kUp, {0.3, 0.0}));
  CHECK_FALSE(viewer.stage().edited());
}

TEST_CASE("a notice goes away", "[unit]") {
  Viewer viewer = viewerOf({shortRecording()});
  std::int64_t now = 0;
  viewer.advance(now);
  press(viewer, ViewKey::kSpace);
  viewer.notify("saved a.png");
  CHECK(viewer.note() == "saved a.png - paused");
  CHECK(viewer.moving());
  run(viewer, 4.0, now);
  CHECK(viewer.note() == "paused");
  CHECK_FALSE(viewer.moving());
}

TEST_CASE("a live match is held while something is dragged, and edited when it is let go", "[unit]") {
  Live live(shortMatch("idle", "idle", 20.0));
  std::int64_t now = 0;
  run(live.viewer, 1.0, now);
  const Tick tick = live.match.tick();
  CHECK(tick > 50);
  live.viewer.point(pointer(PointerEvent::Kind::kDown, live.match.placement().ball));
  live.viewer.point(pointer(PointerEvent::Kind::kMove, {0.3, 0.4}));
  run(live.viewer, 1.0, now);
  CHECK(live.match.tick() == tick);
  live.viewer.point(pointer(PointerEvent::Kind::kMove, {0.3, 7.0}));
  CHECK(live.viewer.note().find("the ball would not be on the field") != std::string::npos);
  live.viewer.point(pointer(PointerEvent::Kind::kUp, {0.3, 7.0}));
  CHECK(distance(live.match.placement().ball, {0.3, 0.4}) < 1e-6);
  CHECK(live.viewer.title().find("edited") != std::string::npos);
  run(live.viewer, 1.0, now);
  CHECK(live.match.tick() > tick);
  CHECK(live.match.edits() == 1);
}

TEST_CASE("flipped, what is dragged is what is seen", "[unit]") {
  Live live(shortMatch("idle", "idle", 20.0));
  press(live.viewer, ViewKey::kF);
  live.viewer.point(pointer(PointerEvent::Kind::kDown, -live.match.placement().ball));
  live.viewer.point(pointer(PointerEvent::Kind::kMove, {0.3, 0.4}));
  live.viewer.point(pointer(PointerEvent::Kind::kUp, {0.3, 0.4}));
  CHECK(distance(live.match.placement().ball, {-0.3, -0.4}) < 1e-6);
}

TEST_CASE("wheel and right button turn a robot of a live match", "[unit]") {
  Live live(shortMatch("idle", "idle", 20.0));
  const Pose2 before = *live.match.placement().robots[0][2];
  PointerEvent wheel = pointer(PointerEvent::Kind::kWheel, before.position);
  wheel.wheel = 2.0;
  live.viewer.point(wheel);
  CHECK(live.match.placement().robots[0][2]->heading == Approx(before.heading + 0.5235987756));
  live.viewer.point(pointer(PointerEvent::Kind::kDown, before.position, true));
  live.viewer.point(pointer(PointerEvent::Kind::kMove, before.position + Vec2{-0.1, 0.0}, true));
  live.viewer.point(pointer(PointerEvent::Kind::kUp, before.position, true));
  CHECK(std::abs(live.match.placement().robots[0][2]->heading) == Approx(3.14159265));
}

TEST_CASE("a live match steps and goes on, but never back", "[unit]") {
  Live live(shortMatch("chaser", "chaser", 20.0));
  press(live.viewer, ViewKey::kPeriod);
  CHECK(live.match.tick() == 1);
  press(live.viewer, ViewKey::kRight);
  const Tick tick = live.match.tick();
  CHECK(tick >= 60);
  for (const ViewKey key : {ViewKey::kLeft, ViewKey::kComma, ViewKey::kHome, ViewKey::kEnd, ViewKey::kP}) {
    press(live.viewer, key);
  }
  CHECK(live.match.tick() == tick);
  CHECK(live.viewer.note().find("cannot go back") != std::string::npos);
}

}  // namespace fulbito
