#include "bridge/lines/line_codec.hpp"
#include "fulbito/team_program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/malloc_counter.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr std::string_view kReply =
    R"({"type":"decide","id":7,"robots":[{"left":1.5,"right":-2.25},{"linear":0.5,"angular":1e-3},)"
    R"({"go_to":{"x":0.1,"y":0.2,"heading":1.0}}],"roles":[1,2,3],"drawings":[{"line":[0,0,1,1]},)"
    R"({"text":[0,0,"words that are too long for a string without memory of its own"]}]})"
    "\n";

/// A team that allocates nothing.
class Still final : public team::Team {
 public:
  Still() : Team("still") {}
  team::Commands decide(const team::Observation&) override { return {}; }
};

}  // namespace

TEST_CASE("a warm codec writes observations and reads commands without allocating", "[unit]") {
  LineCodec codec;
  TeamReply reply;
  std::string out;
  Observation seen;
  seen.own.fill({true, {}});
  seen.opponents.fill({true, {}});
  seen.team_size = kMaxTeamSize;
  const auto tick = [&](double x) {
    seen.ball.position = {x, -x};
    out.clear();
    codec.decide(7, seen, out);
    REQUIRE(codec.read(kReply, reply));
  };
  tick(1.0 / 3.0);
  const long before = mallocCount();
  for (int i = 0; i < 100; ++i) tick(0.5 + i);
  CHECK(mallocCount() == before);
  CHECK(reply.command.drawings.size() == 2);
}

TEST_CASE("a warm C++ program answers without allocating", "[unit]") {
  LineCodec codec;
  std::string line, answer;
  codec.decide(7, Observation{}, line);
  team::program::Conversation conversation(std::make_unique<Still>());
  const auto tick = [&] {
    answer.clear();
    conversation.take(line, answer);
  };
  tick();
  const long before = mallocCount();
  for (int i = 0; i < 100; ++i) tick();
  CHECK(mallocCount() == before);
  CHECK(answer.starts_with(R"({"type":"decide","id":7,"robots":[)"));
}

}  // namespace fulbito
