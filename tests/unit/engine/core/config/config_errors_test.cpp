#include <filesystem>

#include "engine/core/config/toml_reader.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito {
namespace {

std::string layoutError(const std::string& text) {
  const auto layout = parseLayout(text, "a.toml");
  REQUIRE_FALSE(layout);
  CHECK(layout.error().code == ErrorCode::kBadInput);
  return layout.error().message;
}

/// The message for a robot file, its folder cut off.
std::string robotError(const std::string& text) {
  const test::ScratchFolder folder;
  const auto robot = loadRobot(folder.write("mine.toml", text));
  REQUIRE_FALSE(robot);
  CHECK(robot.error().code == ErrorCode::kBadInput);
  const std::string prefix = folder.path().string() + "/";
  REQUIRE(robot.error().message.starts_with(prefix));
  return robot.error().message.substr(prefix.size());
}

// Lines 1 to 4; what follows stands on line 5.
const std::string kHead = "[start]\nposition = [0, 0]\n[goal]\nposition = [1, 1]\n";

}  // namespace

TEST_CASE("an unknown preset is a usage error with a suggestion", "[unit]") {
  const auto robot = loadRobot("vss");
  REQUIRE_FALSE(robot);
  CHECK(robot.error().code == ErrorCode::kUsage);
  CHECK(robot.error().message ==
        "'vss' is neither a file nor a preset of robots: choi-lee-2005, firasim, jung-lee-2015, vsss. Did "
        "you mean "
        "'vsss'?");
  CHECK(loadPhysics("quick").error().message ==
        "'quick' is neither a file nor a preset of physics: faithful, fast, standard.");
  CHECK(presetText("fields", "vsss-6v6").error().code == ErrorCode::kUsage);
  CHECK(presetText("teams", "a").error().message == "there are no presets of kind 'teams'");
  CHECK(loadRobot("").error().code == ErrorCode::kUsage);
  CHECK(loadRobot(std::string("vsss\0x", 6)).error().code == ErrorCode::kUsage);
}

TEST_CASE("a file that cannot be read is an I/O error that says why", "[unit]") {
  const test::ScratchFolder folder;
  const std::string missing = (folder.path() / "none.toml").string();
  CHECK(loadRobot(missing).error().code == ErrorCode::kIo);
  CHECK(loadRobot(missing).error().message == "cannot read '" + missing + "': No such file or directory");
  CHECK(loadLayout("none").error().message == "cannot read 'none': No such file or directory");
  CHECK(loadField(folder.path().string()).error().message ==
        "cannot read '" + folder.path().string() + "': Is a directory");
  const std::string locked = folder.write("locked.toml", "[robot]\n");
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (geteuid() != 0)
    CHECK(loadRobot(locked).error().message == "cannot read '" + locked + "': Permission denied");
  CHECK(loadRobot(locked + "/x").error().message == "cannot read '" + locked + "/x': Not a directory");
}

TEST_CASE("a file that never ends is read only as far as the limit", "[unit]") {
  CHECK(loadRobot("/dev/zero").error().message == "/dev/zero: larger than the limit of 1048576 bytes");
  CHECK(loadRobot("/dev/zero").error().code == ErrorCode::kBadInput);
}

TEST_CASE("a value outside its range is named with its range", "[unit]") {
  CHECK(robotError("[robot]\n\n\n\n\n\nmass = -1\n") ==
        "mine.toml:7: robot.mass = -1 is outside 0.001 ... 50 kg");
  CHECK(robotError("[robot]\nmass = nan\n") == "mine.toml:2: robot.mass = nan is outside 0.001 ... 50 kg");
  CHECK(robotError("[robot]\nmass = inf\n") == "mine.toml:2: robot.mass = inf is outside 0.001 ... 50 kg");
  CHECK(robotError("[robot]\n[ball]\nroll_keep = 2\n") ==
        "mine.toml:3: ball.roll_keep = 2 is outside 0.05 ... 1");
  CHECK(layoutError("[start]\nposition = [0, 99]\n[goal]\nposition = [1, 1]\n") ==
        "a.toml:2: start.position = [0, 99] is outside -12 ... 12 m");
  CHECK(layoutError(kHead + "heading_deg = 400\n") ==
        "a.toml:5: goal.heading_deg = 400 is outside -360 ... 360 degrees");
  CHECK(layoutError(kHead + "heading = 7\n") ==
        "a.toml:5: goal.heading = 7 is outside -6.28319 ... 6.28319 rad");
}

