#include "bridge/outside/outside_team.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bridge/abi/library_team.hpp"
#include "bridge/outside/conversation.hpp"
#include "engine/core/system/stop_request.hpp"

namespace fulbito {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kFarewell = 0.5;  // [s] for a program to end by itself after the match
// [s] Between looks at standard error while all replies come at once. Waits look at it too, so a program that
// prints much never blocks for long.
constexpr double kErrorsEvery = 0.05;

}  // namespace

struct OutsideTeam::Impl {
  using Kind = TeamReply::Kind;
  using State = TeamCondition::State;
  enum class Stage : std::uint8_t { kHello, kBegin, kPlaying };

  explicit Impl(OutsideTeamSetup from) : setup(std::move(from)), errors(setup.log) {}

  double now() const { return static_cast<double>(setup.clock()) * 1e-9; }
  bool lost() const { return condition.state == State::kLost || condition.state == State::kCut; }
  bool playing() const { return !lost() && talk && stage == Stage::kPlaying; }
  void launch();
  void continueStart(double seconds);
  NavigatorChoice navigatorOf(const std::string& name) const;
  void takeNavigators(const std::vector<std::string>& names);
  void sendDecision(const Observation& observation);
  void noteFailure();
  void waitForStart(const Observation& observation);
  // [s] time left for the present decision
  double left() const { return std::max(0.0, asked_at + allowed - now()); }
  void settle(State state, double since);
  template <typename Notify>
  void notify(const Notify& write);
  template <typename Ask>
  TeamReply* request(Kind kind, const Ask& write);

  OutsideTeamSetup setup;
  BoundedLog errors;
  MatchInfo info;
  DecisionTime limit;
  std::vector<NavigatorChoice> navigators;
  std::vector<std::string> navigator_names;
  bool begun = false;  // the first start is over
  TeamCondition condition;
  std::optional<Conversation> talk;
  Stage stage = Stage::kHello;
  std::uint64_t awaited = 0;      // the request of the present stage, or the open decision; 0: none
  bool outdated = false;          // the open decision is for an earlier tick
  int silent = 0;                 // decisions in a row without any reply
  double start_end = 0.0;         // [s]
  double allowed = kUnlimited;    // [s]
  double asked_at = 0.0;          // [s]
  double shown_at = 0.0;          // [s] time of the last look at standard error
  std::int64_t stale_before = 0;  // stale replies in earlier conversations
  TeamWelcome welcome;
};

// Sends both messages at once: a program that is ready answers both without another wait.
void OutsideTeam::Impl::launch() {
  talk.emplace(setup, errors);
  stage = Stage::kHello;
  outdated = false;
  silent = 0;
  start_end = now() + limit.start;
  const TeamHello hello{"fulbito", setup.settings};
  awaited = talk->next();
  talk->send([&](TeamCodec& codec, std::string& out) { codec.hello(awaited, hello, out); });
  const std::uint64_t begin = talk->next();
  talk->send([&](TeamCodec& codec, std::string& out) { codec.begin(begin, info, out); });
}

void OutsideTeam::Impl::continueStart(double seconds) {
  while (talk->failure().empty() && stage != Stage::kPlaying) {
    const double left = start_end - now();
    if (left <= 0.0) talk->fail(fmt::format("no start within {} s", limit.start));
    const Kind kind = stage == Stage::kHello ? Kind::kHello : Kind::kBegin;
    const TeamReply* reply = talk->await(awaited, kind, std::min(left, seconds));
    if (reply == nullptr) break;
    if (stage == Stage::kHello) {
      welcome = reply->welcome;
      ++awaited;
      stage = Stage::kBegin;
    } else {
      stage = Stage::kPlaying;
      awaited = 0;
      takeNavigators(reply->navigators);
    }
  }
}

// Only the user may name a library as navigator, not a team's program: loading one runs its code in this
// process.
NavigatorChoice OutsideTeam::Impl::navigatorOf(const std::string& name) const {
  for (const Setting& setting : setup.settings) {
    if (setting.name == "navigator" && setting.value == name) return navigatorFor(name, parseNavigator);
  }
  return navigatorFor(name, parseBuiltInNavigator);
}

