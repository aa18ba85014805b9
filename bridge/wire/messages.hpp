#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"

/// The messages of the league's simulator and referee as plain values. All poses are in the wire's frame:
/// blue defends the goal at -x, always. Headings are in radians here, whatever they are on the wire.
namespace fulbito::wire {

/// No message of a client is longer [bytes]; a whole team's command has less than 200.
inline constexpr std::size_t kLongestMessage = 4096;
/// Clients read no longer datagrams of vision [bytes].
inline constexpr std::size_t kLongestVision = 1024;

/// A robot in a frame of vision.
struct SeenRobot {
  std::uint32_t number = 0;  ///< from 0
  RobotState state;          ///< without wheels
};

/// A frame of vision.
struct Vision {
  std::uint32_t step = 0;                  ///< [ms] simulated
  BallState ball;                          ///< without spin
  double ball_height = 0.0;                ///< [m] of its centre: the ball's radius
  PerTeam<std::vector<SeenRobot>> robots;  ///< by number; robots that are not on the field are left out
  FieldGeometry field;                     ///< only what the message has
  PerTeam<std::uint32_t> goals{};          ///< score
};

/// One robot's command.
struct WheelCommand {
  std::uint32_t number = 0;     ///< of the robot, from 0
  TeamId team = TeamId::kBlue;  ///< its team
  WheelSpeeds wheels;           ///< [rad/s], anything that a double can be
};

/// A robot that is to stand elsewhere.
struct RobotReplacement {
  std::uint32_t number = 0;     ///< of the robot, from 0
  TeamId team = TeamId::kBlue;  ///< its team
  Pose2 pose;                   ///< heading [rad], not wrapped
  bool on = false;              ///< false: the robot leaves the field
};

/// A ball that is to lie elsewhere.
struct BallReplacement {
  Vec2 position;  ///< [m]
  Vec2 velocity;  ///< [m/s]
};

/// A packet to the simulator.
struct Packet {
  std::vector<WheelCommand> commands;    ///< any number of robots of any team
  std::optional<BallReplacement> ball;   ///< empty: the ball stays
  std::vector<RobotReplacement> robots;  ///< robots that move
};

/// What the referee says; the numbers are those of the wire.
enum class Foul : std::uint8_t {
  kFreeKick,
  kPenaltyKick,
  kGoalKick,
  kFreeBall,
  kKickOff,
  kStop,    ///< robots are placed, the signal follows
  kGameOn,  ///< play
  kHalt     ///< the match is interrupted or over
};

/// Half of a match; the numbers are those of the wire.
enum class Half : std::uint8_t { kNone, kFirst, kSecond, kOvertimeFirst, kOvertimeSecond, kShootOut };

/// A command of the referee.
struct RefereeCommand {
  Foul foul = Foul::kHalt;     ///< what it says
  std::optional<TeamId> team;  ///< the team that takes the restart; empty: neither
  int quadrant = 0;            ///< 1 ... 4, counter-clockwise from x > 0, y > 0; 0: none
  double seconds = 0.0;        ///< [s] of play in the half
  Half half = Half::kNone;     ///< half of the match
};

/// Where one robot of a team shall stand.
struct PlacedRobot {
  std::uint32_t number = 0;  ///< from 0
  Pose2 pose;                ///< heading [rad], not wrapped
};

/// A team's wishes for a restart.
struct TeamPlaces {
  TeamId team = TeamId::kBlue;      ///< who wishes
  std::vector<PlacedRobot> robots;  ///< any number of robots
};

/// @{ The datagram of a message.
std::string datagramOf(const Vision& vision);
std::string datagramOf(const Packet& packet);
std::string datagramOf(const RefereeCommand& command);
std::string datagramOf(const TeamPlaces& places);
/// @}

/// @{ Reads a datagram. Missing fields are 0, unknown ones are ignored. Errors: kBadInput if it is no such
/// message, is longer than `kLongestMessage`, or names a team, foul or half that there is not.
Result<Vision> readVision(std::string_view datagram);
Result<Packet> readPacket(std::string_view datagram);
Result<RefereeCommand> readRefereeCommand(std::string_view datagram);
Result<TeamPlaces> readTeamPlaces(std::string_view datagram);
/// @}

}  // namespace fulbito::wire
