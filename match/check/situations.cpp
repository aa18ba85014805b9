#include "match/check/situations.hpp"

#include <utility>

#include <fmt/format.h>

#include "match/drills/start.hpp"
#include "referee/restarts/restart_call.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

constexpr double kShort = 4.0;       // [s] play time of a situation
constexpr double kQuickShort = 1.0;  // [s]
constexpr double kLong = 60.0;       // [s] play time of the longer play
constexpr double kQuickLong = 8.0;   // [s]
constexpr double kCorner = 0.1;      // [m] distance of a ball in the corner from both walls

/// Makes the situations of one seat.
class Script {
 public:
  Script(TeamId seat, std::uint64_t seed, bool quick) : seat_(seat), seed_(seed), quick_(quick) {}

  Result<void> restart(RestartKind kind, bool ours, Vec2 ball = {}) {
    auto match = base("vsss-3v3", "chaser");
    if (!match) return tl::unexpected<Error>(match.error());
    const TeamId taker = ours ? seat_ : other(seat_);
    const Side side = taker == TeamId::kBlue ? Side::kLeft : Side::kRight;
    match->opening = makeCall(refereeSetup(*match), {}, {kind, taker, inTeamFrame(side, ball), nullptr});
    add(fmt::format("{}, {}", nameOf(kind), ours ? "ours" : "theirs"), std::move(*match), shortly());
    return {};
  }

  /// `ball`: from the centre, 1 at the corner. `own` and `theirs`: robots on the field. All in the frame of
  /// the tested team.
  Result<void> start(std::string name, Vec2 ball, int own, int theirs) {
    auto match = base("vsss-3v3", "chaser");
    if (!match) return tl::unexpected<Error>(match.error());
    const Vec2 corner{match->field.length / 2 - kCorner, match->field.width / 2 - kCorner};
    Placement placement;
    placement.ball = {ball.x * corner.x, ball.y * corner.y};
    // No place is on the long axis, where left and right are equal.
    constexpr Vec2 kPlaces[] = {{-0.6, 0.03}, {-0.3, 0.2}, {-0.2, -0.25}};
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (i < own) placement.robots[indexOf(TeamId::kBlue)][at] = Pose2{kPlaces[at], 0.0};
      if (i < theirs) placement.robots[indexOf(TeamId::kYellow)][at] = Pose2{-kPlaces[at], math::kPi};
    }
    match->start = seated(placement, seat_);
    add(std::move(name), std::move(*match), shortly());
    return {};
  }

  Result<void> play(std::string name, const std::string& rules, const std::string& opponent, double seconds) {
    auto match = base(rules, opponent);
    if (!match) return tl::unexpected<Error>(match.error());
    add(std::move(name), std::move(*match), seconds);
    return {};
  }

  double shortly() const { return quick_ ? kQuickShort : kShort; }
  double longer() const { return quick_ ? kQuickLong : kLong; }
  std::vector<CheckSituation> take() { return std::move(situations_); }

 private:
  Result<MatchConfig> base(const std::string& rules, const std::string& opponent) const {
    auto match = MatchConfig::standard(opponent, opponent, rules);
    if (!match) return match;
    match->seed = seed_;
    match->decision_time = match->rules.decision_time;
    return match;
  }

  void add(std::string name, MatchConfig match, double seconds) {
    const auto ticks = static_cast<Tick>(seconds / match.physics.controlPeriod());
    situations_.push_back({std::move(name), std::move(match), seat_, ticks});
  }

  TeamId seat_;
  std::uint64_t seed_;
  bool quick_;
  std::vector<CheckSituation> situations_;
};

constexpr Vec2 kFreeBall{0.375, 0.4};  // [m] a mark, in the frame of the team that attacks there

Result<void> addRestarts(Script& script) {
  for (const bool ours : {true, false}) {
    for (const RestartKind kind : {RestartKind::kKickOff, RestartKind::kGoalKick, RestartKind::kPenalty,
                                   RestartKind::kFreeBall, RestartKind::kFreeKick}) {
      const Vec2 ball = kind == RestartKind::kFreeBall ? kFreeBall : Vec2{};
      if (auto added = script.restart(kind, ours, ball); !added) return added;
    }
  }
  return {};
}

// fractions of the way to the corner; not on the long axis, where left and right are equal
constexpr Vec2 kBeside{0.1, 0.4};

Result<void> addStarts(Script& script) {
  for (const auto& added :
       {script.start("ball in our corner", {-1.0, 1.0}, 3, 3),
        script.start("ball in their corner", {1.0, -1.0}, 3, 3),
        script.start("one robot away", kBeside, 2, 3), script.start("alone", kBeside, 1, 3),
        script.start("no opponents", kBeside, 3, 0)}) {
    if (!added) return added;
  }
  return {};
}

}  // namespace

Result<std::vector<CheckSituation>> checkSituations(TeamId seat, std::uint64_t seed, bool quick) {
  Script script(seat, seed, quick);
  Result<void> added = addRestarts(script);
  if (added) added = addStarts(script);
  if (added) added = script.play("five robots", "vsss-5v5", "chaser", script.shortly());
  if (added) added = script.play("a piece of play", "vsss-3v3", "classic", script.longer());
  if (!added) return tl::unexpected<Error>(added.error());
  return script.take();
}

}  // namespace fulbito
