#include <cstring>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr const char* kLayout = R"([layout]
name = "three obstacles"
field = "vsss-5v5"
[start]
position = [-0.6, -0.5]
heading_deg = 90
[goal]
position = [0.6, 0.5]
heading_deg = 180
tolerance = 0.02
heading_tolerance_deg = 5
[[obstacle]]
position = [0, 0.1]
[[obstacle]]
shape = "box"
motion = "pushable"
position = [0.2, 0]
heading_deg = 270.0
length = 0.1
width = 0.05
mass = 0.4
floor_friction = 2
[[obstacle]]
motion = "path"
path = [[0, 0], [0.5, 0.0], [0.5, 0.5]]
speed = 0.4
path_end = "cycle"
)";

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool sameBits(Vec2 a, Vec2 b) { return sameBits(a.x, b.x) && sameBits(a.y, b.y); }
bool sameBits(const Pose2& a, const Pose2& b) {
  return sameBits(a.position, b.position) && sameBits(a.heading, b.heading);
}
bool sameBits(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](Vec2 p, Vec2 q) { return sameBits(p, q); });
}
bool sameBits(const ObstacleSpec& a, const ObstacleSpec& b) {
  return a.shape == b.shape && a.motion == b.motion && sameBits(a.pose, b.pose) &&
         sameBits(a.radius, b.radius) && sameBits(a.length, b.length) && sameBits(a.width, b.width) &&
         sameBits(a.mass, b.mass) && sameBits(a.floor_friction, b.floor_friction) &&
         sameBits(a.path, b.path) && sameBits(a.speed, b.speed) && a.path_end == b.path_end;
}

void checkSame(const Layout& a, const Layout& b) {
  CHECK(a.name == b.name);
  CHECK(a.field == b.field);
  CHECK(sameBits(a.start, b.start));
  CHECK(sameBits(a.goal, b.goal));
  REQUIRE(a.goal_heading.has_value() == b.goal_heading.has_value());
  if (a.goal_heading) CHECK(sameBits(*a.goal_heading, *b.goal_heading));
  CHECK(sameBits(a.goal_tolerance, b.goal_tolerance));
  CHECK(sameBits(a.heading_tolerance, b.heading_tolerance));
  REQUIRE(a.obstacles.size() == b.obstacles.size());
  for (std::size_t i = 0; i < a.obstacles.size(); ++i) CHECK(sameBits(a.obstacles[i], b.obstacles[i]));
}

Layout randomLayout(Rng& rng) {
  const auto point = [&rng] { return Vec2{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}; };
  Layout layout;
  layout.name = "odd \"name\" \xc3\xa9";
  layout.start = {point(), rng.uniform(-math::kPi, math::kPi)};
  layout.goal = point();
  if (rng.uniform(0, 1) < 0.5) layout.goal_heading = rng.uniform(-math::kPi, math::kPi);
  layout.goal_tolerance = rng.uniform(0.01, 0.1);
  layout.heading_tolerance = rng.uniform(0.01, 3.0);
  for (int i = 0; i < 12; ++i) {
    ObstacleSpec o;
    o.shape = static_cast<ObstacleShape>(i % 2);
    o.motion = static_cast<ObstacleMotion>(i % 3);
    o.path_end = static_cast<PathEnd>(i / 3 % 3);
    o.pose = {point(), rng.uniform(-math::kPi, math::kPi)};
    o.radius = rng.uniform(0.01, 0.1), o.length = rng.uniform(0.01, 0.1), o.width = rng.uniform(0.01, 0.1);
    o.mass = rng.uniform(0.01, 1.0), o.floor_friction = rng.uniform(0.0, 1.0),
    o.speed = rng.uniform(0.1, 1.0);
    if (i % 2 == 0 || o.motion == ObstacleMotion::kPath) o.path = {o.pose.position, point(), point()};
    layout.obstacles.push_back(o);
  }
  return layout;
}

}  // namespace

TEST_CASE("a layout file says everything about a layout", "[unit]") {
  const auto layout = parseLayout(kLayout, "a.toml");
  REQUIRE(layout);
  CHECK(layout->name == "three obstacles");
  CHECK(layout->field == "vsss-5v5");
  CHECK(layout->start.position == Vec2{-0.6, -0.5});
  CHECK(layout->start.heading == math::kPi / 2);
  CHECK(layout->goal_heading == -math::kPi);
  CHECK(layout->goal_tolerance == 0.02);
  CHECK(layout->heading_tolerance == Approx(0.0872665));
  REQUIRE(layout->obstacles.size() == 3);
  CHECK(layout->obstacles[0].radius == 0.0335);
  CHECK(layout->obstacles[1].shape == ObstacleShape::kBox);
  CHECK(layout->obstacles[1].motion == ObstacleMotion::kPushable);
  CHECK(layout->obstacles[1].pose.heading == Approx(-math::kPi / 2));
  CHECK(layout->obstacles[1].mass == 0.4);
  CHECK(layout->obstacles[2].pose.position == Vec2{0, 0});
  CHECK(layout->obstacles[2].path.size() == 3);
  CHECK(layout->obstacles[2].path_end == PathEnd::kCycle);
}

TEST_CASE("a written layout is read back to the same bits", "[unit]") {
  checkSame(*parseLayout(toToml(Layout{}), "x"), Layout{});
  checkSame(*parseLayout(toToml(*parseLayout(kLayout, "x")), "x"), *parseLayout(kLayout, "x"));
  Rng rng(7, test::kTestStream);
  for (int i = 0; i < 50; ++i) {
    const Layout layout = randomLayout(rng);
    REQUIRE(validate(layout));
    const auto back = parseLayout(toToml(layout), "x");
    REQUIRE(back);
    checkSame(*back, layout);
  }
}

TEST_CASE("an obstacle is written without the keys that do nothing for it", "[unit]") {
  Layout layout;
  layout.obstacles.resize(1);
  const std::string text = toToml(layout);
  CHECK(text.substr(text.find("[[obstacle]]")) ==
        "[[obstacle]]\nshape = \"disc\"\nmotion = \"fixed\"\nposition = [0.0, 0.0]\nheading = 0.0\n"
        "radius = 0.0335\n");
}

TEST_CASE("a field file is found from the layout's folder", "[unit]") {
  const test::ScratchFolder folder;
  folder.write("fields/big.toml", "[field]\nlength = 4\nwidth = 3\n");
  const std::string text =
      "[layout]\nfield = \"../fields/big.toml\"\n[start]\nposition = [1.9, 0]\n[goal]\nposition = [0, 1]\n";
  const auto layout = loadLayout(folder.write("layouts/a.toml", text));
  REQUIRE(layout);
  CHECK(layout->name == "a");
  CHECK(loadField(layout->field)->length == 4.0);
}

}  // namespace fulbito
