#include <utility>

#include "fulbito/match.hpp"
#include "tournament/book/book.hpp"
#include "tournament/identity/identity.hpp"

namespace fulbito {
namespace {

void add(WideHash& hash, Vec2 v) {
  hash.add(v.x);
  hash.add(v.y);
}

void add(WideHash& hash, const TeamPoses& poses) {
  for (const auto& pose : poses) {
    hash.add(std::uint64_t{pose.has_value()});
    if (!pose) continue;
    add(hash, pose->position);
    hash.add(pose->heading);
  }
}

void add(WideHash& hash, const Placement& placement) {
  add(hash, placement.ball);
  add(hash, placement.ball_velocity);
  for (const TeamPoses& poses : placement.robots) add(hash, poses);
}

void add(WideHash& hash, const RestartCall& call) {
  hash.add(static_cast<std::uint64_t>(call.kind));
  hash.add(static_cast<std::uint64_t>(call.team));
  add(hash, call.ball);
  hash.add(static_cast<std::uint64_t>(call.delay));
  hash.add(std::uint64_t{call.defenders_back});
  add(hash, call.defaults);
  for (const TeamPoses& poses : call.stays) add(hash, poses);
  for (const auto& team : call.rests) {
    for (const bool rests : team) hash.add(std::uint64_t{rests});
  }
}

void add(WideHash& hash, const Scoreboard& board) {
  for (const int goals : board.score) hash.add(static_cast<std::uint64_t>(goals));
  hash.add(static_cast<std::uint64_t>(board.period));
  hash.add(board.play_seconds);
}

void add(WideHash& hash, const VisionModel& vision) {
  hash.add(static_cast<std::uint64_t>(vision.latency_ticks));
  hash.add(vision.position_noise);
  hash.add(vision.heading_noise);
  hash.add(vision.dropout);
}

void add(WideHash& hash, const DecisionTime& time) {
  hash.add(time.decision);
  hash.add(time.bank);
  hash.add(static_cast<std::uint64_t>(time.held));
  hash.add(time.start);
  hash.add(static_cast<std::uint64_t>(time.failures));
}

template <typename T>
void add(WideHash& hash, const std::optional<T>& value) {
  hash.add(std::uint64_t{value.has_value()});
  if (value) add(hash, *value);
}

/// The rules as text, without the path of the field's file, because the field is hashed by its values.
std::string textOf(Rules rules, const FieldGeometry& field) {
  rules.field = field.name;
  return toToml(rules);
}

/// Hash of everything that matches share, whatever their teams, vision, start in the book and seed.
WideHashValue sharedHash(const MatchConfig& match) {
  WideHash hash;
  hash.add(engineIdentity());
  for (const std::string& text :
       {textOf(match.rules, match.field), toToml(match.physics), toToml(match.robot), toToml(match.field)}) {
    hash.add(text);
  }
  hash.add(match.placement_error.position);
  hash.add(match.placement_error.heading);
  add(hash, match.decision_time);
  for (const bool present : match.present) hash.add(std::uint64_t{present});
  add(hash, match.start);
  add(hash, match.opening);
  add(hash, match.scoreboard);
  return hash.value();
}

WideHashValue playerHash(const TeamIdentity& team, const VisionModel& vision) {
  WideHash hash;
  hash.add(team.hash);
  add(hash, vision);
  return hash.value();
}

/// Hash of a few words. It is the same on all machines and faster than setting up a `WideHash`.
template <std::size_t N>
WideHashValue hashOf(const std::array<std::uint64_t, N>& words) {
  std::array<char, 8 * N> bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(words[i / 8] >> (8 * (i % 8)));
  return wideHash({bytes.data(), bytes.size()});
}

}  // namespace

void MatchIdentity::addTeam(TeamIdentity team, const VisionModel& vision) {
  players_.push_back(playerHash(team, vision));
  teams_.push_back(std::move(team));
}

Result<MatchIdentity> MatchIdentity::create(const TournamentPlan& plan) {
  MatchIdentity identity;
  identity.seed_ = plan.seed;
  identity.book_ = plan.book;
  identity.engine_ = engineIdentity();
  identity.base_ = sharedHash(plan.match);
  for (std::size_t i = 0; i < plan.entrants.size(); ++i) {
    auto team = identityOf(plan.entrants[i]);
    if (!team) return tl::unexpected<Error>(team.error());
    identity.addTeam(std::move(*team), plan.match.vision[i == 0 ? 0 : 1]);
  }
  return identity;
}

Result<MatchIdentity> MatchIdentity::restore(const TournamentPlan& plan, std::string engine,
                                             std::string_view base, std::vector<TeamIdentity> teams) {
  const auto shared = MatchId::parse(base);
  if (!shared || teams.size() != plan.entrants.size()) {
    return fail(ErrorCode::kBadInput, "identities do not belong to the plan");
  }
  MatchIdentity identity;
  identity.seed_ = plan.seed;
  identity.book_ = plan.book;
  identity.engine_ = std::move(engine);
  identity.base_ = shared->words;
  for (std::size_t i = 0; i < teams.size(); ++i) {
    identity.addTeam(std::move(teams[i]), plan.match.vision[i == 0 ? 0 : 1]);
  }
  return identity;
}

MatchId MatchIdentity::of(const Fixture& fixture, std::size_t leg) const {
  const std::size_t blue = leg == 0 ? fixture.a : fixture.b, yellow = leg == 0 ? fixture.b : fixture.a;
  const StartKey start = startKey(book_, fixture.start);
  // Two matches of a non-deterministic team against itself are two samples, although their inputs are equal.
  const bool repeats = teams_[blue].deterministic && teams_[yellow].deterministic;
  return {hashOf<12>({base_[0], base_[1], players_[blue][0], players_[blue][1], players_[yellow][0],
                      players_[yellow][1], seedOfStart(seed_, fixture.start),
                      static_cast<std::uint64_t>(start.kind), start.seed, start.turn, repeats ? 0U : 1U,
                      repeats ? 0U : std::uint64_t{leg}})};
}

}  // namespace fulbito
