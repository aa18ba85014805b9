#include "tournament/identity/identity.hpp"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tournament/identity/built_sources.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

Entrant builtIn(const std::string& specification) {
  const auto team = parseTeam(specification);
  REQUIRE(team);
  return {specification, *team, {}};
}

/// An entrant that is a file or program. It need not run, because only its files are read.
Entrant outside(const std::string& specification, std::vector<std::string> files = {}) {
  TeamInfo info;
  info.name = specification;
  info.outside = true;
  const TeamChoice team{std::make_shared<const TeamInfo>(std::move(info)), specification, {}, {}};
  return {specification, team, std::move(files)};
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::string hashOf(const Entrant& entrant) {
  const auto identity = identityOf(entrant);
  INFO((identity ? "" : identity.error().message));
  REQUIRE(identity);
  CHECK(identity->hash.size() == 32);
  return identity->hash;
}

TournamentPlan planOf(const std::vector<std::string>& teams) {
  TournamentPlan plan;
  const auto match = MatchConfig::standard("idle", "idle");
  REQUIRE(match);
  plan.match = *match;
  for (const std::string& team : teams) plan.entrants.push_back(builtIn(team));
  return plan;
}

MatchId idOf(const TournamentPlan& plan, const Fixture& fixture = {0, 1, 0, 0}, std::size_t leg = 0) {
  const auto identity = MatchIdentity::create(plan);
  REQUIRE(identity);
  return identity->of(fixture, leg);
}

}  // namespace

TEST_CASE("of a team that plays elsewhere only the specification is known, and no result is used again",
          "[unit]") {
  const auto identity = identityOf(outside("wire:yellow@10002"));
  REQUIRE(identity);
  CHECK(identity->outside);
  CHECK_FALSE(identity->deterministic);
  CHECK(identity->covers == "its specification only");
  CHECK(identity->hash == hashOf(outside("wire:yellow@10002")));
  CHECK(identity->hash != hashOf(outside("wire:blue@10002")));
}

TEST_CASE("every built-in team has the hash of its sources", "[unit]") {
  std::set<std::string> hashes;
  for (const auto& info : TeamCatalogue::builtIn().teams()) {
    INFO(info->name);
    const auto identity = identityOf(builtIn(info->name));
    REQUIRE(identity);
    CHECK(identity->covers == "built-in sources");
    CHECK(identity->deterministic);
    CHECK_FALSE(identity->outside);
    hashes.insert(identity->hash);
  }
  CHECK(hashes.size() == TeamCatalogue::builtIn().teams().size());
  for (const char* group : {"engine", "outside", "simple", "classic", "libero", "sparring"}) {
    CHECK(sourcesOf(group).size() == 32);
  }
  CHECK(sourcesOf("none").empty());
  CHECK(engineIdentity().size() == 32);
}

TEST_CASE("parameters belong to a team", "[unit]") {
  CHECK(hashOf(builtIn("classic")) == hashOf(builtIn("classic")));
  CHECK(hashOf(builtIn("classic")) != hashOf(builtIn("classic:navigator=bezier")));
  CHECK(hashOf(builtIn("random:memory=0.5")) != hashOf(builtIn("random:memory=0.6")));
}

TEST_CASE("a shared library counts by content, name and settings, not by its folder", "[unit]") {
  const test::ScratchFolder scratch;
  const fs::path a = scratch.path() / "a/team.so", b = scratch.path() / "b c/team.so";
  write(a, "code");
  write(b, "code");
  CHECK(hashOf(outside(a.string())) == hashOf(outside(b.string())));
  CHECK(hashOf(outside(a.string())) != hashOf(outside(a.string() + ":speed=1")));
  const auto identity = identityOf(outside(a.string()));
  CHECK(identity->outside);
  CHECK(identity->covers == "1 file: team.so");
  write(b, "cod3");
  CHECK(hashOf(outside(a.string())) != hashOf(outside(b.string())));
}

