// Plays a match of two minutes and records it: play_match [BLUE YELLOW [FILE]]
#include <cstdio>
#include <fulbito/match.hpp>
#include <fulbito/recorder.hpp>
#include <fulbito/statistics.hpp>

int main(int count, char** arguments) {
  const char* blue = count > 2 ? arguments[1] : "libero";
  const char* yellow = count > 2 ? arguments[2] : "classic";
  auto config = fulbito::MatchConfig::standard(blue, yellow);
  if (!config) return std::fprintf(stderr, "%s\n", config.error().message.c_str()), 2;
  config->rules.half_seconds = 60.0;
  config->seed = 7;

  auto match = fulbito::Match::create(*config);
  auto recorder = fulbito::MatchRecorder::create(count > 3 ? arguments[3] : "play.fbr", *config);
  if (!match) return std::fprintf(stderr, "%s\n", match.error().message.c_str()), 2;
  if (!recorder) return std::fprintf(stderr, "%s\n", recorder.error().message.c_str()), 5;
  fulbito::StatisticsObserver statistics;
  match->watch(*recorder);
  match->watch(statistics);
  while (match->step()) {
  }
  if (!recorder->written())
    return std::fprintf(stderr, "%s\n", recorder->written().error().message.c_str()), 5;

  const auto& score = match->referee().score;
  std::printf("%s - %s %d : %d\n", blue, yellow, score[0], score[1]);
  for (const fulbito::TeamId team : fulbito::kTeams) {
    std::printf("%s had the ball for %.0f %% of play\n", fulbito::nameOf(team),
                100.0 * statistics.statistics().possession(team));
  }
}
