#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/wire/start_client.hpp"
#include "bridge/wire/wire_team.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::wire {

/// A team whose client this program starts, watches and ends. A client that ends has failed: it starts again
/// while play goes on, until it has failed too often (`DecisionTime::failures`).
class RunTeam : public Strategy {
 public:
  explicit RunTeam(ClientSetup setup) : setup_(std::move(setup)) {}
  void begin(const MatchInfo& info) override;
  void ask(const Observation& observation) override;
  TeamCommand decide(const Observation& observation) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  void ready(const Observation& observation) override;
  void ended(const MatchEnd& end) override;
  const TeamCondition& condition() const override { return condition_; }
  std::vector<Setting> origin() const override;

 private:
  /// Starts the client and its server, or notes why not.
  void start(bool first);
  /// Notes the condition after a call.
  void settle();
  void fail(std::string reason, ErrorCode code);

  ClientSetup setup_;
  MatchInfo info_;
  TeamCondition condition_;
  std::shared_ptr<ClientProgram> program_;
  std::optional<WireTeam> team_;  ///< empty: lost or cut
  std::shared_ptr<WireServer> server_;
};

}  // namespace fulbito::wire