void OutsideTeam::Impl::takeNavigators(const std::vector<std::string>& names) {
  if (begun && names != navigator_names) return talk->fail("other navigators than at its first start");
  if (begun) return;
  for (const std::string& name : names) {
    navigators.push_back(navigatorOf(name));
  }
  navigator_names = names;
}

// Replaces a conversation that is over by a new one, or gives up. After a failure of the machine it gives up
// at once: a restarted team would lack its memory by no fault of its own.
void OutsideTeam::Impl::noteFailure() {
  if (lost() || !talk || talk->failure().empty()) return;
  condition.reason = talk->failure();
  if (talk->code() == ErrorCode::kMachine || talk->code() == ErrorCode::kInterrupted) {
    condition.state = State::kCut;
    talk.reset();
    return;
  }
  stale_before += talk->stale();
  ++condition.failures;
  if (!begun) navigators.clear();
  if (condition.failures >= limit.failures) {
    condition.state = State::kLost;
    talk.reset();
    return;
  }
  condition.state = State::kDown;
  launch();
}

// The condition after a call that began at `since`.
void OutsideTeam::Impl::settle(State state, double since) {
  noteFailure();
  if (!lost()) condition.state = talk && stage == Stage::kPlaying ? state : State::kDown;
  const double time = now();
  condition.seconds = time - since;
  condition.stale = stale_before + (talk ? talk->stale() : 0);
  if (!talk || time - shown_at < kErrorsEvery) return;
  shown_at = time;
  talk->showErrors();
}

void OutsideTeam::Impl::sendDecision(const Observation& observation) {
  awaited = talk->next();
  outdated = false;
  talk->send([&](TeamCodec& codec, std::string& out) { codec.decide(awaited, observation, out); });
}

// A new start uses the team's decision time. If it takes longer, play goes on without the team.
void OutsideTeam::Impl::waitForStart(const Observation& observation) {
  if (lost() || playing()) return;
  continueStart(left());
  noteFailure();
  if (playing()) sendDecision(observation);
}

template <typename Notify>
void OutsideTeam::Impl::notify(const Notify& write) {
  if (playing()) talk->send(write);
}

template <typename Ask>
TeamReply* OutsideTeam::Impl::request(Kind kind, const Ask& write) {
  awaited = 0;  // the reply to a decision that is still open will be stale
  outdated = false;
  const std::uint64_t id = talk->next();
  talk->send([&](TeamCodec& codec, std::string& out) { write(codec, id, out); });
  return talk->await(id, kind, allowed);
}

OutsideTeam::OutsideTeam(OutsideTeamSetup setup) : impl_(std::make_unique<Impl>(std::move(setup))) {}
OutsideTeam::~OutsideTeam() = default;

void OutsideTeam::begin(const MatchInfo& info) {
  Impl& team = *impl_;
  team.info = info;
  team.limit = info.decision_time.value_or(DecisionTime{kUnlimited, 0.0, 0, kUnlimited, 1});
  if (team.limit.decision == kUnlimited) team.limit.start = kUnlimited;
  team.launch();
  while (!team.lost() && team.stage != Impl::Stage::kPlaying) {
    team.continueStart(kUnlimited);
    team.noteFailure();
    if (!stopRequested() || team.lost()) continue;
    team.condition.state = TeamCondition::State::kCut;
    team.condition.reason = "interrupted";
  }
  team.begun = true;
  team.settle(TeamCondition::State::kWell, team.now());
}

std::span<const NavigatorChoice> OutsideTeam::navigators() const { return impl_->navigators; }

void OutsideTeam::allow(double seconds) { impl_->allowed = seconds; }

void OutsideTeam::ask(const Observation& observation) {
  Impl& team = *impl_;
  team.asked_at = team.now();
  if (!team.playing()) return;
  if (team.awaited == 0) {
    team.sendDecision(observation);
  } else {
    team.outdated = true;
  }
}

