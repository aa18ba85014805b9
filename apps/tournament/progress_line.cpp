#include "apps/tournament/progress_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/system/error_text.hpp"

namespace fulbito::app {
namespace {

constexpr double kBarPeriod = 0.1;    // [s] between redraws on a terminal
constexpr double kLinePeriod = 10.0;  // [s] between plain lines
constexpr int kBarWidth = 20;

/// The log-likelihood ratio between its bounds, as a bar: fail on the left, pass on the right.
std::string ratioBar(const Sprt& sprt) {
  const double lower = sprt.bounds().lower(), upper = sprt.bounds().upper();
  const double share = std::clamp((sprt.ratio() - lower) / (upper - lower), 0.0, 1.0);
  std::string bar(kBarWidth, '-');
  bar[static_cast<std::size_t>(std::lround(share * (kBarWidth - 1)))] = '#';
  return fmt::format("fail [{}] pass, ratio {:.2f}", bar, sprt.ratio());
}

std::string timeText(double seconds) {
  if (seconds < 0.0) return "";
  const auto whole = std::lround(seconds);
  if (whole < 60) return fmt::format(", {} s left", whole);
  if (whole < 3600) return fmt::format(", {} min left", (whole + 30) / 60);
  return fmt::format(", {:.1f} h left", static_cast<double>(whole) / 3600);
}

}  // namespace

std::string progressText(const std::string& what, const RunProgress& progress) {
  std::string text = fmt::format("{}: {} of {}{} matches", what, progress.done,
                                 progress.sprt ? "at most " : "", progress.known);
  if (progress.failures > 0) text += fmt::format(", {} with a failed team", progress.failures);
  if (progress.sprt) text += ", " + ratioBar(*progress.sprt);
  return text;
}

double secondsLeft(const RunProgress& progress, std::size_t fresh, double elapsed) {
  if (fresh == 0) return -1.0;
  const double pace = elapsed / static_cast<double>(fresh);
  auto left = static_cast<double>(progress.known - progress.done);
  if (progress.sprt && progress.sprt->ratio() != 0.0) {
    const Sprt& sprt = *progress.sprt;
    const double bound = sprt.ratio() > 0.0 ? sprt.bounds().upper() : sprt.bounds().lower();
    const auto pairs = static_cast<double>(sprt.counts().pairs());
    left = std::min(left, 2 * pairs * std::max(bound / sprt.ratio() - 1.0, 0.0));
  }
  return pace * left;
}

ProgressLine::ProgressLine(const std::string& what)
    : what_(terminalText(what)), terminal_(drawsLines()), begin_(now()), last_(begin_) {}

ProgressLine::~ProgressLine() {
  if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
}

bool ProgressLine::update(const RunProgress& progress) {
  if (!started_) begun_ = progress.done;
  started_ = true;
  const std::int64_t time = now();
  if (static_cast<double>(time - last_) * 1e-9 >= (terminal_ ? kBarPeriod : kLinePeriod)) {
    const double elapsed = static_cast<double>(time - begin_) * 1e-9;
    const std::string line =
        progressText(what_, progress) + timeText(secondsLeft(progress, progress.done - begun_, elapsed));
    std::fprintf(stderr, terminal_ ? "\r%s\033[K" : "%s\n", line.c_str());
    std::fflush(stderr);
    last_ = time;
    drawn_ = true;
  }
  return !interrupted();
}

}  // namespace fulbito::app