TEST_CASE("a program counts by its files and words", "[unit]") {
  const test::ScratchFolder scratch;
  const std::string team = (scratch.path() / "team.py").string(), data = (scratch.path() / "d.bin").string();
  write(team, "print()");
  write(data, "1");
  const std::string command = "cmd:python3 '" + team + "'";
  const std::string before = hashOf(outside(command));
  CHECK(identityOf(outside(command))->covers == "1 file: team.py");
  CHECK(hashOf(outside(command + " '" + data + "'")) != before);
  CHECK(hashOf(outside(command + " fast")) != before);
  CHECK(hashOf(outside(command + " :x=1")) != before);
  CHECK(hashOf(outside(command, {data})) != before);
  const std::string with_data = hashOf(outside(command, {data}));
  write(data, "2");
  CHECK(hashOf(outside(command, {data})) != with_data);
  CHECK(hashOf(outside(command)) == before);
  write(team, "pass");
  CHECK(hashOf(outside(command)) != before);
}

TEST_CASE("an interpreter counts by its name, a team's own program by its content", "[unit]") {
  const test::ScratchFolder scratch;
  const fs::path own = scratch.path() / "team";
  const auto make = [&](const std::string& text) {
    write(own, text);
    fs::permissions(own, fs::perms::owner_all);
  };
  make("#!/bin/sh\n");
  const std::string before = hashOf(outside("cmd:'" + own.string() + "'"));
  make("#!/bin/sh\n\n");
  CHECK(hashOf(outside("cmd:'" + own.string() + "'")) != before);
  CHECK(hashOf(outside("cmd:sh -c true")) == hashOf(outside("cmd:/bin/sh -c true")));
  CHECK(identityOf(outside("cmd:sh -c true"))->covers == "its command line only");
}

TEST_CASE("team.toml declares files, a version and chance", "[unit]") {
  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
  write(folder / "team.py", "import brain");
  write(folder / "brain.py", "x = 1");
  write(folder / "weights/deep/w.bin", "12");
  write(folder / "notes.txt", "hello");
  write(folder / "__pycache__/brain.pyc", "stale");
  const Entrant team = outside("cmd:python3 '" + (folder / "team.py").string() + "'");
  const std::string alone = hashOf(team);
  write(folder / "team.toml", "name = \"x\"\nfiles = [\"*.py\", \"weights/**\"]\n");
  const std::string declared = hashOf(team);
  CHECK(declared != alone);
  CHECK(identityOf(team)->covers == "3 files: brain.py, team.py, weights/deep/w.bin");

  const auto changes = [&](const char* file, const char* text) {
    const std::string before = hashOf(team);
    write(folder / file, text);
    return hashOf(team) != before;
  };
  CHECK(changes("brain.py", "x = 2"));
  CHECK(changes("weights/deep/w.bin", "13"));
  CHECK(changes("weights/new.bin", "0"));
  CHECK_FALSE(changes("notes.txt", "bye"));
  CHECK_FALSE(changes("__pycache__/brain.pyc", "new"));
  CHECK_FALSE(changes("team.toml", "name = \"other\"\nfiles = [\"*.py\", \"weights/**\"]\n"));
  CHECK(changes("team.toml", "version = \"2\"\nfiles = [\"*.py\", \"weights/**\"]\n"));
  CHECK(identityOf(team)->deterministic);
  write(folder / "team.toml", "deterministic = false\n");
  CHECK_FALSE(identityOf(team)->deterministic);
}

TEST_CASE("a navigator from a library counts by its content", "[unit]") {
  const test::ScratchFolder scratch;
  const std::string library = (scratch.path() / "mine.so").string();
  write(library, "one");
  Entrant team = builtIn("classic");
  team.team.settings.push_back({"navigator", library + ":mine:gain=2"});
  const std::string before = hashOf(team);
  team.team.settings.back().value = library + ":mine:gain=3";
  CHECK(hashOf(team) != before);
  team.team.settings.back().value = library + ":mine:gain=2";
  CHECK(hashOf(team) == before);
  write(library, "two");
  CHECK(hashOf(team) != before);
}

