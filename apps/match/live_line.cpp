#include "apps/match/live_line.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/base/match_clock.hpp"
#include "engine/core/system/error_text.hpp"
#include "fulbito/statistics.hpp"

namespace fulbito::app {
namespace {

constexpr double kPeriod = 0.1;  // [s] between redraws

}  // namespace

LiveLine::LiveLine(const MatchConfig& config)
    : config_(config), terminal_(drawsLines()), begin_(now()), last_(begin_) {}

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
  const std::string line =
      fmt::format("\r{} {} : {} {}   {} {}   {}\033[K", terminalText(config_.teams[0].text), referee.score[0],
                  referee.score[1], terminalText(config_.teams[1].text), periodName(referee.period),
                  clockText(clock), paceText(match.seconds(), elapsed));
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  last_ = time;
  drawn_ = true;
}

}  // namespace fulbito::app
