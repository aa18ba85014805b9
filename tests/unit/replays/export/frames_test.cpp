#include "replays/export/frames.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/sample_replay.hpp"

namespace fulbito {
namespace {

std::vector<std::string> framesWith(int jobs, std::optional<std::size_t> fail_at = {}) {
  static const ReplayTimeline timeline = test::sampleReplay();
  MatchPictureSpec spec = *pictureSpecOf(timeline);
  spec.width = 200;
  const auto picture = MatchPicture::create(spec);
  REQUIRE(picture);
  FrameJob job{&timeline, &*picture, {}, filmTimes({{0.0, 20.0}}, 5.0, 4.0), jobs};
  std::vector<std::string> frames;
  const auto done = forEachFrame(
      job, [] { return [](Canvas& canvas, std::string& out) { out = canvas.png(PngEffort::kFast); }; },
      [&](std::size_t index, std::string& bytes) -> Result<void> {
        REQUIRE(index == frames.size());
        if (index == fail_at) return fail(ErrorCode::kInterrupted, "enough");
        frames.push_back(bytes);
        return {};
      });
  CHECK(done.has_value() == !fail_at.has_value());
  return frames;
}

}  // namespace

TEST_CASE("frames come in order and are the same for any number of threads", "[unit]") {
  const auto one = framesWith(1), three = framesWith(3);
  CHECK(one.size() == 26);
  CHECK(one == three);
  CHECK(one[0] != one[1]);
}

TEST_CASE("an error of the sink ends the film", "[unit]") {
  CHECK(framesWith(3, 0).empty());
  CHECK(framesWith(2, 7).size() == 7);
}

TEST_CASE("a film shows a second of the recording in as many frames as it should", "[unit]") {
  CHECK(filmTimes({{0.0, 1.0}}, 30.0, 1.0).size() == 31);
  CHECK(filmTimes({{0.0, 600.0}}, 30.0, 4.0).size() == 4501);
  CHECK(filmTimes({{2.0, 2.0}}, 30.0, 4.0) == std::vector<double>{2.0});
  const auto joined = filmTimes({{5.0, 7.0}, {0.0, 2.0}, {1.0, 3.0}}, 1.0, 1.0);
  CHECK(joined == std::vector<double>{0, 1, 2, 3, 5, 6, 7});
}

TEST_CASE("stretches around events stay within the recording", "[unit]") {
  const ReplayTimeline timeline = test::sampleReplay();
  const auto ranges = rangesAround(timeline, {60, 8 * 60, 19 * 60}, 5.0, 3.0);
  REQUIRE(ranges.size() == 3);
  CHECK(ranges[0].from == 0.0);
  CHECK(ranges[1].from == 3.0);
  CHECK(ranges[1].to == 11.0);
  CHECK(ranges[2].to == 20.0);
}

TEST_CASE("a thread that runs out of memory ends the film, which nobody waits for", "[unit]") {
  static const ReplayTimeline timeline = test::sampleReplay();
  MatchPictureSpec spec = *pictureSpecOf(timeline);
  spec.width = 200;
  const auto picture = MatchPicture::create(spec);
  REQUIRE(picture);
  for (const int jobs : {1, 3}) {
    const FrameJob job{&timeline, &*picture, {}, filmTimes({{0.0, 20.0}}, 5.0, 4.0), jobs};
    const auto draw = [&] {
      return forEachFrame(
          job, []() -> FramePacker { return [](Canvas&, std::string&) { throw std::bad_alloc(); }; },
          [](std::size_t, std::string&) -> Result<void> { return {}; });
    };
    CHECK_THROWS_AS(draw(), std::bad_alloc);
  }
}

}  // namespace fulbito
