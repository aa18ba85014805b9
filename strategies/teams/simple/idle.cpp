#include "strategies/interface/team_info.hpp"

namespace fulbito {
namespace {

class Idle final : public Strategy {
 public:
  struct Params {};
  explicit Idle(Params) {}
  void begin(const MatchInfo&) override {}
  TeamCommand decide(const Observation&) override { return {}; }
};

}  // namespace

TeamInfo idleInfo() { return describeTeam<Idle::Params, Idle>("idle", "all robots stand still", {}); }

}  // namespace fulbito