TEST_CASE("what is wrong with a team names the file", "[unit]") {
  const test::ScratchFolder scratch;
  const fs::path folder = scratch.path();
  write(folder / "team.py", "");
  const Entrant team = outside("cmd:python3 '" + (folder / "team.py").string() + "'");
  const auto errorOf = [](const Entrant& entrant) {
    const auto identity = identityOf(entrant);
    REQUIRE_FALSE(identity);
    return identity.error();
  };
  CHECK(errorOf(outside("./nowhere.so")).message.find("nowhere.so") != std::string::npos);
  CHECK(errorOf(outside("cmd:python3 x", {"gone.bin"})).code == ErrorCode::kIo);
  CHECK(errorOf(outside("cmd:python3 x", {"gone.bin"})).message.find("gone.bin") != std::string::npos);
  CHECK(errorOf(outside("cmd:python3 x", {folder.string()})).code == ErrorCode::kIo);
  const std::string file = (folder / "team.toml").string();
  const auto flawOf = [&](const char* text) {
    write(file, text);
    const Error error = errorOf(team);
    CHECK(error.code == ErrorCode::kBadInput);
    CHECK(error.message.starts_with(file + ":"));
    return error.message.substr(file.size());
  };
  CHECK(flawOf("file = []") == ":1: unknown key 'file'. Did you mean 'files'?");
  CHECK(flawOf("\nfiles = \"*.py\"") == ":2: files must be a list of strings, not a string");
  CHECK(flawOf("files = [1]") == ":1: files[0] must be a string, not a whole number");
  CHECK(flawOf("deterministic = 0") == ":1: deterministic must be true or false, not a whole number");
  CHECK(flawOf("files = [\"*.bin\"]") == ": files: there is no file '*.bin'");
  CHECK(flawOf("files = [\"../*\"]") == ": files: '../*' is outside the team's folder");
  CHECK(flawOf("files = [\"/etc/*\"]") == ": files: '/etc/*' is outside the team's folder");
  CHECK(flawOf("files = [") != "");
  Entrant own;
  own.team = TeamChoice::own("mine", [] { return std::unique_ptr<Strategy>(); });
  CHECK(errorOf(own).code == ErrorCode::kUsage);
  CHECK(errorOf(Entrant{}).code == ErrorCode::kUsage);
}

TEST_CASE("the identity of a match covers what determines it", "[unit]") {
  const TournamentPlan plan = planOf({"chaser", "random", "idle"});
  const MatchId id = idOf(plan);
  std::set<MatchId> ids{id};
  const auto differs = [&](auto change) {
    TournamentPlan changed = plan;
    change(changed);
    return ids.insert(idOf(changed)).second;
  };
  CHECK(differs([](auto& p) { p.match.rules.half_seconds += 1e-9; }));
  CHECK(differs([](auto& p) { p.match.rules.team_size = 2; }));
  CHECK(differs([](auto& p) { p.match.field.length += 1e-12; }));
  CHECK(differs([](auto& p) { p.match.robot.robot.mass += 1e-12; }));
  CHECK(differs([](auto& p) { p.match.robot.ball.mass += 1e-12; }));
  CHECK(differs([](auto& p) { p.match.physics.control_rate = 120; }));
  CHECK(differs([](auto& p) { p.match.placement_error.position = 0; }));
  CHECK(differs([](auto& p) { p.match.placement_error.heading = 0; }));
  CHECK(differs([](auto& p) { p.match.vision[0].latency_ticks = 1; }));
  CHECK(differs([](auto& p) { p.match.vision[1].latency_ticks = 1; }));
  CHECK(differs([](auto& p) { p.match.vision[0].position_noise = 0.001; }));
  CHECK(differs([](auto& p) { p.match.decision_time = DecisionTime{}; }));
  CHECK(differs([](auto& p) { p.match.present[1] = false; }));
  CHECK(differs([](auto& p) { p.match.start = Placement{}; }));
  CHECK(differs([](auto& p) { p.match.opening = RestartCall{}; }));
  CHECK(differs([](auto& p) { p.match.scoreboard.score[1] = 1; }));
  CHECK(differs([](auto& p) { p.match.scoreboard.play_seconds = 1; }));
  CHECK(differs([](auto& p) { p.seed = 2; }));
  CHECK(differs([](auto& p) { p.book.kinds = {StartKind::kPlay}; }));
  CHECK(differs([](auto& p) { p.book = {{StartKind::kPlay}, 2}; }));
  CHECK(differs([](auto& p) { p.entrants[1] = builtIn("random:memory=1"); }));
  CHECK(ids.insert(idOf(plan, {0, 1, 0, 0}, 1)).second);
  CHECK(ids.insert(idOf(plan, {0, 1, 0, 1})).second);
  CHECK(ids.insert(idOf(plan, {0, 2, 0, 0})).second);
}

