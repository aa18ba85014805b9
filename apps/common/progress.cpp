#include "apps/common/progress.hpp"

#include <cstdio>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/system/error_text.hpp"

namespace fulbito::app {
namespace {

constexpr double kBarPeriod = 0.1;    // [s] between redraws on a terminal
constexpr double kLinePeriod = 10.0;  // [s] between plain lines
constexpr int kBarWidth = 30;

}  // namespace

ProgressBar::ProgressBar(const std::string& what, bool quiet)
    : what_(terminalText(what)), quiet_(quiet), terminal_(drawsLines()), begin_(now()), last_(begin_) {}

ProgressBar::~ProgressBar() {
  if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
}

bool ProgressBar::update(std::size_t done, std::size_t total) {
  const std::int64_t time = now();
  const double since = static_cast<double>(time - last_) * 1e-9;
  if (!quiet_ && since >= (terminal_ ? kBarPeriod : kLinePeriod)) {
    draw(done, total, static_cast<double>(time - begin_) * 1e-9);
    last_ = time;
    drawn_ = true;
  }
  return !interrupted();
}

void ProgressBar::draw(std::size_t done, std::size_t total, double elapsed) const {
  const double share = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1.0;
  const double left = share > 0.0 ? elapsed / share - elapsed : 0.0;
  if (!terminal_) {
    std::fprintf(stderr, "%s: %zu of %zu, %.0f s left\n", what_.c_str(), done, total, left);
    return;
  }
  std::string bar(kBarWidth, ' ');
  for (int i = 0; i < static_cast<int>(share * kBarWidth); ++i) bar[static_cast<std::size_t>(i)] = '=';
  std::fprintf(stderr, "\r%s [%s] %zu/%zu, %.0f s left\033[K", what_.c_str(), bar.c_str(), done, total, left);
  std::fflush(stderr);
}

}  // namespace fulbito::app
