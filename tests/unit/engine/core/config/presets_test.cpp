#include <filesystem>
#include <fstream>

#include "engine/core/config/embedded_files.hpp"
#include "engine/core/config/schemas.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito {
namespace {

template <typename T>
void checkSame(T a, T b) {
  const Schema left = schemaOf(a), right = schemaOf(b);
  for (std::size_t i = 0; i < left.size(); ++i) {
    CAPTURE(left[i].key);
    CHECK(valueText(left[i]) == valueText(right[i]));
  }
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("the presets are those of the manual, in alphabetical order", "[unit]") {
  CHECK(presetNames("robots") == Names{"choi-lee-2005", "firasim", "jung-lee-2015", "vsss"});
  CHECK(presetNames("physics") == Names{"faithful", "fast", "standard"});
  CHECK(presetNames("fields") == Names{"jung-lee-2015", "vsss-3v3", "vsss-5v5"});
  CHECK(presetNames("nonsense").empty());
}

TEST_CASE("every preset loads under its own name", "[unit]") {
  for (const auto& name : presetNames("robots")) CHECK(loadRobot(name)->robot.name == name);
  for (const auto& name : presetNames("physics")) CHECK(loadPhysics(name)->name == name);
  for (const auto& name : presetNames("fields")) CHECK(loadField(name)->name == name);
}

TEST_CASE("a preset's text is the file that it was made from, byte for byte", "[unit]") {
  for (const EmbeddedFile& file : embeddedPresets()) {
    std::ifstream in(std::filesystem::path(FULBITO_PRESETS) / file.kind / (std::string(file.name) + ".toml"));
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    CHECK_FALSE(text.empty());
    CHECK(text == *presetText(file.kind, std::string(file.name)));
  }
}

TEST_CASE("the robot vsss has the figures of rSim", "[unit]") {
  const RobotPreset preset = *loadRobot("vsss");
  CHECK(preset.robot.mass == 0.15);
  CHECK(preset.robot.wheel_radius == 0.026);
  CHECK(preset.robot.axle_track == 0.0775);
  CHECK(preset.robot.maxSpeed() == Approx(1.20).epsilon(0.002));
  CHECK(preset.robot.turnAcceleration() == Approx(289.0).epsilon(0.01));
  // Yaw rate of a spin at +-w: ratio * 2 w r / track; measured 13.0 at 20 rad/s and 27.3 at 40 rad/s.
  CHECK(preset.robot.spin_slow_ratio * 2 * 20 * 0.026 / 0.0775 == Approx(13.0));
  CHECK(preset.robot.spin_fast_ratio * 2 * 40 * 0.026 / 0.0775 == Approx(27.3));
  CHECK(preset.robot.spin_fast_speed == Approx(40 * 0.026));
  CHECK(preset.ball.roll_keep == 0.69);
  CHECK(preset.ball.roll_deceleration == 0.14);
}

TEST_CASE("the robot firasim has the figures of FIRASim", "[unit]") {
  const RobotPreset preset = *loadRobot("firasim");
  CHECK(preset.robot.mass == 2.4);
  CHECK(preset.robot.wheel_radius == 0.02);
  CHECK(preset.robot.axle_track == 0.08);
  // Two motors of 0.11 N m at rims of 0.051 kg against supports that slide with friction 1.0 under a third
  // of 2.40 kg.
  const double mass = 2.40 + 2 * 0.051, weight = 2.40 * 9.81;
  CHECK(preset.robot.motorPull() == Approx(2 * 0.11 / 0.02 / mass).epsilon(0.002));
  CHECK(preset.robot.rolling_drag == Approx(weight / 3 / mass).epsilon(0.005));
  CHECK(preset.robot.wheel_acceleration == Approx(preset.robot.motorPull() - preset.robot.rolling_drag));
  CHECK(preset.robot.longitudinal_grip == Approx(0.8 * 9.81 * 2 / 3).epsilon(0.001));
  CHECK(preset.robot.lateral_grip == Approx(1.0 * 9.81 * 2 / 3).epsilon(0.001));
  CHECK(preset.robot.turnAcceleration() == Approx(160.0));
  CHECK(preset.robot.spin_slow_ratio * 2 * 20 * 0.02 / 0.08 == Approx(9.41));
  CHECK(preset.robot.spin_fast_ratio * 2 * 40 * 0.02 / 0.08 == Approx(21.3));
  CHECK(preset.ball.mass == 0.043);
  CHECK(preset.ball.roll_keep == 0.70);
  CHECK(preset.ball.roll_deceleration == 0.0756);
}

TEST_CASE("the robot jung-lee-2015 has the figures of the comparison", "[unit]") {
  const RobotModel robot = loadRobot("jung-lee-2015")->robot;
  CHECK(robot.length == 0.075);
  CHECK(robot.axle_track == 0.068);
  CHECK(robot.maxSpeed() == Approx(2.6));
  CHECK(robot.wheel_acceleration == 5.0);
  CHECK(robot.lateral_grip == 6.0);
}

TEST_CASE("the robot choi-lee-2005 has the figures of the paper's Table 3 and a calibrated slip", "[unit]") {
  const RobotModel robot = loadRobot("choi-lee-2005")->robot;
  CHECK(robot.length == 0.66);
  CHECK(robot.width == 0.43);
  CHECK(robot.mass == 19.5);
  CHECK(robot.wheel_radius == 0.105);
  CHECK(robot.axle_track == 0.4);
  CHECK(robot.maxSpeed() > 0.588);  // the limit of its wheels in the capture
  CHECK(robot.curve_widening == 1.319);
  CHECK(robot.curve_widening_rise == 2.41);
  for (const char* other : {"vsss", "firasim", "jung-lee-2015"}) {
    CHECK(loadRobot(other)->robot.curve_widening == 0.0);
    CHECK(loadRobot(other)->robot.curve_widening_rise == 0.0);
  }
}

TEST_CASE("the physics profiles step at 60, 120 and 240 Hz under one control rate", "[unit]") {
  CHECK(loadPhysics("fast")->stepPeriod() == 1.0 / 60);
  for (const auto& name : presetNames("physics")) CHECK(loadPhysics(name)->bullet_ball);
  CHECK(loadPhysics("standard")->stepPeriod() == 1.0 / 120);
  CHECK(loadPhysics("faithful")->stepPeriod() == 1.0 / 240);
  for (const auto& name : presetNames("physics")) CHECK(loadPhysics(name)->controlPeriod() == 1.0 / 60);
}

TEST_CASE("the default structs are the presets standard and vsss-3v3", "[unit]") {
  checkSame(*loadPhysics("standard"), PhysicsProfile{});
  checkSame(*loadField("vsss-3v3"), FieldGeometry{});
}

TEST_CASE("the fields have the sizes of the rules and of the paper", "[unit]") {
  const FieldGeometry five = *loadField("vsss-5v5"), paper = *loadField("jung-lee-2015");
  CHECK(five.length == 2.2);
  CHECK(five.width == 1.8);
  CHECK(five.goal_depth == 0.15);
  CHECK(five.corner == 0.07);
  CHECK(innerContour(paper) == std::vector<Vec2>{{0.75, -0.65}, {0.75, 0.65}, {-0.75, 0.65}, {-0.75, -0.65}});
}

TEST_CASE("what is loaded can be written and loaded again to the same bits", "[unit]") {
  const test::ScratchFolder folder;
  for (const auto& name : presetNames("robots")) {
    const RobotPreset preset = *loadRobot(name);
    const auto back = loadRobot(folder.write("r.toml", toToml(preset)));
    REQUIRE(back);
    checkSame(back->robot, preset.robot);
    checkSame(back->ball, preset.ball);
  }
  for (const auto& name : presetNames("physics")) {
    checkSame(*loadPhysics(folder.write("p.toml", toToml(*loadPhysics(name)))), *loadPhysics(name));
  }
  for (const auto& name : presetNames("fields")) {
    checkSame(*loadField(folder.write("f.toml", toToml(*loadField(name)))), *loadField(name));
  }
}

TEST_CASE("written files say what each key means and in which unit", "[unit]") {
  const std::string text = toToml(PhysicsProfile{});
  CHECK(
      text.starts_with("[physics]\nname = \"standard\"  # shown in tables and results\n"
                       "control_rate = 60  # [Hz] ticks per second for navigators and teams\n"));
}

TEST_CASE("a key that a file lacks keeps its default and a missing name is the file's", "[unit]") {
  const test::ScratchFolder folder;
  const auto preset = loadRobot(folder.write("mine.toml", "[robot]\nmass = 1\n"));
  REQUIRE(preset);
  CHECK(preset->robot.mass == 1.0);
  CHECK(preset->robot.name == "mine");
  CHECK(preset->robot.length == RobotModel{}.length);
  CHECK(preset->ball.radius == BallModel{}.radius);
}

TEST_CASE("a file needs no ending when it has a slash, or exists and is no preset", "[unit]") {
  const test::ScratchFolder folder;
  CHECK(loadField(folder.write("arena", "[field]\nlength = 3\n"))->length == 3.0);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  folder.write("vsss-3v3", "[field]\nlength = 4\n");
  const auto bare = loadField("arena"), shadowed = loadField("vsss-3v3");
  std::filesystem::current_path(before);
  CHECK(bare->length == 3.0);
  CHECK(shadowed->length == 1.5);
}

TEST_CASE("texts are read as files are", "[unit]") {
  CHECK(parseRobot(toToml(*loadRobot("firasim")), "recorded")->robot.mass ==
        loadRobot("firasim")->robot.mass);
  CHECK(parseRobot(toToml(*loadRobot("firasim")), "recorded")->ball.mass == loadRobot("firasim")->ball.mass);
  CHECK(parsePhysics(toToml(*loadPhysics("standard")), "recorded")->substeps == 2);
  CHECK(parseField(toToml(*loadField("vsss-5v5")), "recorded")->length == loadField("vsss-5v5")->length);
  CHECK(parseField("[field]\nlength = -3\n", "recorded").error().message.find("recorded:2: field.length") ==
        0);
  CHECK(parsePhysics("", "recorded").error().code == ErrorCode::kBadInput);
}

}  // namespace fulbito
