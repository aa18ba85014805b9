#include <cmath>

#include "fulbito/picture.hpp"
#include "replays/render/colours/match_style.hpp"
#include "tests/support/sample_replay.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

using namespace test;

/// One robot of each team and a ball, far from each other.
MatchPictureSpec duel(int width = 900) {
  MatchPictureSpec spec;
  spec.width = width;
  spec.bodies = {{BodyKind::kRobot, RobotId{TeamId::kBlue, 1}},
                 {BodyKind::kRobot, RobotId{TeamId::kYellow, 2}},
                 {BodyKind::kBall, {}}};
  spec.names = {"libero", "classic"};
  return spec;
}

ReplayMoment apart() {
  ReplayMoment moment;
  moment.playing = true;
  moment.score = {14, 2};
  moment.bodies = {Pose2{{-0.4, 0.2}, 0.3}, Pose2{{0.4, -0.2}, 2.0}, Pose2{{0.0, 0.4}, 0.0}};
  return moment;
}

Canvas drawn(const MatchPictureSpec& spec, const ReplayMoment& moment, const MatchOverlays& overlays = {}) {
  const auto picture = MatchPicture::create(spec);
  REQUIRE(picture);
  auto canvas = picture->canvas();
  REQUIRE(canvas);
  picture->drawFrame(*canvas, moment, overlays);
  return std::move(*canvas);
}

Colour at(const Canvas& canvas, Vec2 pixel) {
  return canvas.pixel(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

int differing(const Canvas& a, const Canvas& b, int left, int top, int right, int bottom) {
  int found = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) found += same(a.pixel(x, y), b.pixel(x, y)) ? 0 : 1;
  }
  return found;
}
int differing(const Canvas& a, const Canvas& b) { return differing(a, b, 0, 0, a.width(), a.height()); }

}  // namespace

TEST_CASE("a moment gives the same pixels on every canvas", "[unit]") {
  const auto picture = MatchPicture::create(duel());
  REQUIRE(picture);
  auto first = picture->canvas(), second = picture->canvas();
  ReplayMoment other = apart();
  other.bodies[2]->position.x = 0.5;
  other.blue_side = Side::kRight;
  picture->drawFrame(*first, other);  // the frame drawn before leaves no trace
  picture->drawFrame(*first, apart());
  picture->drawFrame(*second, apart());
  CHECK(differing(*first, *second) == 0);
  CHECK(first->png(PngEffort::kFast) == second->png(PngEffort::kFast));
}

TEST_CASE("bodies are where they are, in their colours", "[unit]") {
  for (const PictureTheme theme : {PictureTheme::kDark, PictureTheme::kLight}) {
    MatchPictureSpec spec = duel(1920);
    spec.theme = theme;
    const auto picture = MatchPicture::create(spec);
    const ReplayMoment moment = apart();
    const Canvas canvas = drawn(spec, moment);
    const MatchStyle& style = styleOf(theme);
    CHECK(same(at(canvas, pixelOf(*picture, moment.bodies[2]->position)), style.ball));
    // A point between the mark and the body's side.
    const auto beside = [&](std::size_t body) {
      const Pose2& pose = *moment.bodies[body];
      return at(canvas, pixelOf(*picture, pose.position - math::unit(pose.heading) * (0.43 * 0.075)));
    };
    CHECK(same(beside(0), style.teams[0].body));
    CHECK(same(beside(1), style.teams[1].body));
    CHECK(same(at(canvas, pixelOf(*picture, {0.3, 0.3})), style.field.floor));
  }
}

TEST_CASE("teams have different marks, not colours alone", "[unit]") {
  // A point at 0.8 of a diamond's radius from its centre, diagonally, is outside a diamond but inside a disc.
  const auto picture = MatchPicture::create(duel(1920));
  ReplayMoment moment = apart();
  moment.bodies[0]->heading = moment.bodies[1]->heading = 0.0;
  const Canvas canvas = drawn(duel(1920), moment);
  const MatchStyle& style = styleOf(PictureTheme::kDark);
  const auto corner = [&](std::size_t body) {
    const Vec2 badge = moment.bodies[body]->position - Vec2{0.12 * 0.0375, 0.0};
    return at(canvas, pixelOf(*picture, badge + Vec2{-0.68, 0.68} * (0.29 * 0.075)));
  };
  CHECK(same(corner(0), style.teams[0].badge));
  CHECK(same(corner(1), style.teams[1].body));
}

TEST_CASE("a fifth of a pixel can be seen", "[unit]") {
  const auto picture = MatchPicture::create(duel());
  ReplayMoment moved = apart();
  const double pixel = 1.0 / (pixelOf(*picture, {1.0, 0.0}).x - pixelOf(*picture, {0.0, 0.0}).x);
  for (auto& body : moved.bodies) body->position.x += 0.2 * pixel;
  const int changed = differing(drawn(duel(), apart()), drawn(duel(), moved));
  CHECK(changed > 100);
  CHECK(changed < 6000);
}

TEST_CASE("goals have the colour of the team that defends them", "[unit]") {
  ReplayMoment moment = apart();
  const MatchStyle& style = styleOf(PictureTheme::kDark);
  const auto picture = MatchPicture::create(duel());
  const Vec2 left = pixelOf(*picture, {-0.8, 0.1}), right = pixelOf(*picture, {0.8, 0.1});
  CHECK(same(at(drawn(duel(), moment), left), style.teams[0].goal));
  moment.blue_side = Side::kRight;
  CHECK(same(at(drawn(duel(), moment), left), style.teams[1].goal));
  CHECK(same(at(drawn(duel(), moment), right), style.teams[0].goal));
}

