#include "replays/verify/shadow_referee.hpp"

#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

RecordingReader readerOf(const MatchConfig& config) {
  auto reader = RecordingReader::parse(recorded(config, RecordingLevel::kRecipe), "test");
  REQUIRE(reader);
  return std::move(*reader);
}

/// A match in which nobody moves: the ball is stuck in the middle of the field until the rules stop play.
MatchConfig standstill(double half_seconds) {
  static const TestEntry statues([](const Observation&) { return allWheels({}); });
  MatchConfig config = shortMatch("chaser", "chaser", half_seconds);
  config.rules = *loadRules("vsss-3v3");
  config.rules.half_seconds = half_seconds;
  config.teams = {statues.choice(), statues.choice()};
  return config;
}

RulesComparison compared(const RecordingReader& reader, const Rules& a, const Rules& b) {
  RulesComparison comparison;
  REQUIRE(compareRules(reader, a, b, comparison));
  return comparison;
}

const RuleAgreement* find(const std::vector<RuleAgreement>& rules, const std::string& clause) {
  for (const RuleAgreement& rule : rules) {
    if (rule.clause == clause) return &rule;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("a profile against itself agrees on every play, and with what was recorded", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 60.0);
  config.rules = *loadRules("vsss-3v3");
  config.rules.half_seconds = 60.0;
  const RecordingReader reader = readerOf(config);
  const RulesComparison comparison = compared(reader, *loadRules("vsss-3v3"), *loadRules("vsss-3v3"));
  CHECK(comparison.files == 1);
  CHECK(comparison.ticks == reader.ticks());
  REQUIRE(comparison.plays.size() > 3);
  CHECK(countOf(comparison, VerdictAgreement::kSame) == static_cast<std::int64_t>(comparison.plays.size()));
  CHECK(comparison.recorded_a == static_cast<std::int64_t>(comparison.plays.size()));
  CHECK(differentPairs(comparison).empty());
  for (const RuleAgreement& rule : byRule(comparison)) {
    CHECK(rule.same == rule.a);
    CHECK(rule.same == rule.b);
    CHECK(rule.a_earlier + rule.b_earlier + rule.only_a + rule.only_b + rule.different == 0);
  }
}

TEST_CASE("the more patient of two rules is later, or had not called yet", "[unit]") {
  const RecordingReader reader = readerOf(standstill(35.0));
  const Rules rules = *loadRules("vsss-3v3");
  Rules hasty = rules, patient = rules;
  hasty.stuck.seconds = rules.stuck.seconds - 2.5;
  patient.stuck.seconds = rules.stuck.seconds + 2.5;
  const RulesComparison early = compared(reader, rules, hasty);
  const auto early_rules = byRule(early);
  const RuleAgreement* stuck = find(early_rules, "free-ball");
  REQUIRE(stuck != nullptr);
  CHECK(stuck->a > 2);
  CHECK(stuck->b_earlier == stuck->a);
  CHECK(stuck->b_lead == Approx(2.5).margin(0.02));
  CHECK(stuck->a_earlier == 0);
  const auto late_rules = byRule(compared(reader, rules, patient));
  stuck = find(late_rules, "free-ball");
  REQUIRE(stuck != nullptr);
  CHECK(stuck->only_a == stuck->a);
  CHECK(stuck->b == 0);
}

TEST_CASE("exchanging the profiles exchanges the columns", "[unit]") {
  MatchConfig config = shortMatch("libero", "chaser", 60.0);
  config.rules = *loadRules("vsss-3v3");
  config.rules.half_seconds = 60.0;
  const RecordingReader reader = readerOf(config);
  const Rules book = *loadRules("vsss-3v3"), league = *loadRules("league-program-2021");
  const auto there = byRule(compared(reader, book, league)), back = byRule(compared(reader, league, book));
  REQUIRE(there.size() == back.size());
  for (std::size_t i = 0; i < there.size(); ++i) {
    CHECK(there[i].clause == back[i].clause);
    CHECK(there[i].a == back[i].b);
    CHECK(there[i].same == back[i].same);
    CHECK(there[i].only_a == back[i].only_b);
    CHECK(there[i].a_earlier == back[i].b_earlier);
    CHECK(there[i].different == back[i].different);
  }
}

TEST_CASE("halves are as long as in the recording, whatever the profiles say", "[unit]") {
  const RecordingReader reader = readerOf(standstill(7.0));
  Rules longer = *loadRules("vsss-3v3");
  longer.half_seconds = 500.0;
  const auto rules = byRule(compared(reader, *loadRules("vsss-3v3"), longer));
  const RuleAgreement* half = find(rules, "half");
  REQUIRE(half != nullptr);
  CHECK(half->same == 1);
}

TEST_CASE("several recordings add up, and a trial is refused", "[unit]") {
  const RecordingReader reader = readerOf(standstill(7.0));
  const Rules rules = *loadRules("vsss-3v3");
  RulesComparison comparison;
  REQUIRE(compareRules(reader, rules, rules, comparison));
  const std::size_t plays = comparison.plays.size();
  REQUIRE(compareRules(reader, rules, rules, comparison));
  CHECK(comparison.files == 2);
  CHECK(comparison.plays.size() == 2 * plays);
  CHECK(comparison.plays.back().file == 1);
  const double delays = 2.0 * static_cast<double>(plays) * rules.restart.delay;
  CHECK(comparison.seconds == Approx(28.0 + delays));

  RecordingHeader header = reader.header();
  header.kind = RecordingKind::kTrial;
  std::string bytes;
  auto writer = RecordingWriter::create(into(bytes), header);
  REQUIRE(writer);
  REQUIRE(writer->finish({}));
  const auto trial = RecordingReader::parse(bytes, "trial");
  REQUIRE(trial);
  CHECK(compareRules(*trial, rules, rules, comparison).error().code == ErrorCode::kBadInput);
}

TEST_CASE("a play without its ball cannot be judged", "[unit]") {
  const MatchConfig config = standstill(2.0);
  const RecordingHeader header = recordingHeader(config, RecordingLevel::kRecipe);
  std::string bytes;
  auto writer = RecordingWriter::create(into(bytes), header);
  REQUIRE(writer);
  RecordedPlay play;
  play.starts.resize(header.bodies.size());  // all bodies are absent
  writer->beginPlay(play);
  const WorldState empty;
  for (int tick = 0; tick < 5; ++tick) writer->add(RecordingTick{&empty, {}, 0, true});
  REQUIRE(writer->finish({}));
  const auto reader = RecordingReader::parse(bytes, "test");
  REQUIRE(reader);
  RulesComparison comparison;
  const auto judged = compareRules(*reader, *loadRules("vsss-3v3"), *loadRules("training"), comparison);
  REQUIRE_FALSE(judged);
  CHECK(judged.error().code == ErrorCode::kBadInput);
  CHECK(judged.error().message == "there is no ball in play 1");
}

}  // namespace fulbito
