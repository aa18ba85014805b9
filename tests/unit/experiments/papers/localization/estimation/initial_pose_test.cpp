#include "experiments/papers/localization/estimation/initial_pose.hpp"

#include <cmath>

#include "experiments/papers/localization/estimation/wall_ahead.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::localization;
using namespace fulbito::test;

namespace {

constexpr Body kBody{0.44, 0.36};
constexpr double kEchoSpeed = 172.0;
const Room kRoom{4.2, 3.1};

/// Echoes of an aligned robot, from geometry alone.
EchoTimes echoesAt(const Pose2& pose) {
  EchoTimes times;
  for (const Beam beam : kBeams)
    times[indexOf(beam)] = wallAhead(kRoom, kBody, pose, beam).distance / kEchoSpeed;
  return times;
}

const Pose2 kDown{{1.3, 0.9}, -math::kPi / 2};
const Pose2 kLeft{{1.3, 0.9}, -math::kPi};

}  // namespace

// Erratum of (1): the printed y = a + l is the rear edge if l is the length, and the printed lines hold only
// for -y.
TEST_CASE("the pose of a robot that faces -y is that of its centre", "[unit]") {
  const auto found = locate(kRoom, kBody, echoesAt(kDown), 0.001);
  REQUIRE(found);
  CHECK(found->axis.facing == Facing::kMinusY);
  CHECK(found->axis.echo_speed == Approx(kEchoSpeed));
  CHECK(distance(found->pose.position, kDown.position) < 1e-9);
  CHECK(found->pose.heading == Approx(-math::kPi / 2));
  const double ahead = kEchoSpeed * *echoesAt(kDown)[indexOf(Beam::kFront)];
  // (1) as printed gives the rear
  CHECK(ahead + kBody.length == Approx(kDown.position.y + kBody.length / 2));
}

TEST_CASE("facing -x the axes swap and the left side counts", "[unit]") {
  const auto found = locate(kRoom, kBody, echoesAt(kLeft), 0.001);
  REQUIRE(found);
  CHECK(found->axis.facing == Facing::kMinusX);
  CHECK(distance(found->pose.position, kLeft.position) < 1e-9);
  CHECK(found->pose.heading == Approx(-math::kPi));
}

TEST_CASE("a rectangle has two poses with the same echoes", "[unit]") {
  for (const Pose2& pose : {kDown, kLeft}) {
    const Pose2 other = halfTurned(pose, kRoom);
    const auto a = locate(kRoom, kBody, echoesAt(pose), 0.001),
               b = locate(kRoom, kBody, echoesAt(other), 0.001);
    REQUIRE(a);
    REQUIRE(b);
    CHECK(distance(a->pose.position, b->pose.position) < 1e-9);
    CHECK(distance(halfTurned(other, kRoom).position, pose.position) < 1e-12);
  }
}

TEST_CASE("a tilt of 5 degrees shifts the constant by less than 0.1 %", "[unit]") {
  Pose2 tilted = kDown;
  tilted.heading += 5 * math::kPi / 180;
  const auto found = locate(kRoom, kBody, echoesAt(tilted), 0.001);
  REQUIRE(found);
  // The sum of both ranges is R - w cos 5 exactly, since a cone hears the perpendicular.
  const double sum = kRoom.x - kBody.width * math::cos(5 * math::kPi / 180);
  CHECK(found->axis.echo_speed == Approx(kEchoSpeed * (kRoom.x - kBody.width) / sum));
  CHECK(std::abs(found->axis.echo_speed / kEchoSpeed - 1.0) < 1e-3);
}

TEST_CASE("a start without an echo or with a wall too far ahead is refused", "[unit]") {
  EchoTimes times = echoesAt(kDown);
  times[indexOf(Beam::kLeft)].reset();
  REQUIRE_FALSE(locate(kRoom, kBody, times, 0.001));
  CHECK(locate(kRoom, kBody, times, 0.001).error().message == "a sensor has no echo of its wall");
  times = echoesAt(kDown);
  *times[indexOf(Beam::kFront)] += 2.5 / kEchoSpeed;  // a pose beyond the rear wall
  const auto far = locate(kRoom, kBody, times, 0.001);
  REQUIRE_FALSE(far);
  CHECK(far.error().message.find("the wall ahead is") == 0);
}

TEST_CASE("the covariance of the start is that of its errors", "[unit]") {
  constexpr double kSigma = 0.004;
  constexpr int kRuns = 4000;
  for (const Pose2& pose : {kDown, kLeft}) {
    Rng random(3, kTestStream);
    std::array<double, 9> sums{};
    InitialPose last;
    for (int run = 0; run < kRuns; ++run) {
      EchoTimes times = echoesAt(pose);
      for (auto& time : times) *time += random.normal(0.0, kSigma) / kEchoSpeed;
      last = *locate(kRoom, kBody, times, kSigma);
      const std::array errors{last.pose.position.x - pose.position.x, last.pose.position.y - pose.position.y,
                              last.axis.echo_speed - kEchoSpeed};
      for (std::size_t i = 0; i < 9; ++i) sums[i] += errors[i / 3] * errors[i % 3] / kRuns;
    }
    for (std::size_t i = 0; i < 9; ++i) {
      const double scale = std::sqrt(last.covariance[i / 3 * 4] * last.covariance[i % 3 * 4]);
      CHECK(sums[i] == Approx(last.covariance[i]).margin(0.08 * scale));
    }
  }
}
