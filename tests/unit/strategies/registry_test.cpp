#include "strategies/registry.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

std::string errorOf(const std::string& specification) {
  const auto choice = parseTeam(specification);
  return choice ? "" : choice.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("every team can be made and says what it takes", "[unit]") {
  CHECK(teams().size() >= 5);
  for (const TeamInfo& info : teams()) {
    CAPTURE(info.name);
    const auto choice = parseTeam(info.name);
    REQUIRE(choice);
    CHECK(choice->info == &info);
    CHECK(makeTeam(*choice));
    CHECK_FALSE(info.summary.empty());
    CHECK(info.takes_navigator == !info.default_navigator.empty());
    for (const ParameterSpec& spec : info.parameters) {
      CHECK_FALSE(spec.doc.empty());
      if (spec.type == ParameterSpec::Type::kChoice || spec.type == ParameterSpec::Type::kFlag) continue;
      const std::string start = info.name + ":" + spec.name + "=";
      CHECK(parseTeam(start + std::to_string(spec.default_value)));
      CHECK(contains(errorOf(start + std::to_string(spec.maximum + 1.0)), spec.name));
      CHECK(contains(errorOf(start + "many"), spec.name));
    }
  }
}

TEST_CASE("a team's navigator takes parameters of its own", "[unit]") {
  const auto choice = parseTeam("classic:navigator=bezier:clearance=0.03+follower=classic,support=0.4");
  REQUIRE(choice);
  const auto team = makeTeam(*choice);
  REQUIRE(team);
  const auto navigators = (*team)->navigators();
  REQUIRE(navigators.size() == 1);
  CHECK(navigators[0].info->name == "bezier");
  CHECK(navigators[0].classic_follower);
  REQUIRE(navigators[0].settings.size() == 1);
  CHECK(navigators[0].settings[0].value == "0.03");
}

TEST_CASE("wrong specifications are explained", "[unit]") {
  CHECK(contains(errorOf("clasic"), "Did you mean 'classic'?"));
  CHECK(contains(errorOf("classic:suport=0.4"), "Did you mean 'support'?"));
  CHECK(contains(errorOf("classic:support=5"), "from 0.1 to 1 m"));
  CHECK(contains(errorOf("classic:spin=maybe"), "neither true nor false"));
  CHECK(contains(errorOf("classic:support"), "name=value"));
  CHECK(contains(errorOf("classic:"), "name=value"));
  CHECK(contains(errorOf("classic:navigator=beziers"), "Did you mean 'bezier'?"));
  CHECK(contains(errorOf("classic:navigator=bezier:clearence=0.1"), "Did you mean 'clearance'?"));
  CHECK(contains(errorOf("classic:navigatr=bezier"), "Did you mean 'navigator'?"));
  CHECK(contains(errorOf("idle:navigator=bezier"), "'idle' has no parameter 'navigator'"));
  CHECK(contains(errorOf(""), "there is no team ''"));
}

}  // namespace fulbito
