#include "match/check/watched_team.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace fulbito {
namespace {

/// Base of teams that stand in for another one: passes all calls on unchanged.
class Relay : public Strategy {
 public:
  explicit Relay(std::unique_ptr<Strategy> team) : team_(std::move(team)) {}
  void begin(const MatchInfo& info) override { team_->begin(info); }
  std::span<const NavigatorChoice> navigators() const override { return team_->navigators(); }
  TeamCommand decide(const Observation& seen) override { return team_->decide(seen); }
  void allow(double seconds) override { team_->allow(seconds); }
  void ask(const Observation& seen) override { team_->ask(seen); }
  const TeamCondition& condition() const override { return team_->condition(); }
  std::vector<Setting> origin() const override { return team_->origin(); }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    return team_->place(request);
  }
  void stopped(const PlayStop& stop) override { team_->stopped(stop); }
  void ready(const Observation& seen) override { team_->ready(seen); }
  void ended(const MatchEnd& end) override { team_->ended(end); }
  std::optional<ExerciseReply> exercise(const Observation& seen, const Exercise& exercise) override {
    return team_->exercise(seen, exercise);
  }

 protected:
  Strategy& team() { return *team_; }

 private:
  std::unique_ptr<Strategy> team_;
};

double secondsOf(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

class Watched final : public Relay {
 public:
  Watched(std::unique_ptr<Strategy> team, std::int64_t created_at, const MatchClock& read_clock,
          TeamNotes& notes)
      : Relay(std::move(team)), created_at_(created_at), clock_(read_clock), notes_(&notes) {}

  void begin(const MatchInfo& info) override {
    Relay::begin(info);
    notes_->start_seconds = std::max(notes_->start_seconds, secondsOf(clock_() - created_at_));
    notes_->origin = team().origin();
  }

  TeamCommand decide(const Observation& seen) override {
    const std::int64_t begun_at = clock_();
    TeamCommand command = Relay::decide(seen);
    const double seconds = secondsOf(clock_() - begun_at);
    notes_->seconds.push_back(condition().seconds.value_or(seconds));
    if (!seen.wants_drawings && !command.drawings.empty()) ++notes_->unasked;
    if (std::any_of(command.roles.begin(), command.roles.end(), [](auto role) { return role != 0; })) {
      ++notes_->with_roles;
    }
    return command;
  }

 private:
  std::int64_t created_at_;
  MatchClock clock_;
  TeamNotes* notes_;
};

class Overheard final : public Relay {
 public:
  Overheard(std::unique_ptr<Strategy> team, RecordedCalls& kept) : Relay(std::move(team)), kept_(&kept) {}
  void begin(const MatchInfo& info) override {
    kept_->info = info;
    Relay::begin(info);
  }
  TeamCommand decide(const Observation& seen) override {
    kept_->calls.emplace_back(DecideCall{seen});
    return Relay::decide(seen);
  }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    kept_->calls.emplace_back(request);
    return Relay::place(request);
  }
  void stopped(const PlayStop& stop) override {
    kept_->calls.emplace_back(stop);
    Relay::stopped(stop);
  }
  void ready(const Observation& seen) override {
    kept_->calls.emplace_back(ReadyCall{seen});
    Relay::ready(seen);
  }

 private:
  RecordedCalls* kept_;
};

/// The choice with a `make` that passes each new team through `wrap`.
template <typename Wrap>
TeamChoice wrapped(const TeamChoice& team, Wrap wrap) {
  TeamInfo info = *team.info;
  info.make = [inner = team.info, wrap = std::move(wrap)](
                  const std::vector<Setting>& settings) -> Result<std::unique_ptr<Strategy>> {
    return wrap([&] { return inner->make(settings); });
  };
  TeamChoice choice = team;
  choice.info = std::make_shared<const TeamInfo>(std::move(info));
  return choice;
}

}  // namespace

TeamChoice watchedTeam(const TeamChoice& team, const MatchClock& read_clock, TeamNotes& notes) {
  return wrapped(team, [read_clock, &notes](const auto& make) -> Result<std::unique_ptr<Strategy>> {
    const std::int64_t created_at = read_clock();
    auto made = make();
    if (!made) return made;
    return std::make_unique<Watched>(std::move(*made), created_at, read_clock, notes);
  });
}

TeamChoice overheardTeam(const TeamChoice& team, RecordedCalls& kept) {
  return wrapped(team, [&kept](const auto& make) -> Result<std::unique_ptr<Strategy>> {
    auto made = make();
    if (!made) return made;
    return std::make_unique<Overheard>(std::move(*made), kept);
  });
}

}  // namespace fulbito