TEST_CASE("who is not on the field is not drawn", "[unit]") {
  ReplayMoment moment = apart();
  moment.bodies.assign(3, std::nullopt);
  MatchPictureSpec nobody = duel();
  nobody.bodies.clear();
  const Canvas with = drawn(duel(), moment), without = drawn(duel(), {});
  CHECK(differing(with, without, 0, 90, 900, with.height()) == 0);
}

TEST_CASE("names of any kind stay in their place", "[unit]") {
  MatchPictureSpec spec = duel();
  const Canvas plain = drawn(spec, apart());
  for (const std::string& name :
       {std::string(3000, 'W'), std::string("\xff\xfe broken \x80"), std::string("a\nb\tc\x01"),
        std::string("\xd9\x81\xd8\xb1\xd9\x8a\xd9\x82 \xf0\x9f\xa4\x96"), std::string("%s%n{}"),
        std::string()}) {
    spec.names = {name, name};
    const Canvas canvas = drawn(spec, apart());
    // The area of the score between the names, and everything below the board.
    CHECK(differing(plain, canvas, 360, 0, 540, 84) == 0);
    CHECK(differing(plain, canvas, 0, 84, 900, canvas.height()) == 0);
  }
}

TEST_CASE("every size that is allowed can be drawn, others name the limits", "[unit]") {
  for (const auto& [width, height] :
       {std::pair{160, 120}, {400, 0}, {1920, 1080}, {300, 1200}, {2000, 121}}) {
    MatchPictureSpec spec = duel(width);
    spec.height = height;
    spec.seconds = 600.0;
    spec.goals = {{60, 1.0, TeamId::kBlue, {}}};
    MatchOverlays overlays;
    overlays.banner = {"Penalty", "too many defenders in the area", TeamId::kYellow};
    const Canvas canvas = drawn(spec, apart(), overlays);
    CHECK(canvas.width() == width);
    if (height != 0) CHECK(canvas.height() == height);
  }
  MatchPictureSpec spec = duel(159);
  spec.height = 120;
  const auto small = MatchPicture::create(spec);
  REQUIRE_FALSE(small);
  CHECK(small.error().code == ErrorCode::kUsage);
  CHECK_THAT(small.error().message, Catch::Contains("160 x 120") && Catch::Contains("159 x 120"));
  CHECK(MatchPicture::create(duel(20000)).error().code == ErrorCode::kUsage);
}

TEST_CASE("pixels and places of the field belong together", "[unit]") {
  const auto picture = MatchPicture::create(duel());
  for (const Vec2 place : {Vec2{0.0, 0.0}, Vec2{0.5, -0.3}, Vec2{-0.75, 0.65}}) {
    CHECK(distance(picture->toField(pixelOf(*picture, place)), place) < 1e-12);
  }
  CHECK(pixelOf(*picture, {0.0, 0.5}).y < pixelOf(*picture, {0.0, 0.0}).y);
}

TEST_CASE("poses that are no numbers are left out", "[unit]") {
  ReplayMoment moment = apart();
  moment.bodies[0]->position.x = std::nan("");
  moment.bodies[2]->position = {1e300, -1e300};
  moment.play_seconds = std::nan("");
  CHECK(drawn(duel(), moment).width() == 900);
}

TEST_CASE("the banner says what was called, and what a restart waits for", "[unit]") {
  const ReplayTimeline timeline = sampleReplay();
  const auto banner = [&](double seconds) { return bannerAt(timeline, timeline.at(seconds)); };
  CHECK(banner(7.99).title.empty());
  CHECK(banner(8.0).title == "Goal!");
  CHECK(banner(8.0).detail == "libero");
  CHECK(banner(8.0).team == TeamId::kBlue);
  CHECK(banner(9.9).title == "Goal!");
  CHECK(banner(10.6).title.empty());
  CHECK(banner(15.0).title == "Goal kick");
  CHECK(banner(15.0).detail == "too many attackers in the area");
  CHECK(banner(15.0).team == TeamId::kBlue);  // the team that gets the ball, not the team at fault
  CHECK(banner(17.6).title.empty());
}

TEST_CASE("trails end at their bodies and begin with the play", "[unit]") {
  const ReplayTimeline timeline = sampleReplay();
  ReplayDirector director(timeline, {});
  MatchOverlays overlays;
  for (const double seconds : {5.01, 15.4}) {
    const ReplayMoment moment = timeline.at(seconds);
    director.direct(moment, overlays);
    REQUIRE(overlays.trails.size() == 5);
    const BodyTrail& ball = overlays.trails[4];
    CHECK(distance(ball.points.back(), moment.bodies[4]->position) == 0.0);
    const double length = moment.bodies[4]->position.x - ball.points.front().x;
    CHECK(std::abs(length - 0.09 * (seconds < 15.0 ? 1.0 : 0.4)) < 4e-3);
  }
}

TEST_CASE("words of drawings at an edge of the picture are moved inside", "[unit]") {
  for (const double x : {-0.78, 0.78}) {
    RecordedDrawing word;
    word.kind = RecordedDrawing::Kind::kText;
    word.from = {x, -0.3};
    word.text = "words that are longer than there is room";
    MatchOverlays overlays;
    overlays.drawings = std::span(&word, 1);
    const Canvas without = drawn(duel(), apart()), with = drawn(duel(), apart(), overlays);
    const int width = with.width(), height = with.height();
    CAPTURE(x);
    CHECK(differing(without, with) > 500);
    CHECK(differing(without, with, 0, 0, 2, height) == 0);
    CHECK(differing(without, with, width - 2, 0, width, height) == 0);
    // The whole text is there, next to the edge.
    const int left = x < 0.0 ? 0 : width - 300;
    CHECK(differing(without, with, left, 0, left + 300, height) == differing(without, with));
  }
}

}  // namespace fulbito
