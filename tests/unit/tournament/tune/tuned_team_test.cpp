#include "tournament/tune/tuned_team.hpp"

#include <cmath>
#include <cstdlib>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TeamChoice classicOf(const std::string& specification) { return *parseTeam(specification); }

/// A team that declares a whole number, a number and a flag.
TeamChoice declaring() {
  TeamInfo info;
  info.name = "declared";
  using Type = ParameterSpec::Type;
  info.parameters = {{"mates", Type::kInteger, 2.0, 0.0, 4.0, {}, "", ""},
                     {"gain", Type::kNumber, 1.0, 0.0, 10.0, {}, "", ""},
                     {"bold", Type::kFlag, 0.0, 0.0, 1.0, {}, "", ""}};
  return {std::make_shared<const TeamInfo>(std::move(info)), "declared", {}, {}};
}

Result<ParameterChoice> chosen(const TeamChoice& team, const std::vector<std::string>& words) {
  return parametersOf(team, *TunedTeam::of(team), words, 0.1, 0.2);
}

std::string refused(const TeamChoice& team, const std::vector<std::string>& words) {
  const auto choice = chosen(team, words);
  return choice || choice.error().code != ErrorCode::kUsage ? std::string() : choice.error().message;
}

}  // namespace

TEST_CASE("all numbers of a team are tuned from the values of its specification", "[unit]") {
  const auto choice = chosen(classicOf("classic:support=0.8,spin=off"), {});
  REQUIRE(choice);
  REQUIRE(choice->parameters.size() == 3);
  const TunedParameter& support = choice->parameters[1];
  CHECK(support.name == "support");
  CHECK(support.start == 0.8);
  CHECK(support.low == 0.1);
  CHECK(support.high == 1.0);
  CHECK(support.perturbation == 0.1);
  CHECK(support.step == 0.2);
  CHECK(choice->parameters[0].start == 0.1);  // the default
  CHECK(choice->skipped == std::vector<std::string>{"exchange", "spin"});
}

TEST_CASE("the perturbation of a whole number is at least a half", "[unit]") {
  const auto choice = chosen(declaring(), {});
  REQUIRE(choice);
  CHECK(choice->parameters[0].whole);
  CHECK(choice->parameters[0].perturbation == 0.125);  // half of a step in a range of four
  CHECK(choice->parameters[1].perturbation == 0.1);
}

TEST_CASE("words select parameters and replace start, limits and gains", "[unit]") {
  const TeamChoice team = classicOf("classic");
  const auto choice = chosen(team, {"strike_speed=:0.5:2.5", "support=0.4:::0.09:0.5"});
  REQUIRE(choice);
  REQUIRE(choice->parameters.size() == 2);
  CHECK(choice->skipped.empty());
  CHECK(choice->parameters[0].start == 1.2);
  CHECK(choice->parameters[0].low == 0.5);
  CHECK(choice->parameters[0].high == 2.5);
  CHECK(choice->parameters[1].start == 0.4);
  CHECK(choice->parameters[1].perturbation == Approx(0.1));  // 0.09 m of 0.9 m
  CHECK(choice->parameters[1].step == 0.5);
}

TEST_CASE("words that select nothing are refused", "[unit]") {
  const TeamChoice team = classicOf("classic");
  CHECK(contains(refused(team, {"suport"}), "support"));
  CHECK(contains(refused(team, {"spin"}), "'spin'"));
  CHECK(contains(refused(team, {"support=0.4:0:1"}), "0.1 ... 1"));
  CHECK(contains(refused(team, {"support=a"}), "START:LOW:HIGH"));
  CHECK(contains(refused(team, {"support=1:2:3:4:5:6"}), "START:LOW:HIGH"));
  CHECK(contains(refused(classicOf("idle"), {}), "NAME=START:LOW:HIGH"));
  CHECK(contains(refused(classicOf("idle"), {"gain"}), "gain=START:LOW:HIGH"));
}

TEST_CASE("a team that declares nothing is tuned within the given limits", "[unit]") {
  const auto choice = chosen(classicOf("idle"), {"gain=1:0:5", "reach=0.2:0.05:1"});
  REQUIRE(choice);
  CHECK(choice->parameters[0].start == 1.0);
  CHECK(choice->parameters[1].high == 1.0);
}

TEST_CASE("a point becomes a specification: settings change in place, others follow", "[unit]") {
  const TeamChoice team = classicOf("classic:spin=off,support=0.8,navigator=bezier:clearance=0.03");
  const auto parts = TunedTeam::of(team);
  REQUIRE(parts);
  const auto choice = chosen(team, {"strike_speed", "support"});
  REQUIRE(choice);
  const std::string text = parts->at(choice->parameters, {0.0, 0.5});
  CHECK(text == "classic:spin=off,support=0.55,navigator=bezier:clearance=0.03,strike_speed=0.2");
  const auto read = parseTeam(text);
  REQUIRE(read);
  CHECK(read->settings.size() == 4);
}

TEST_CASE("the settings of a command line are its last word", "[unit]") {
  const TeamChoice bare{nullptr, "cmd:/bin/sh team.sh 'one word'", {}, {}};
  const std::vector<TunedParameter> gain{{"gain", false, 1.0, 0.0, 4.0, 0.1, 0.1}};
  CHECK(TunedTeam::of(bare)->at(gain, {0.5}) == "cmd:/bin/sh team.sh 'one word' :gain=2");
  const TeamChoice set{nullptr, "cmd:/bin/sh team.sh :mode=a,gain=1", {}, {}};
  CHECK(TunedTeam::of(set)->at(gain, {0.75}) == "cmd:/bin/sh team.sh :mode=a,gain=3");
  const TeamChoice quoted{nullptr, "cmd:/bin/sh team.sh ':mode=a'", {}, {}};
  CHECK_FALSE(TunedTeam::of(quoted));
}

TEST_CASE("values play as short texts within their limits", "[unit]") {
  const TunedParameter third{"p", false, 0.5, 1.0 / 3.0, 2.0 / 3.0, 0.1, 0.1};
  for (int i = 0; i <= 1000; ++i) {
    const std::string text = valueText(third, i / 1000.0);
    const double value = std::strtod(text.c_str(), nullptr);
    CHECK((value >= third.low && value <= third.high));
    CHECK(std::abs(value - (third.low + (third.high - third.low) * i / 1000.0)) <= 1e-5 / 3.0);
  }
  CHECK(valueText({"p", false, 0.0, 0.0, 2e-6, 0.1, 0.1}, 0.123456) == "0.00000024691");
  CHECK(valueText({"p", false, 0.0, -1e9, 1e9, 0.1, 0.1}, 0.75) == "500000000");
  CHECK(valueText({"p", false, 0.0, -1.0, 1.0, 0.1, 0.1}, 0.5) == "0");
}

TEST_CASE("whole numbers round to the next one", "[unit]") {
  const TunedParameter mates{"p", true, 2.0, -1.0, 3.0, 0.125, 0.1};
  CHECK(valueText(mates, 0.0) == "-1");
  CHECK(valueText(mates, 0.12) == "-1");
  CHECK(valueText(mates, 0.13) == "0");
  CHECK(valueText(mates, 0.26) == "0");
  CHECK(valueText(mates, 0.38) == "1");
  CHECK(valueText(mates, 1.0) == "3");
}

}  // namespace fulbito
