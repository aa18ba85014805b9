// Plays matches of all pairings of the built-in teams and looks after every control tick how deep bodies are
// in each other, with a geometry of its own.
//
//   contact_depths [MATCHES] [PHYSICS] [ROBOT] [RULES] [HALF_SECONDS] [SEED]
//
// Prints the deepest of each pairing. Exit code 0: ball in robot at most 2 mm, and robot in robot at most 5
// mm (on `fast` only printed); 1: deeper.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "fulbito/match.hpp"
#include "tests/support/outlines.hpp"

namespace {

using namespace fulbito;

constexpr double kBallDepth = 0.002;   // [m]
constexpr double kRobotDepth = 0.005;  // [m]

template <typename T>
T get(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "contact_depths: %s\n", result.error().message.c_str());
  std::exit(2);
}

class DepthWatch : public MatchObserver {
 public:
  explicit DepthWatch(const RobotPreset& preset) : preset_(preset) {}
  void onTick(const MatchTick& tick) override {
    depths.look(preset_.robot, preset_.ball.radius, *tick.world);
  }
  test::Depths depths;

 private:
  RobotPreset preset_;
};

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, const char* otherwise) {
    return std::string(argc > i ? argv[i] : otherwise);
  };
  MatchConfig config;
  const int matches = std::atoi(argument(1, "1").c_str());
  config.physics = get(loadPhysics(argument(2, "standard")));
  config.robot = get(loadRobot(argument(3, "vsss")));
  config.rules = get(loadRules(argument(4, "vsss-3v3")));
  config.field = get(loadField(config.rules.field));
  config.rules.half_seconds = std::atof(argument(5, "300").c_str());
  const auto seed = static_cast<std::uint64_t>(std::atoll(argument(6, "1").c_str()));

  const std::vector<std::string> teams{"libero", "classic", "chaser", "random"};
  bool good = true;
  for (std::size_t i = 0; i < teams.size(); ++i) {
    for (std::size_t k = i; k < teams.size(); ++k) {
      DepthWatch watch(config.robot);
      for (int m = 0; m < matches; ++m) {
        config.teams = {get(parseTeam(teams[i])), get(parseTeam(teams[k]))};
        config.seed = seed + static_cast<std::uint64_t>(m);
        auto match = get(Match::create(config));
        match.watch(watch);
        while (match.step()) {
        }
      }
      std::printf("%-8s %-8s ball in robot %5.2f mm, robot in robot %5.2f mm\n", teams[i].c_str(),
                  teams[k].c_str(), 1e3 * watch.depths.ball, 1e3 * watch.depths.robot);
      std::fflush(stdout);
      good &= watch.depths.ball <= kBallDepth;
      good &= config.physics.name == "fast" || watch.depths.robot <= kRobotDepth;
    }
  }
  return good ? 0 : 1;
}
