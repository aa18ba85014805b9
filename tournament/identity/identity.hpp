#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/base/wide_hash.hpp"
#include "tournament/plan/plan.hpp"
#include "tournament/results/results.hpp"

namespace fulbito {

/// What determines a team's play, besides what it sees.
struct TeamIdentity {
  /// 32 hexadecimal digits over sources or files, and the specification. A file counts by its content and its
  /// name, not by the folder that the team is in.
  std::string hash;
  bool outside = false;       ///< from a file or program
  bool deterministic = true;  ///< false: `team.toml` says so; its results are never taken from a cache
  std::string covers;         ///< for people: "built-in sources", "2 files: team.py, weights.bin"
  bool repeats = true;  ///< false: it was seen to answer differently; as if not deterministic, but for ids
};

/// The identity of an entrant: of a built-in team the hash of its sources with those that all teams share, of
/// another the content of its file, the files of its command line, those that a `team.toml` beside it
/// declares and those of the plan. Parameters belong to it. Errors: as `parseTeamCommand`; kIo naming a file
/// that cannot be read; kBadInput of `team.toml`; kUsage for a team that is neither built in nor of files.
Result<TeamIdentity> identityOf(const Entrant& entrant);

/// Hash of the sources of engine, referee and match that this program is built from, and of the version of
/// its physics library: 32 hexadecimal digits. The teams have their own.
std::string engineIdentity();

/// Computes the identities of matches of one plan: rules, physics, robots, field, vision and time limits are
/// hashed once. A match of two equal teams is the same in both legs and has one identity, unless one of them
/// is not deterministic.
class MatchIdentity {
 public:
  /// Errors: as `identityOf`.
  static Result<MatchIdentity> create(const TournamentPlan& plan);

  /// Identity of leg 0 or 1 of a fixture.
  MatchId of(const Fixture& fixture, std::size_t leg) const;
  /// The same again from its parts, for reports: `engine` and `base` as below. Errors: kBadInput.
  static Result<MatchIdentity> restore(const TournamentPlan& plan, std::string engine, std::string_view base,
                                       std::vector<TeamIdentity> teams);

  /// By entrant.
  const std::vector<TeamIdentity>& teams() const { return teams_; }
  /// Notes that an entrant was seen not to repeat itself.
  void markVarying(std::size_t entrant) { teams_[entrant].repeats = false; }
  /// `engineIdentity` of the program that made this.
  const std::string& engine() const { return engine_; }
  /// Hash of all that the matches of the plan share: 32 hexadecimal digits.
  std::string base() const { return hexText(base_); }

 private:
  void addTeam(TeamIdentity team, const VisionModel& vision);

  std::uint64_t seed_ = 0;
  BookConfig book_;
  std::string engine_;
  WideHashValue base_{};                ///< of all that the matches of the plan share
  std::vector<TeamIdentity> teams_;     ///< by entrant
  std::vector<WideHashValue> players_;  ///< by entrant: its identity and its vision
};

}  // namespace fulbito
