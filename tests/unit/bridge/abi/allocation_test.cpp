#include "bridge/abi/abi_codec.hpp"
#include "bridge/abi/library_team.hpp"
#include "bridge/abi/team_host.hpp"
#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/malloc_counter.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

const std::string kChaser = FULBITO_TEST_LIBRARIES "/ported_chaser.so";

}  // namespace

TEST_CASE("a warm match of two teams of shared libraries allocates nothing", "[unit]") {
  auto info = loadTeamLibrary(kChaser);
  REQUIRE(info);
  const TeamChoice team{std::make_shared<const TeamInfo>(std::move(*info)), "chaser", {}, {}};
  MatchConfig config = shortMatch("idle", "idle", 30.0);
  config.teams = {team, team};
  auto match = Match::create(config);
  REQUIRE(match);
  int allocating = 0, warm = 0;
  for (bool more = true; more;) {
    const long before = mallocCount();
    more = match->step();
    const bool restarted = match->world().tick == 0;
    if (match->tick() <= 600 || restarted || !more) continue;
    ++warm;
    if (mallocCount() != before) ++allocating;
  }
  CHECK(allocating == 0);
  CHECK(warm > 1000);
}

TEST_CASE("a warm conversation with a hosted team allocates nothing on either side", "[unit]") {
  const auto library = TeamLibrary::open(kChaser);
  REQUIRE(library);
  TeamHost host(*library, {}, {});
  AbiCodec codec;
  std::string request, answer;
  TeamReply reply;
  codec.hello(1, {}, request);
  REQUIRE(host.answer(request, answer));
  request.clear();
  answer.clear();
  codec.begin(2, {}, request);
  REQUIRE(host.answer(request, answer));
  const Observation seen;
  long before = 0;
  for (std::uint64_t tick = 0; tick < 20; ++tick) {
    if (tick == 10) before = mallocCount();
    request.clear();
    answer.clear();
    codec.decide(tick, seen, request);
    const bool answered = host.answer(request, answer).has_value();
    const bool read = codec.read(answer, reply).has_value();
    if (!answered || !read || reply.id != tick) FAIL("no reply");
  }
  CHECK(mallocCount() == before);
}

}  // namespace fulbito