TEST_CASE("a value of the wrong type is named with what it must be", "[unit]") {
  CHECK(robotError("[robot]\nmass = '1'\n") == "mine.toml:2: robot.mass must be a number, not a string");
  CHECK(robotError("[robot]\nname = 4\n") == "mine.toml:2: robot.name must be a string, not a whole number");
  CHECK(robotError("robot = 4\n") == "mine.toml:1: robot must be a table [robot], not a whole number");
  CHECK(robotError("[[robot]]\n") == "mine.toml:1: robot must be a table [robot], not an array");
  CHECK(layoutError("[start]\nposition = 5\n") ==
        "a.toml:2: start.position must be a point [x, y] of two numbers, not a whole number");
  CHECK(layoutError("[start]\nposition = [1, 2, 3]\n") ==
        "a.toml:2: start.position must be a point [x, y] of two numbers, not an array");
  CHECK(layoutError(kHead + "[obstacle]\n") == "a.toml:5: obstacle must be tables headed [[obstacle]]");
  CHECK(layoutError(kHead + "heading = true\n") == "a.toml:5: goal.heading must be a number, not a boolean");
  const test::ScratchFolder folder;
  const auto physicsError = [&folder](const char* line) {
    const auto physics = loadPhysics(folder.write("p.toml", std::string("[physics]\n") + line + "\n"));
    return physics.error().message.substr(folder.path().string().size() + 1);
  };
  CHECK(physicsError("substeps = 2.5") == "p.toml:2: physics.substeps must be a whole number, not a number");
  CHECK(physicsError("substeps = 9223372036854775807") ==
        "p.toml:2: physics.substeps = 9.223372036854776e+18 is outside 1 ... 64");
  CHECK(physicsError("bullet_ball = 1") ==
        "p.toml:2: physics.bullet_ball must be true or false, not a whole number");
  CHECK(physicsError("control_rate = 1979-05-27") ==
        "p.toml:2: physics.control_rate must be a whole number, not a date or time");
}

TEST_CASE("an unknown key or table is named with a suggestion", "[unit]") {
  CHECK(robotError("[robot]\nname = 'x'\nmas = 1\n") ==
        "mine.toml:3: robot.mas is not a key of [robot]. Did you mean 'mass'?");
  CHECK(robotError("[robot]\n[ball]\nspoon = 1\n") ==
        "mine.toml:3: ball.spoon is not a key of [ball]. Its keys: radius, mass, roll_keep, "
        "slide_deceleration, "
        "roll_deceleration, stop_speed, wall_restitution, wall_spin_keep, robot_restitution, friction.");
  CHECK(robotError("[robto]\nmass = 1\n") ==
        "mine.toml:1: 'robto' is not a table of this file. Did you mean 'robot'?");
  CHECK(robotError("[robot]\n[physics]\n") ==
        "mine.toml:2: 'physics' is not a table of this file. Its tables: robot, ball.");
  CHECK(layoutError("[start]\npositon = [0, 0]\n") ==
        "a.toml:2: start.positon is not a key of [start]. Did you mean 'position'?");
  CHECK(robotError("[robot]\n\"\\u001b[31m\" = 1\n").find('\x1b') == std::string::npos);
}

TEST_CASE("what a file lacks is named", "[unit]") {
  CHECK(robotError("") == "mine.toml:1: the table [robot] is missing");
  CHECK(layoutError("") == "a.toml:1: the table [start] is missing");
  CHECK(layoutError("# layout\n[start]\nheading = 1\n") == "a.toml:2: start.position is missing");
  CHECK(layoutError(kHead + "[[obstacle]]\nradius = 0.1\n") == "a.toml:5: obstacle[0].position is missing");
}

TEST_CASE("a duplicate key or two spellings of one angle are refused", "[unit]") {
  CHECK(robotError("[robot]\nmass = 1\nmass = 1\n").starts_with("mine.toml:3: not valid TOML: "));
  CHECK(layoutError(kHead + "heading = 1\nheading_deg = 10\n") ==
        "a.toml:6: goal.heading_deg and heading are both given");
}

TEST_CASE("values at odds with each other are refused", "[unit]") {
  CHECK(robotError("[robot]\nspin_slow_speed = 0.5\nspin_fast_speed = 0.4\n") ==
        "mine.toml:3: robot.spin_fast_speed = 0.4 must be above spin_slow_speed = 0.5");
  CHECK(robotError("[robot]\nspin_slow_speed = 0.5\n") ==
        "mine.toml:1: robot.spin_fast_speed = 0 must be above spin_slow_speed = 0.5");
  const test::ScratchFolder folder;
  const auto field = loadField(folder.write("f.toml", "[field]\nwidth = 0.5\n"));
  CHECK(field.error().message.ends_with(
      "f.toml:1: field.goal_width = 0.4 must be below the width minus both corners, 0.36"));
}

