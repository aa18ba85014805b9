#pragma once

#include <memory>
#include <optional>

#include "bridge/wire/wire_server.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::wire {

/// A client of the league as a team of a match. What the match tells the team goes out as vision and as the
/// referee's commands; the client's wheel speeds and placements come back. The client has one colour and
/// defends that colour's goal, blue's at -x, whatever seat and side it plays.
class WireTeam : public Strategy {
 public:
  /// @param server  with the colour claimed for this team, which releases it
  /// @param awaits  a match that begins with play waits for the client first; restarts always wait
  WireTeam(std::shared_ptr<WireServer> server, TeamId colour, bool awaits = true);
  WireTeam(const WireTeam&) = delete;
  WireTeam& operator=(const WireTeam&) = delete;
  ~WireTeam() override { server_->release(colour_); }
  void begin(const MatchInfo& info) override;
  void ask(const Observation& observation) override;
  TeamCommand decide(const Observation& observation) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  void ready(const Observation& observation) override;
  void ended(const MatchEnd& end) override;
  const TeamCondition& condition() const override { return condition_; }

 private:
  Vision visionOf(const Observation& observation) const;
  Vision restingVision(const PlacementRequest& request) const;
  RefereeCommand commandOf(Foul foul, const Observation& observation) const;
  RefereeCommand foulOf(const PlacementRequest& request) const;
  bool lost() const { return condition_.state == TeamCondition::State::kLost; }
  void lose(const char* reason);
  /// As of `WireServer::awaitClient`; a team whose client does not come in time is lost.
  bool awaitClient(const RefereeCommand& command, const Vision& vision);

  std::shared_ptr<WireServer> server_;
  TeamId colour_;
  bool awaits_;
  Side side_;  ///< the goal that it defends on the wire
  MatchInfo info_;
  TeamCondition condition_;
};

}  // namespace fulbito::wire
