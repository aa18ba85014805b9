#include "experiments/papers/transport/phases.hpp"

#include <cmath>
#include <iterator>

namespace fulbito {
namespace {

/// A row of Table 1, for one step or several.
struct PaperPhase {
  int first, count;  ///< first step and number of steps
  Phase phase;
};

constexpr PaperPhase kTable1[] = {{1, 2, {0.0, CarrierId::kLead, false, false}},
                                  {3, 1, {0.0, CarrierId::kLead, false, true}},
                                  {4, 1, {0.0, CarrierId::kLead, false, false}},
                                  {5, 4, {0.0, CarrierId::kFollower, true, false}}};

/// Time [s] at which the directions of a phase end; roles may change before.
double endOfDirections(const std::vector<Phase>& phases, std::size_t phase, double last) {
  for (std::size_t i = phase + 1; i < phases.size(); ++i) {
    if (!phases[i].sameDirections(phases[phase])) return phases[i].from;
  }
  return last;
}

}  // namespace

std::vector<Phase> phasesOf(const Carrying& work) {
  std::vector<Phase> phases;
  for (const CarryRow& row : work.rows) {
    const Phase phase{row.time, row.master, row.lead_speed < 0.0, row.follower_speed < 0.0};
    if (phases.empty() || !phases.back().same(phase)) phases.push_back(phase);
  }
  return phases;
}

std::vector<PaperStep> paperSteps(const std::vector<Phase>& phases, double end) {
  std::vector<PaperStep> steps;
  std::size_t next = 0;
  for (std::size_t i = 0; i < phases.size() && next < std::size(kTable1); ++i) {
    const PaperPhase& row = kTable1[next];
    if (!phases[i].same(row.phase)) continue;
    const bool at_end = next + 1 == std::size(kTable1);
    const double last = at_end                  ? endOfDirections(phases, i, end)
                        : i + 1 < phases.size() ? phases[i + 1].from
                                                : end;
    for (int k = 0; k < row.count; ++k) {
      const double share = (k + (next == 0 ? 0.0 : 0.5)) / row.count;
      steps.push_back({row.first + k, std::lerp(phases[i].from, last, share), i});
    }
    ++next;
  }
  return steps;
}

}  // namespace fulbito
