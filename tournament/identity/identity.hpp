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

/// Everything that determines a team's play, besides its input.
struct TeamIdentity {
  /// 32 hexadecimal digits: hash over sources or files, and the specification. A file is hashed by its
  /// content and its name; the path of the team's folder does not count.
  std::string hash;
  bool outside = false;  ///< whether the team is a file or program outside this program
  /// False if `team.toml` says so; the team's results are never taken from a cache.
  bool deterministic = true;
  std::string covers;  ///< for people: "built-in sources", "2 files: team.py, weights.bin"
  /// False if the team was seen to answer the same question differently. Results are then not cached, but
  /// match ids stay the same.
  bool repeats = true;
};

/// The identity of an entrant, with its parameters. Of a built-in team: the hash of its sources and those
/// that all teams share. Of another team: the content of its file, the files of its command line, those that
/// a `team.toml` beside it declares, and those that the plan lists. Errors: as `parseTeamCommand`; kIo naming
/// a file that cannot be read; kBadInput of `team.toml`; kUsage for a team that is neither built in nor made
/// of files.
Result<TeamIdentity> identityOf(const Entrant& entrant);

/// Hash of the sources of engine, referee and match that this program is built from, and of the version of
/// its physics library: 32 hexadecimal digits. Does not cover the sources of teams.
std::string engineIdentity();

/// Computes the identities of the matches of one plan. Rules, physics, robots, field, vision and time limits
/// are hashed only once. A match of two equal teams is the same in both legs and has one identity, unless a
/// team is not deterministic.
class MatchIdentity {
 public:
  /// Errors: as `identityOf`.
  static Result<MatchIdentity> create(const TournamentPlan& plan);

  /// Identity of leg 0 or 1 of a fixture.
  MatchId of(const Fixture& fixture, std::size_t leg) const;
  /// Builds the same object from stored parts, for reports: `engine` and `base` as below. Errors: kBadInput.
  static Result<MatchIdentity> restore(const TournamentPlan& plan, std::string engine, std::string_view base,
                                       std::vector<TeamIdentity> teams);

  /// Identities of the teams, by entrant.
  const std::vector<TeamIdentity>& teams() const { return teams_; }
  /// Marks an entrant as one that was seen not to repeat itself.
  void markVarying(std::size_t entrant) { teams_[entrant].repeats = false; }
  /// `engineIdentity` of the program that created this identity.
  const std::string& engine() const { return engine_; }
  /// Hash of everything that the matches of the plan share: 32 hexadecimal digits.
  std::string base() const { return hexText(base_); }

 private:
  void addTeam(TeamIdentity team, const VisionModel& vision);

  std::uint64_t seed_ = 0;
  BookConfig book_;
  std::string engine_;
  WideHashValue base_{};                ///< hash of everything that the matches of the plan share
  std::vector<TeamIdentity> teams_;     ///< by entrant
  std::vector<WideHashValue> players_;  ///< by entrant: hash of its identity and its vision
};

}  // namespace fulbito