TEST_CASE("the identity of a match leaves out names, places in the schedule and other matches", "[unit]") {
  const TournamentPlan plan = planOf({"chaser", "random"});
  const MatchId id = idOf(plan);
  TournamentPlan other = planOf({"chaser", "random", "idle"});
  other.name = "cup";
  other.pairs = 7;
  other.format = TournamentFormat::kGauntlet;
  other.entrants[0].name = "renamed";
  other.match.rules.field = "/somewhere/vsss-3v3.toml";
  other.match.seed = 99;
  CHECK(idOf(other) == id);
  CHECK(idOf(other, {0, 1, 3, 0}) == id);
  // The same kick-off in a book with more kinds of starts.
  other.book = {{StartKind::kKickOff, StartKind::kPenalty}, 5};
  CHECK(idOf(other) == id);
  // B against A in the first leg is the same match as A against B in the second leg.
  CHECK(idOf(plan, {1, 0, 0, 0}, 0) == idOf(plan, {0, 1, 0, 0}, 1));
}

TEST_CASE("vision belongs to the team: the legs of equal teams with unequal vision differ", "[unit]") {
  TournamentPlan plan = planOf({"chaser", "chaser"});
  CHECK(idOf(plan, {0, 1, 0, 0}, 0) == idOf(plan, {0, 1, 0, 0}, 1));
  plan.match.vision[0].latency_ticks = 3;
  CHECK(idOf(plan, {0, 1, 0, 0}, 0) != idOf(plan, {0, 1, 0, 0}, 1));
}

TEST_CASE("two matches of a team that varies are two samples", "[unit]") {
  const test::ScratchFolder scratch;
  write(scratch.path() / "team.py", "");
  TournamentPlan plan = planOf({"chaser", "chaser"});
  const Entrant varying = outside("cmd:python3 '" + (scratch.path() / "team.py").string() + "'");
  plan.entrants = {varying, varying};
  CHECK(idOf(plan, {0, 1, 0, 0}, 0) == idOf(plan, {0, 1, 0, 0}, 1));
  write(scratch.path() / "team.toml", "deterministic = false");
  CHECK(idOf(plan, {0, 1, 0, 0}, 0) != idOf(plan, {0, 1, 0, 0}, 1));
}

TEST_CASE("100,000 identities take less than 0.1 s and differ", "[unit]") {
  const auto identity = MatchIdentity::create(planOf({"classic", "libero"}));
  REQUIRE(identity);
  std::vector<MatchId> ids;
  ids.reserve(100000);
  const std::clock_t begun = std::clock();  // CPU time, because other processes may use the processor too
  for (std::size_t i = 0; i < 50000; ++i) {
    for (const std::size_t leg : {0U, 1U}) ids.push_back(identity->of({0, 1, 0, i}, leg));
  }
  const double taken = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  CHECK(std::set<MatchId>(ids.begin(), ids.end()).size() == ids.size());
  INFO(taken << " s");
#ifdef NDEBUG
  CHECK(taken < 0.1);
#endif
}

}  // namespace fulbito
