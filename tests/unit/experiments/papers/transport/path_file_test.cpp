#include "experiments/papers/transport/path_file.hpp"

#include <catch2/catch.hpp>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

std::string errorOf(const std::string& text) {
  const auto task = parseTransport(text, "p.txt");
  return task ? "" : task.error().message;
}

const std::string kLine = "line 0 0 0\nend 300 0\n";

}  // namespace

TEST_CASE("the S path comes from Table 2 without radii", "[unit]") {
  const TransportTask task = builtInTransport("s-path");
  REQUIRE(task.path.size() == 5);
  CHECK(task.path.parts()[1].curvature == Approx(1 / 0.25));
  CHECK(task.path.parts()[3].curvature == Approx(-1 / 0.25));
  const double wanted[] = {4.0, 4.7854, 7.7854, 8.5708, 12.5708};
  for (std::size_t i = 0; i < 5; ++i) CHECK(task.path.to(i) == Approx(wanted[i]).margin(1e-4));
  for (std::size_t i = 0; i < 4; ++i) CHECK(task.path.jumpAfter(i) == Approx(0.0).margin(1e-12));
  CHECK(task.rod == 0.8);
  CHECK(task.lead == Approx(0.8));
  CHECK(task.follower == 0.0);
}

TEST_CASE("the long path has 43 parts in 400 x 500 cm and a rod of 40 cm", "[unit]") {
  const TransportTask task = builtInTransport("maze");
  CHECK(task.path.size() == 43);
  CHECK(task.rod == Approx(0.4));
  CHECK(task.path.pose(task.lead).position.y == Approx(0.4));
  for (double q = 0.0; q < task.path.length(); q += 0.01) {
    const Vec2 at = task.path.pose(q).position;
    const bool inside = at.x > -1e-6 && at.x < 4.0 && at.y > -1e-6 && at.y < 5.0;
    REQUIRE(inside);
  }
}

TEST_CASE("a task survives its own text", "[unit]") {
  for (const char* name : {"s-path", "maze"}) {
    const TransportTask task = builtInTransport(name);
    const auto again = parseTransport(toText(task), "again");
    REQUIRE(again);
    REQUIRE(again->path.size() == task.path.size());
    CHECK(again->lead == Approx(task.lead).margin(1e-6));
    for (std::size_t i = 0; i < task.path.size(); ++i) {
      CHECK(distance(endOf(again->path.parts()[i]).position, endOf(task.path.parts()[i]).position) < 1e-5);
    }
  }
}

TEST_CASE("points are fitted, and settings have defaults", "[unit]") {
  const auto task = parseTransport("point 0 0\npoint 200 0 # corner\npoint 200 200\nrod 50", "p");
  REQUIRE(task);
  CHECK(task->path.size() == 2);
  CHECK(task->path.length() == Approx(4.0));
  CHECK(task->lead == Approx(0.5));
  CHECK(task->speed == 0.08);
}

TEST_CASE("a length ends a line before a corner", "[unit]") {
  // The foot of the perpendicular from the arc's centre would be at 200.
  const auto task = parseTransport("line 0 0 0 150\narc 200 0 -90\n", "p");
  REQUIRE(task);
  CHECK(task->path.length() == Approx(1.5 + 0.5 * math::kPi / 2));
  CHECK(task->path.jumpAfter(0) == Approx(math::kPi / 2));
}

TEST_CASE("errors name file and line", "[unit]") {
  CHECK(errorOf("lines 0 0 0\n") == "p.txt:1: unknown word 'lines'");
  CHECK(errorOf("\nline 0 0\n") == "p.txt:2: expected 'line X Y SLOPE [LENGTH]'");
  CHECK(errorOf("line 0 zero 0\n") == "p.txt:1: 'zero' is not a number in -10000 ... 10000");
  CHECK(errorOf("line 0 inf 0\n") == "p.txt:1: 'inf' is not a number in -10000 ... 10000");
  CHECK(errorOf(kLine + "rod 80\nrod 70\n") == "p.txt:4: 'rod' stands in line 3 already");
  CHECK(errorOf("") == "p.txt:1: no 'line', 'arc' or 'point' in the file");
  CHECK(errorOf("line 0 0 0\n") == "p.txt:1: a path that ends with a line needs a row 'end X Y'");
  CHECK(errorOf("line 0 0 0\nend 100 5\n") == "p.txt:2: the end is not on the last line");
  CHECK(errorOf("line 0 0 0\nend -100 0\n") == "p.txt:1: the line would end before it begins");
  CHECK(errorOf("line 0 0 0 -5\n") == "p.txt:1: a line's length must be above 0");
  CHECK(errorOf("line 0 0 0 100\nline 90 0 0 10\n") ==
        "p.txt:2: the line begins at (90, 0), but the part before ends at (100.00, 0.00)");
  CHECK(errorOf("line 0 0 0\nline 100 50 0 10\n") == "p.txt:2: the line does not begin on the line before");
  CHECK(errorOf("arc 0 0 90\n") == "p.txt:1: a path that begins with an arc needs a row 'start X Y'");
  CHECK(errorOf("start 5 0\narc 0 0 0\n") ==
        "p.txt:2: an arc's angle must be above 0 and below 360 degrees to either side");
  CHECK(errorOf("start 5 0\narc 5 0 90\n") == "p.txt:2: the arc begins at its own centre");
  CHECK(errorOf(kLine + "point 0 0\npoint 1 0\n") == "p.txt:1: a path has either points, or lines and arcs");
  CHECK(errorOf("point 0 0\npoint 0 0\n") == "p.txt:1: point 2 repeats the one before");
  CHECK(errorOf(kLine + "lead 80 20\n") == "p.txt:3: the lead starts 20.0 cm beside the path");
  CHECK(errorOf(kLine + "lead 70 0\n") ==
        "p.txt:3: the lead starts 70.00 cm from the follower, but the rod has 80.00 cm");
  CHECK(errorOf(kLine + "speed 20\n") == "p.txt: speed must be 0.01 ... 10 (cm, s), not 20");
  CHECK(errorOf("line 0 0 0\nend 50 0\n") ==
        "p.txt:3: no point of the path is a rod's length away from the follower");
}

TEST_CASE("a missing file is an error of its own kind", "[unit]") {
  const auto task = loadTransport("/nowhere/path.txt");
  REQUIRE_FALSE(task);
  CHECK(task.error().code == ErrorCode::kIo);
}

}  // namespace fulbito