TEST_CASE("every obstacle is checked and named by its index", "[unit]") {
  // the text that follows begins on line 8
  const std::string one = kHead + "[[obstacle]]\nposition = [0, 0]\n[[obstacle]]\n";
  CHECK(layoutError(one + "shape = 'disk'\nposition = [0, 0]\n") ==
        "a.toml:8: obstacle[1].shape = \"disk\" is not one of disc, box");
  CHECK(layoutError(one + "motion = 3\n") ==
        "a.toml:8: obstacle[1].motion must be a string, not a whole number");
  CHECK(layoutError(one + "motion = 'path'\n") ==
        "a.toml:7: obstacle[1].path needs at least 2 waypoints, has 0");
  CHECK(layoutError(one + "motion = 'path'\npath = [[0, 0], [1, 1]]\nspeed = 0\n") ==
        "a.toml:10: obstacle[1].speed = 0 must be above 0 for an obstacle on a path");
  CHECK(layoutError(one + "motion = 'path'\npath = [[0, 0], [1, 1]]\nposition = [1, 1]\n") ==
        "a.toml:10: obstacle[1].position must be the first waypoint of its path");
  CHECK(layoutError(one + "path = [[0, 0], [1]]\n") ==
        "a.toml:8: obstacle[1].path[1] must be a point [x, y] of two numbers");
  CHECK(layoutError(one + "path = [[0, 0], [1, nan]]\n") ==
        "a.toml:8: obstacle[1].path[1] = [1, nan] is outside -12 ... 12 m");
  CHECK(layoutError(one + "path = 1\n") ==
        "a.toml:8: obstacle[1].path must be an array of points [x, y], not a whole number");
  std::string many = kHead;
  for (int i = 0; i < 501; ++i) many += "[[obstacle]]\nposition = [0, 0]\n";
  CHECK(layoutError(many) ==
        "a.toml:1005: obstacle[500] is one too many: a layout may have at most 500 obstacles");
  std::string longest = "path = [[0, 0]";
  for (int i = 0; i < 1000; ++i) longest += ", [0.5, 0.5]";
  CHECK(layoutError(one + longest + "]\n") ==
        "a.toml:8: obstacle[1].path has 1001 waypoints; at most 1000 are allowed");
}

TEST_CASE("a name that could leave its folder is refused", "[unit]") {
  CHECK(layoutError("[layout]\nname = '../../etc'\n" + kHead) ==
        "a.toml:2: layout.name = \"../../etc\" must not contain slashes or begin with a dot");
  CHECK(
      layoutError("[layout]\nname = \"a\\u0007\"\n" + kHead) ==
      "a.toml:2: layout.name = \"a\\x07\" must have 1 ... 100 characters, none of them a control character");
  CHECK(layoutError("[layout]\nname = ''\n" + kHead).find("1 ... 100 characters") != std::string::npos);
}

TEST_CASE("a layout must fit its field", "[unit]") {
  const test::ScratchFolder folder;
  const auto error = [&folder](const std::string& text) {
    const auto layout = loadLayout(folder.write("a.toml", text));
    REQUIRE_FALSE(layout);
    return Error{layout.error().code, layout.error().message.substr(folder.path().string().size() + 1)};
  };
  CHECK(error(kHead).message == "a.toml:4: goal.position = [1, 1] is outside the field 'vsss-3v3'");
  const Error unknown = error("[layout]\nfield = 'vsss-3v'\n" + kHead);
  CHECK(unknown.code == ErrorCode::kBadInput);
  CHECK(unknown.message ==
        "a.toml:2: layout.field cannot be used: 'vsss-3v' is neither a file nor a preset of fields: "
        "jung-lee-2015, vsss-3v3, vsss-5v5. Did you mean 'vsss-3v3'?");
  const Error missing = error("[layout]\nfield = 'none.toml'\n" + kHead);
  CHECK(missing.code == ErrorCode::kIo);
  CHECK(missing.message == "a.toml:2: layout.field cannot be used: cannot read '" + folder.path().string() +
                               "/none.toml': No such file or directory");
}

}  // namespace fulbito
