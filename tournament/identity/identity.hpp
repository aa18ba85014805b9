#pragma once

#include <cstdint>
#include <string>

#include "tournament/plan/plan.hpp"
#include "tournament/results/results.hpp"

namespace fulbito {

/// What determines a team's play, besides what it sees.
struct TeamIdentity {
  std::string hash;      ///< 32 hexadecimal digits over sources or files, and the specification
  bool outside = false;  ///< from a file or program
  std::string covers;    ///< for people: "built-in sources", "2 files: team.py, weights.bin"
};

/// The identity of an entrant: of a built-in team the hash of its sources with those that all teams share, of
/// another the content of its file, the files of its command line, those that a `team.toml` beside it
/// declares and those of the plan. Parameters belong to it. Errors: kIo naming a file that cannot be read;
/// kBadInput of `team.toml`.
Result<TeamIdentity> identityOf(const Entrant& entrant);

/// Hash of the sources of engine, referee and match that this program is built from: 32 hexadecimal digits.
std::string engineIdentity();

/// Computes the identities of matches of one plan: rules, physics, robots, field, vision and time limits are
/// hashed once.
class MatchIdentity {
 public:
  /// Errors: as `identityOf`.
  static Result<MatchIdentity> create(const TournamentPlan& plan);

  /// Identity of leg 0 or 1 of a fixture.
  MatchId of(const Fixture& fixture, std::size_t leg) const;
  /// By entrant.
  const std::vector<TeamIdentity>& teams() const { return teams_; }

 private:
  std::uint64_t seed_ = 0;
  BookConfig book_;
  std::array<std::uint64_t, 2> base_{};
  std::vector<TeamIdentity> teams_;
};

}  // namespace fulbito
