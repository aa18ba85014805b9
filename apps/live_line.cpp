#include "apps/live_line.hpp"

#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

#include "apps/commands.hpp"
#include "engine/core/match_clock.hpp"
#include "match/summary.hpp"

namespace fulbito::app {
namespace {

constexpr double kPeriod = 0.1;  // [s] between redraws

}  // namespace

LiveLine::LiveLine(const MatchConfig& config)
    : config_(config), terminal_(::isatty(STDERR_FILENO) == 1), begin_(now()), last_(begin_) {}

LiveLine::~LiveLine() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void LiveLine::update(const Match& match) {
  if (!terminal_) return;
  const std::int64_t time = now();
  if (static_cast<double>(time - last_) * 1e-9 < kPeriod) return;
  const double elapsed = static_cast<double>(time - begin_) * 1e-9;
  const RefereeState& referee = match.referee();
  const double clock = static_cast<double>(referee.play_ticks) * config_.physics.controlPeriod();
  fmt::print(stderr, "\r{} {} : {} {}   {} {}   {}\033[K", config_.teams[0].text, referee.score[0],
             referee.score[1], config_.teams[1].text, periodName(referee.period), clockText(clock),
             paceText(match.seconds(), elapsed));
  std::fflush(stderr);
  last_ = time;
  drawn_ = true;
}

}  // namespace fulbito::app
