#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sys/resource.h>

#include "bridge/lines/line_codec.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/piped_team.hpp"
#include "tests/support/test_teams.hpp"
#include "tests/unit/bridge/lines/port_commands.hpp"

/// Figures, not checks: they run with `lines_test "[speed]"` only.
namespace fulbito {
namespace {

using namespace fulbito::test;
using Now = std::chrono::steady_clock;

/// [us] of processor time per call, which the load of the machine hardly changes.
template <typename Call>
double microsecondsOf(std::size_t count, Call call) {
  const std::clock_t from = std::clock();
  for (std::size_t i = 0; i < count; ++i) call(i);
  return 1e6 * static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC / static_cast<double>(count);
}

double microseconds(Now::duration time, std::size_t count) {
  return std::chrono::duration<double, std::micro>(time).count() / static_cast<double>(count);
}

/// [us] of processor time of the programs that have ended.
double childrensMicroseconds() {
  rusage use{};
  ::getrusage(RUSAGE_CHILDREN, &use);
  const auto of = [](const timeval& t) {
    return 1e6 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec);
  };
  return of(use.ru_utime) + of(use.ru_stime);
}

/// What both teams see in a match of the built-in chaser.
struct Seen {
  MatchInfo info;
  std::vector<Observation> ticks;
};

/// A team that keeps what another one sees.
class Listener final : public Strategy {
 public:
  explicit Listener(Seen& into) : into_(&into), team_(*makeTeam(*parseTeam("chaser"))) {}
  void begin(const MatchInfo& info) override {
    into_->info = info;
    team_->begin(info);
  }
  TeamCommand decide(const Observation& seen) override {
    into_->ticks.push_back(seen);
    return team_->decide(seen);
  }

 private:
  Seen* into_;
  std::unique_ptr<Strategy> team_;
};

PerTeam<Seen> matchAsSeen(double& microseconds_per_tick) {
  PerTeam<Seen> seen;
  MatchConfig config = shortMatch("chaser", "chaser", 60.0);
  for (std::size_t i : {0, 1}) {
    config.teams[i] = TeamChoice::own("listener", [&seen, i] { return std::make_unique<Listener>(seen[i]); });
  }
  const auto from = Now::now();
  hashOf(config);
  microseconds_per_tick = microseconds(Now::now() - from, seen[0].ticks.size());
  return seen;
}

/// One program, asked without waiting for its answer.
struct Asked {
  explicit Asked(const std::vector<std::string>& command) : program(command) {}

  void send() const { program.send(out); }
  void take() {
    received.clear();
    while (*codec.firstMessage(received) == 0) REQUIRE(program.receive(received));
    REQUIRE(codec.read(received, reply));
  }

  PipedProgram program;
  LineCodec codec;
  std::string out, received;
  TeamReply reply;
};

}  // namespace

TEST_CASE("time per tick of two programs that are asked at the same time", "[.][speed]") {
  double match = 0.0;
  const PerTeam<Seen> seen = matchAsSeen(match);
  for (const std::vector<std::string>& command : ports()) {
    std::array<Asked, 2> teams{Asked(command), Asked(command)};
    for (std::size_t i : {0, 1}) {
      teams[i].codec.begin(1, seen[i].info, teams[i].out);
      teams[i].send();
      teams[i].take();
    }
    std::size_t ticks = 0;
    const std::clock_t used = std::clock();
    const auto from = Now::now();
    while (ticks < 36000) {
      for (std::size_t i : {0, 1}) {
        teams[i].out.clear();
        teams[i].codec.decide(ticks, seen[i].ticks[ticks % seen[i].ticks.size()], teams[i].out);
        teams[i].send();
      }
      for (Asked& team : teams) team.take();
      ++ticks;
    }
    const double each = microseconds(Now::now() - from, ticks);
    const double own = 1e6 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / 36000.0;
    const double before = childrensMicroseconds();
    for (Asked& team : teams) CHECK(team.program.finish() == 0);
    const double theirs = (childrensMicroseconds() - before) / 36000.0 / 2.0;
    std::printf(
        "%s: %.1f us per tick for both teams, %.1f us for the rest of a match: %.0f times real time\n",
        command.back().c_str(), each, match, 1e6 / 60.0 / (each + match));
    std::printf("  processor time per tick: %.1f us here, %.1f us in each program, its start included\n", own,
                theirs);
  }
}

TEST_CASE("time to write an observation and to read a command", "[.][speed]") {
  double match = 0.0;
  const PerTeam<Seen> seen = matchAsSeen(match);
  const auto& ticks = seen[0].ticks;
  LineCodec codec;
  std::string out;
  std::size_t bytes = 0;
  const double write = microsecondsOf(ticks.size(), [&](std::size_t i) {
    out.clear();
    codec.decide(1, ticks[i], out);
    bytes += out.size();
  });
  std::printf("observation: %.2f us, %zu bytes\n", write, bytes / ticks.size());
  const std::string command =
      R"({"type":"decide","id":35999,"robots":[{"linear":-0.7612345678901234,"angular":-3.1234567890123456},)"
      R"({"linear":1.0612345678901234,"angular":0.0012345678901234567},)"
      R"({"linear":0.25612345678901234,"angular":12.123456789012345}]})"
      "\n";
  TeamReply reply;
  const double read = microsecondsOf(ticks.size(), [&](std::size_t) {
    if (!codec.read(command, reply)) std::abort();
  });
  std::printf("command: %.2f us, %zu bytes\n", read, command.size());
}

}  // namespace fulbito
