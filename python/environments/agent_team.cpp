#include "python/environments/agent_team.hpp"

#include <utility>
#include <vector>

namespace fulbito {
namespace {

class AgentTeam final : public Strategy {
 public:
  AgentTeam(std::shared_ptr<AgentSlot> slot, std::unique_ptr<Strategy> mates, NavigatorChoice navigator)
      : slot_(std::move(slot)), mates_(std::move(mates)) {
    if (mates_) navigators_.assign(mates_->navigators().begin(), mates_->navigators().end());
    navigators_.push_back(std::move(navigator));
  }

  void begin(const MatchInfo& info) override {
    slot_->info = info;
    if (mates_) mates_->begin(info);
  }
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  void allow(double seconds) override {
    if (mates_) mates_->allow(seconds);
  }
  void ask(const Observation& seen) override {
    slot_->seen = seen;
    if (mates_) mates_->ask(seen);
  }
  TeamCommand decide(const Observation& seen) override {
    TeamCommand command = mates_ ? mates_->decide(seen) : TeamCommand{};
    for (std::size_t i = 0; i < command.robots.size(); ++i) {
      if (!slot_->drives[i]) continue;
      command.robots[i] = slot_->commands[i];
      command.robots[i].go_to.navigator = static_cast<std::uint8_t>(navigators_.size() - 1);
    }
    return command;
  }
  std::optional<ExerciseReply> exercise(const Observation& seen, const Exercise&) override {
    return ExerciseReply{decide(seen), slot_->answer};
  }
  const TeamCondition& condition() const override {
    return mates_ ? mates_->condition() : Strategy::condition();
  }
  std::vector<Setting> origin() const override { return mates_ ? mates_->origin() : std::vector<Setting>{}; }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    return mates_ ? mates_->place(request) : std::nullopt;
  }
  void stopped(const PlayStop& stop) override {
    if (mates_) mates_->stopped(stop);
  }
  void ready(const Observation& placed) override {
    if (mates_) mates_->ready(placed);
  }
  void ended(const MatchEnd& end) override {
    if (mates_) mates_->ended(end);
  }

 private:
  std::shared_ptr<AgentSlot> slot_;
  std::unique_ptr<Strategy> mates_;  ///< null: none
  std::vector<NavigatorChoice> navigators_;
};

}  // namespace

TeamChoice agentTeam(std::string name, std::shared_ptr<AgentSlot> slot, std::optional<TeamChoice> mates,
                     NavigatorChoice navigator) {
  TeamInfo info;
  info.name = name;
  info.summary = "robots that a caller drives";
  info.outside = mates && mates->info->outside;
  info.make = [slot = std::move(slot), mates = std::move(mates), navigator = std::move(navigator)](
                  const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
    std::unique_ptr<Strategy> others;
    if (mates) {
      auto made = makeTeam(*mates);
      if (!made) return tl::unexpected<Error>(made.error());
      others = std::move(*made);
    }
    return std::make_unique<AgentTeam>(slot, std::move(others), navigator);
  };
  return {std::make_shared<const TeamInfo>(std::move(info)), std::move(name), {}, {}};
}

}  // namespace fulbito
