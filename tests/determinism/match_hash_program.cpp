// Plays a short match of every built-in team against the next in the list, in both formats and once with
// imperfect vision. Prints a hash over all states and a hash over the referee's events of each.
#include <cinttypes>
#include <cstdio>
#include <string>

#include "fulbito/detail/state_hash.hpp"
#include "fulbito/match.hpp"

namespace {

using namespace fulbito;

constexpr double kHalfSeconds = 10.0;

class EventHash final : public MatchObserver {
 public:
  void onPlayStart(const PlayStart& start) override {
    hash_.add(static_cast<std::uint64_t>(start.tick));
    hash_.add(std::string_view(nameOf(start.call.kind)));
    addAll(start.events);
  }
  void onTick(const MatchTick& tick) override { addAll(tick.events); }
  std::uint64_t value() const { return hash_.value(); }

 private:
  void addAll(std::span<const GameEvent> events) {
    for (const GameEvent& event : events) {
      hash_.add(static_cast<std::uint64_t>(event.tick));
      hash_.add(event.clause);
      hash_.add(event.value);
    }
  }
  StateHash hash_;
};

// Returns the value, or ends the program if a preset or team cannot be loaded.
template <typename T>
T get(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "match_hash_program: %s\n", result.error().message.c_str());
  std::exit(1);
}

void play(const std::string& rules, const std::string& blue, const std::string& yellow,
          const VisionModel& vision) {
  MatchConfig config;
  config.rules = get(loadRules(rules));
  config.rules.half_seconds = kHalfSeconds;
  config.field = get(loadField(config.rules.field));
  config.robot = get(loadRobot("vsss"));
  config.physics = get(loadPhysics("standard"));
  config.teams = {get(parseTeam(blue)), get(parseTeam(yellow))};
  config.vision.fill(vision);
  Match match = get(Match::create(config));
  EventHash events;
  match.watch(events);
  while (match.step()) {
  }
  const std::string name = rules + " " + blue + " " + yellow + (vision.perfect() ? "" : " blurred");
  std::printf("%-40s %016" PRIx64 " %016" PRIx64 "\n", name.c_str(), match.hash(), events.value());
}

}  // namespace

int main() {
  VisionModel blurred;
  blurred.latency_ticks = 3;
  blurred.position_noise = 0.002;
  blurred.heading_noise = 0.02;
  blurred.dropout = 0.02;
  const auto all = TeamCatalogue::builtIn().teams();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& blue = all[i]->name;
    const std::string& yellow = all[(i + 1) % all.size()]->name;
    play("vsss-3v3", blue, yellow, {});
    play("vsss-3v3", blue, yellow, blurred);
    play("vsss-5v5", blue, yellow, {});
  }
  return 0;
}
