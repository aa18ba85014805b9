#include "strategies/teams/libero/playbook/playbook.hpp"

#include <array>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

using libero::PlayBook;

/// The skills in the tables of docs/libero.md. A heading names the role, and a row has the parts of a
/// summary.
std::vector<SkillInfo> skillsOfDocs() {
  static const std::regex heading("### (\\w+): .*"), row(R"(\| `([\w-]+)` \| (.*) \| (.*) \|)");
  std::ifstream page(FULBITO_SOURCE_DIR "/docs/libero.md");
  std::vector<SkillInfo> found;
  std::string role;
  for (std::string line; std::getline(page, line);) {
    std::smatch match;
    if (std::regex_match(line, match, heading)) role = match[1];
    if (line.starts_with("## ")) role.clear();
    if (!role.empty() && std::regex_match(line, match, row))
      found.push_back({role, match[1], match[2].str() + ": " + match[3].str()});
  }
  return found;
}

std::string errorOf(const std::string& left_out) {
  const auto choice = parseTeam("libero:without=" + left_out);
  return choice ? "" : choice.error().message;
}

}  // namespace

TEST_CASE("libero's tables of skills are those of docs/libero.md", "[unit]") {
  const std::vector<SkillInfo> skills = PlayBook::skills(), docs = skillsOfDocs();
  REQUIRE(skills.size() == docs.size());
  for (std::size_t i = 0; i < skills.size(); ++i) {
    CHECK(skills[i].role == docs[i].role);
    CHECK(skills[i].name == docs[i].name);
    CHECK(skills[i].summary == docs[i].summary);
  }
}

TEST_CASE("libero's entry in the catalogue has its skills, each name once per role", "[unit]") {
  const auto team = parseTeam("libero");
  REQUIRE(team);
  CHECK(team->info->skills.size() == PlayBook::skills().size());
  std::set<std::string> names;
  for (const SkillInfo& skill : team->info->skills) {
    CHECK(names.insert(skill.role + "/" + skill.name).second);
    CHECK(skill.name.find_first_of("+,: ") == std::string::npos);
  }
}

TEST_CASE("libero plays without any of its skills, and without all that may be left out", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  std::string all;
  std::set<std::string> played;
  std::vector<std::string> left_out;
  for (const SkillInfo& skill : PlayBook::skills()) {
    if (!errorOf(skill.name).empty()) continue;
    left_out.push_back(skill.name);
    all += (all.empty() ? "" : "+") + skill.name;
  }
  left_out.push_back(all);
  CHECK(left_out.size() + 3 == PlayBook::skills().size() + 1);
  for (const std::string& names : left_out) {
    auto team = makeTeam(*parseTeam("libero:without=" + names));
    REQUIRE(team);
    (*team)->begin(info);
    Rng rng(3, test::kTestStream);
    for (int i = 0; i < 500; ++i) {
      Observation seen = test::anything(rng, info);
      seen.wants_drawings = true;
      for (const DebugDrawing& drawing : (*team)->decide(seen).drawings) {
        if (drawing.kind != DebugDrawing::Kind::kText) continue;
        CAPTURE(names, drawing.text);
        CHECK_FALSE(drawing.text.ends_with(": " + names));
        if (names == all && drawing.text.find(": ") != std::string::npos) played.insert(drawing.text);
      }
    }
  }
  CHECK(played == std::set<std::string>{"keeper: stand-in-goal", "striker: strike", "support: shadow"});
}

TEST_CASE("libero's parameter without names what is wrong with it", "[unit]") {
  CHECK(errorOf("race+squeeze").empty());
  CHECK(errorOf("rce").find("'rce'. Did you mean 'race'? It must be one of free-ball, ") !=
        std::string::npos);
  CHECK(errorOf("race+").find("there is no skill ''") != std::string::npos);
  for (const char* last : {"strike", "shadow", "stand-in-goal"}) {
    CHECK(errorOf(last).find("needs this skill") != std::string::npos);
  }
}

TEST_CASE("every skill of libero that answers says why", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const auto team = test::liberoIn(info);
  Rng rng(4, test::kTestStream);
  std::set<std::string> played;
  for (int i = 0; i < 20'000; ++i) {
    Observation seen = test::anything(rng, info);
    seen.wants_drawings = true;
    for (const DebugDrawing& drawing : team->decide(seen).drawings) {
      if (drawing.kind != DebugDrawing::Kind::kText) continue;
      static const std::regex name(R"(\w+: [\w-]+)"), reason("[\\w' ]+");
      CAPTURE(drawing.text);
      const bool names = std::regex_match(drawing.text, name);
      if (names) played.insert(drawing.text);
      CHECK((names || std::regex_match(drawing.text, reason)));
    }
  }
  // All but the last four are for robots that cannot shove, or for large matches. Random pictures hardly
  // have the duels and stalls of these four.
  const std::set<std::string> others{"follow-through", "volley",  "spin-on", "spin",     "hold",
                                     "outlet",         "squeeze", "ram",     "withdraw", "spin-out"};
  for (const SkillInfo& skill : PlayBook::skills()) {
    CAPTURE(skill.role, skill.name);
    CHECK((others.contains(skill.name) || played.contains(skill.role + ": " + skill.name)));
  }
}

}  // namespace fulbito