TeamCommand OutsideTeam::decide(const Observation& observation) {
  Impl& team = *impl_;
  TeamCommand command;
  team.waitForStart(observation);
  auto state = TeamCondition::State::kLate;
  bool heard = false, waited = false;
  while (team.playing() && team.awaited != 0) {
    TeamReply* reply = team.talk->await(team.awaited, TeamReply::Kind::kDecide, 0.0);
    if (reply == nullptr) {
      waited = true;
      reply = team.talk->await(team.awaited, TeamReply::Kind::kDecide, team.left());
    }
    if (reply == nullptr) break;
    heard = true;
    if (team.outdated) {
      team.sendDecision(observation);
      continue;
    }
    std::swap(command, reply->command);
    team.awaited = 0;
    state = TeamCondition::State::kWell;
  }
  team.silent = heard ? 0 : team.silent + 1;
  if (team.playing() && team.silent > team.limit.held) {
    team.talk->fail(fmt::format("silent for {} decisions", team.silent));
  }
  team.settle(state, team.asked_at);
  // The arrival time of a reply that was already there is unknown: it may have waited while the other team
  // decided.
  if (!waited) team.condition.seconds = std::min(*team.condition.seconds, team.limit.decision);
  return command;
}

std::optional<TeamProposal> OutsideTeam::place(const PlacementRequest& request) {
  Impl& team = *impl_;
  const double since = team.now();
  if (!team.playing()) return std::nullopt;
  TeamReply* reply = team.request(
      TeamReply::Kind::kPlace,
      [&](TeamCodec& codec, std::uint64_t id, std::string& out) { codec.place(id, request, out); });
  auto wishes = reply != nullptr ? reply->proposal : std::nullopt;
  team.settle(reply != nullptr ? TeamCondition::State::kWell : TeamCondition::State::kLate, since);
  return wishes;
}

std::optional<ExerciseReply> OutsideTeam::exercise(const Observation& observation, const Exercise& exercise) {
  Impl& team = *impl_;
  const double since = team.now();
  if (!team.playing()) return std::nullopt;
  TeamReply* reply =
      team.request(TeamReply::Kind::kExercise, [&](TeamCodec& codec, std::uint64_t id, std::string& out) {
        codec.exercise(id, observation, exercise, out);
      });
  auto answer = reply != nullptr ? std::move(reply->exercise) : std::nullopt;
  team.settle(reply != nullptr ? TeamCondition::State::kWell : TeamCondition::State::kLate, since);
  return answer;
}

void OutsideTeam::stopped(const PlayStop& stop) {
  impl_->notify([&](TeamCodec& codec, std::string& out) { codec.stopped(stop, out); });
}

void OutsideTeam::ready(const Observation& observation) {
  impl_->notify([&](TeamCodec& codec, std::string& out) { codec.ready(observation, out); });
}

void OutsideTeam::ended(const MatchEnd& end) {
  impl_->notify([&](TeamCodec& codec, std::string& out) { codec.ended(end, out); });
  if (impl_->playing()) impl_->talk->waitForEnd(kFarewell);
}

const TeamCondition& OutsideTeam::condition() const { return impl_->condition; }

std::vector<Setting> OutsideTeam::origin() const {
  std::vector<Setting> origin;
  if (!impl_->welcome.name.empty()) origin.push_back({"name", impl_->welcome.name});
  if (!impl_->welcome.version.empty()) origin.push_back({"version", impl_->welcome.version});
  if (impl_->talk) addContainment(impl_->talk->containment(), origin);
  return origin;
}

void addContainment(const Containment& reached, std::vector<Setting>& origin) {
  origin.push_back({"containment", fmt::format("{}", fmt::join(reached.layers, " "))});
  if (reached.missing.empty()) return;
  origin.push_back({"containment_missing", fmt::format("{}", fmt::join(reached.missing, "; "))});
}

}  // namespace fulbito
