#include "fulbito/strategy.hpp"
#include "strategies/interface/team_info.hpp"
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
  const TeamCatalogue catalogue = TeamCatalogue::builtIn();
  CHECK(catalogue.teams().size() >= 5);
  for (const auto& entry : catalogue.teams()) {
    const TeamInfo& info = *entry;
    CAPTURE(info.name);
    const auto choice = catalogue.parse(info.name);
    REQUIRE(choice);
    CHECK(choice->info == entry);
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

TEST_CASE("a catalogue takes further teams, and each catalogue has its own", "[unit]") {
  struct Slow final : Strategy {
    struct Params {
      double speed = 0.1;
    };
    explicit Slow(Params) {}
    void begin(const MatchInfo&) override {}
    TeamCommand decide(const Observation&) override { return {}; }
  };
  const TeamInfo slow = describeTeam<Slow::Params, Slow>(
      "slow", "hardly moves", {number("speed", &Slow::Params::speed, 0.0, 1.0, "m/s", "of every robot")});
  std::optional<TeamChoice> kept;
  {
    TeamCatalogue catalogue = TeamCatalogue::builtIn();
    REQUIRE(catalogue.add(slow));
    CHECK(catalogue.teams().back()->name == "slow");
    const auto choice = catalogue.parse("slow:speed=0.5");
    REQUIRE(choice);
    CHECK(choice->text == "slow:speed=0.5");
    CHECK_FALSE(catalogue.parse("slow:speed=2"));
    CHECK(contains(catalogue.parse("slwo").error().message, "Did you mean 'slow'?"));
    CHECK(catalogue.parse("libero"));
    CHECK(catalogue.add(slow).error().message == "there is a team 'slow' already");
    CHECK_FALSE(catalogue.add(*parseTeam("libero")->info));
    kept = *choice;
  }
  CHECK(makeTeam(*kept));  // the entry exists longer than the catalogue
  CHECK(contains(errorOf("slow"), "there is no team 'slow'"));
}

TEST_CASE("what cannot be a catalogue's team is refused", "[unit]") {
  TeamCatalogue catalogue;
  TeamInfo info = *parseTeam("idle")->info;
  info.name = "";
  CHECK(catalogue.add(info).error().code == ErrorCode::kUsage);
  info.name = "a:b";
  CHECK(catalogue.add(info).error().message == "'a:b' cannot be a team's name");
  info.name = "a";
  info.make = {};
  CHECK(catalogue.add(info).error().message == "team 'a': nothing makes it");
  CHECK(catalogue.teams().empty());
}

TEST_CASE("wrong specifications are explained", "[unit]") {
  CHECK(contains(errorOf("clasic"), "Did you mean 'classic'?"));
  CHECK(contains(errorOf("classic:suport=0.4"), "Did you mean 'support'?"));
  CHECK(contains(errorOf("classic:support=5"), "from 0.1 to 1 m"));
  CHECK(contains(errorOf("classic:spin=maybe"), "is not true or false"));
  CHECK(contains(errorOf("classic:support"), "name=value"));
  CHECK(contains(errorOf("classic:"), "name=value"));
  CHECK(contains(errorOf("classic:navigator=beziers"), "Did you mean 'bezier'?"));
  CHECK(contains(errorOf("classic:navigator=bezier:clearence=0.1"), "Did you mean 'clearance'?"));
  CHECK(contains(errorOf("classic:navigatr=bezier"), "Did you mean 'navigator'?"));
  CHECK(contains(errorOf("idle:navigator=bezier"), "'idle' has no parameter 'navigator'"));
  CHECK(contains(errorOf(""), "there is no team ''"));
}

}  // namespace fulbito
