#include "fulbito/detail/sonar_model.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

std::string messageOf(const SonarModel& model) {
  const auto checked = validate(model);
  return checked ? "" : checked.error().message;
}

}  // namespace

TEST_CASE("a sonar model with defaults is valid", "[unit]") {
  SonarModel model;
  model.sonars.resize(8);
  CHECK(messageOf(model).empty());
}

TEST_CASE("each number outside its range is named with its sonar and range", "[unit]") {
  SonarModel model;
  model.sonars.resize(3);
  model.sonars[2].half_cone = 1.6;
  CHECK(messageOf(model) == "sonar 2: half cone: 1.6 is outside 0 ... 1.57 rad");
  model.sonars[2] = {};
  model.sonars[1].least = 2.0;
  CHECK(messageOf(model) == "sonar 1: least range: 2 is outside 0 ... 1 m");
  model.sonars[1] = {};
  model.dropout = 1.5;
  CHECK(messageOf(model) == "dropout: 1.5 is outside 0 ... 1");
  model.dropout = 0.0;
  model.noise = -0.1;
  CHECK(messageOf(model) == "noise: -0.1 is outside 0 ... 1 m");
  model.noise = 0.0;
  model.cross_talk = std::nan("");
  CHECK(messageOf(model).starts_with("cross-talk: nan is outside"));
}
