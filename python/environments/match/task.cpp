#include "python/environments/match/task.hpp"

#include <cmath>

#include <fmt/format.h>

#include "python/environments/match/starts.hpp"

namespace fulbito {
namespace {

constexpr int kMostSkips = 1000;
constexpr int kMostStacked = 100;
constexpr std::size_t kCompatTeam = 3;  // robots per team of rSoccer's VSS-v0

Result<void> range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::kUsage, fmt::format("{}: {} is outside {} ... {}", name, value, low, high));
}

Result<void> checkAgents(const MatchTask& task) {
  const auto size = static_cast<std::size_t>(task.match.rules.team_size);
  for (const RobotId agent : agentsOf(task)) {
    if (agent.number >= size) {
      return fail(ErrorCode::kUsage,
                  fmt::format("agents: {} has no robot {}: the rules '{}' have {} per team",
                              nameOf(agent.team), agent.number, task.match.rules.name, size));
    }
  }
  if (agentsOf(task).empty()) return fail(ErrorCode::kUsage, "agents: there is none");
  if (task.observations == ObservationForm::kCompat && size != kCompatTeam) {
    return fail(ErrorCode::kUsage, "observations: this layout has three robots per team");
  }
  return {};
}

Result<void> checkWeights(const RewardWeights& weights) {
  for (const auto& [name, value] : {std::pair{"goal", weights.goal},
                                    {"ball", weights.ball},
                                    {"move", weights.move},
                                    {"energy", weights.energy},
                                    {"foul", weights.foul}}) {
    if (!std::isfinite(value)) return fail(ErrorCode::kUsage, fmt::format("rewards: {} = {}", name, value));
  }
  return {};
}

}  // namespace

Result<void> checkTask(const MatchTask& task) {
  if (auto r = range("frame_skip", task.frame_skip, 1, kMostSkips); !r) return r;
  if (auto r = range("stack", task.stack, 1, kMostStacked); !r) return r;
  if (auto r = range("seconds", task.seconds, 0.0, 1e6); !r) return r;
  if (auto r = checkWeights(task.weights); !r) return r;
  if (auto r = checkAgents(task); !r) return r;
  return checkRanges(task);
}

std::vector<RobotId> agentsOf(const MatchTask& task) {
  std::vector<RobotId> agents;
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      if (task.agents[indexOf(team)][i]) agents.push_back({team, static_cast<std::uint8_t>(i)});
    }
  }
  return agents;
}

}  // namespace fulbito
