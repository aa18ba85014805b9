#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "bridge/wire/messages.hpp"
#include "bridge/wire/oddities.hpp"

namespace fulbito::wire {

/// Address and port of a sender, as one number.
using Sender = std::uint64_t;

/// The commands that clients have given: each stays until the next one for the same robot, without a
/// time-out.
class CommandBoard {
 public:
  /// @param lock  for each colour only the first sender counts
  CommandBoard(int team_size, bool lock) : team_size_(team_size), lock_(lock) {}

  /// Takes the commands of a packet. Robots that it does not name keep theirs. A command with a NaN or an
  /// infinity is dropped, but shows that the client has seen the frame.
  void take(const Packet& packet, Sender sender, OddityLog& oddities);
  /// Forgets the command in force for a robot: 0 until the next one.
  void forget(TeamId team, std::size_t number) { wheels_[indexOf(team)][number] = {}; }
  /// A new frame is out: no robot has a command for it yet.
  void beginFrame() { answered_ = {}; }

  /// Whether any command came for a robot of the team since `beginFrame`.
  bool answering(TeamId team) const { return answered_[indexOf(team)] != 0; }
  /// Whether commands came for the robots of the team in `robots` (bit by number).
  bool answered(TeamId team, std::uint32_t robots) const {
    return (answered_[indexOf(team)] & robots) == robots;
  }
  /// The wheel speeds in force [rad/s]; 0 before the first command.
  WheelSpeeds wheels(TeamId team, std::size_t number) const { return wheels_[indexOf(team)][number]; }
  /// Commands that came into force.
  std::int64_t taken() const { return taken_; }

 private:
  bool mayCommand(TeamId team, Sender sender);

  int team_size_;
  bool lock_;
  PerTeam<std::array<WheelSpeeds, kMaxTeamSize>> wheels_{};
  PerTeam<std::uint32_t> answered_{};  ///< bit by number
  std::int64_t taken_ = 0;
  PerTeam<std::optional<Sender>> first_{};
};

}  // namespace fulbito::wire
