#include <cmath>

#include "engine/core/math/random.hpp"
#include "strategies/interface/team_info.hpp"

namespace fulbito {
namespace {

/// Each wheel's speed changes smoothly: every tick it is pulled back toward zero and gets a random push.
class RandomTeam final : public Strategy {
 public:
  struct Params {
    double memory = 0.5;  ///< [s] time constant of a wheel's speed
    double share = 0.6;   ///< standard deviation, as a share of the greatest wheel speed
  };

  explicit RandomTeam(Params params) : params_(params) {}

  void begin(const MatchInfo& info) override {
    rng_ = Rng(info.seed, Stream::kRandomTeam);
    fastest_ = info.robot.max_wheel_speed;
    wheels_.fill({});
  }

  TeamCommand decide(const Observation& observation) override {
    // An Ornstein-Uhlenbeck process in steps of dt with the wanted standard deviation.
    const double kept = 1.0 - observation.dt / (params_.memory + observation.dt);
    const double push = params_.share * fastest_ * std::sqrt(1.0 - kept * kept);
    TeamCommand command;
    for (std::size_t i = 0; i < static_cast<std::size_t>(observation.team_size); ++i) {
      WheelSpeeds& wheels = wheels_[i];
      wheels = {kept * wheels.left + push * rng_.normal(), kept * wheels.right + push * rng_.normal()};
      command.robots[i] = RobotCommand::byWheels(wheels);
    }
    return command;
  }

 private:
  Params params_;
  Rng rng_{0, Stream::kRandomTeam};
  double fastest_ = 0.0;
  std::array<WheelSpeeds, kMaxTeamSize> wheels_{};
};

}  // namespace

TeamInfo randomTeamInfo() {
  using P = RandomTeam::Params;
  return describeTeam<P, RandomTeam>(
      "random", "all robots drive at random, smoothly",
      {number("memory", &P::memory, 0.0, 10.0, "s", "correlation time of the wheel speeds"),
       number("share", &P::share, 0.0, 2.0, "",
              "standard deviation of the wheel speeds over the top speed")});
}

}  // namespace fulbito
