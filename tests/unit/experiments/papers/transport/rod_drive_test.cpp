#include "experiments/papers/transport/rod_drive.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "experiments/papers/transport/path_file.hpp"

namespace fulbito {
namespace {

constexpr double kTick = 1.0 / 60;

}  // namespace

TEST_CASE("a profile keeps every limit from rest to rest", "[unit]") {
  const TransportTask task = builtInTransport("s-path");
  const RodWorld world = rodWorldFor(task);
  RodPace pace;
  pace.speed = 0.3;
  const auto references = profileAlong(task, traceCurve(task), world.robot, pace, kTick);
  REQUIRE(references);
  double fastest = 0.0, hardest = 0.0, stretch = 0.0;
  for (std::size_t i = 1; i < references->size(); ++i) {
    const RodReference &a = (*references)[i - 1], &b = (*references)[i];
    fastest = std::max({fastest, std::abs(b.lead.speed), std::abs(b.follower.speed)});
    hardest = std::max(hardest, std::abs(b.lead.speed - a.lead.speed) / kTick);
    stretch = std::max(stretch, std::abs(norm(viewRod(task.path, b.lead.place, b.follower.place).rod) - 0.8));
  }
  CHECK(fastest <= 0.3 + 1e-9);
  CHECK(fastest > 0.29);
  CHECK(hardest <= 0.75 * 1.05);
  CHECK(stretch < 1e-5);
  CHECK(references->front().lead.speed == 0.0);
  CHECK(references->back().lead.speed == Approx(0.0).margin(1e-9));
  CHECK(references->back().lead.place.q == Approx(task.path.length()));
}

TEST_CASE("a path with corners has no profile", "[unit]") {
  const TransportTask task = builtInTransport("maze");
  const auto references = profileAlong(task, traceCurve(task), rodWorldFor(task).robot, {}, kTick);
  REQUIRE_FALSE(references);
  CHECK(references.error().message == "the path has a corner after part 5");
}

TEST_CASE("two robots carry a real rod along the S path", "[unit]") {
  const TransportTask task = builtInTransport("s-path");
  const RodWorld world = rodWorldFor(task);
  RodPace pace;
  pace.speed = 0.4;
  const auto references = profileAlong(task, traceCurve(task), world.robot, pace, kTick);
  REQUIRE(references);
  const auto drive = driveRod(task, world, *references);
  REQUIRE(drive);
  CHECK(drive->end_gap < 0.002);
  CHECK(drive->path_error < 0.005);
  CHECK(drive->rod_error < 0.0005);
  CHECK(drive->peak_force > 0.05);
  CHECK(drive->peak_force < 5.0);
}

// docs/papers.md explains why a centre is faster than the limit.
TEST_CASE("only catching up makes a centre faster than the limit of its reference", "[unit]") {
  const TransportTask task = builtInTransport("s-path");
  const RodWorld world = rodWorldFor(task);
  RodPace pace;
  pace.speed = 0.25;
  const auto references = profileAlong(task, traceCurve(task), world.robot, pace, kTick);
  REQUIRE(references);
  PathControl blind;
  blind.along = 0.0;
  const auto catching = driveRod(task, world, *references),
             steady = driveRod(task, world, *references, blind);
  REQUIRE(catching);
  REQUIRE(steady);
  CHECK(catching->peak_speed > 1.008 * pace.speed);
  CHECK(steady->peak_speed < 1.005 * pace.speed);
}

TEST_CASE("the controller steers back to the path and goes ahead to its place", "[unit]") {
  const PartPath path({{{{0.0, 0.0}, 0.0}, 0.0, 5.0}});
  const PathControl control;
  const CarrierReference at{{0, 1.0}, 0.2};
  CHECK(control.command(path, at, {{1.0, 0.0}, 0.0}).linear == Approx(0.2));
  CHECK(control.command(path, at, {{1.0, 0.0}, 0.0}).angular == Approx(0.0).margin(1e-12));
  CHECK(control.command(path, at, {{0.9, 0.0}, 0.0}).linear > 0.2);
  CHECK(control.command(path, at, {{1.0, 0.05}, 0.0}).angular < 0.0);
  CHECK(control.command(path, at, {{1.0, 0.0}, 0.1}).angular < 0.0);
  // Backward, the same turn moves the robot to the other side.
  CHECK(control.command(path, {{0, 1.0}, -0.2}, {{1.0, 0.05}, 0.0}).angular > 0.0);
}

}  // namespace fulbito
