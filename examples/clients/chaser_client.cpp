// A client of the league's simulator: its robots chase the ball and drive it toward the other goal.
//
//   chaser_client blue|yellow [--host ADDRESS] [--port-base PORT] [--interface ADDRESS]
//
// Build it with the messages that protoc makes of bridge/wire/*.proto:
//
//   protoc --proto_path=bridge/wire --cpp_out=FOLDER simulator.proto referee.proto
//   g++ -std=c++20 -IFOLDER chaser_client.cpp FOLDER/*.pb.cc -lprotobuf-lite -o chaser_client

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <netinet/in.h>
#include <numbers>
#include <optional>
#include <poll.h>
#include <string>
#include <sys/socket.h>

#include "referee.pb.h"
#include "simulator.pb.h"

namespace {

namespace simulator = fulbito_wire::simulator;
namespace referee = fulbito_wire::referee;

constexpr const char* kVisionGroup = "224.0.0.1";
constexpr const char* kRefereeGroup = "224.5.23.2";
constexpr double kCruise = 25.0;  // [rad/s] of the wheels
constexpr double kTurn = 12.0;    // [rad/s] of the wheels per radian

struct Options {
  bool yellow = false;
  std::string host = "127.0.0.1";
  int port_base = 10002;
  std::string interface = "0.0.0.0";
};

[[noreturn]] void giveUp(const char* what) {
  std::perror(what);
  std::exit(1);
}

in_addr addressOf(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1) giveUp(text.c_str());
  return address;
}

sockaddr_in endOf(const std::string& host, int port) {
  sockaddr_in end{};
  end.sin_family = AF_INET;
  end.sin_addr = addressOf(host);
  end.sin_port = htons(static_cast<in_port_t>(port));
  return end;
}

// A socket that hears a multicast group.
int listenTo(const std::string& group, int port, const std::string& interface) {
  const int listener = socket(AF_INET, SOCK_DGRAM, 0);
  const int yes = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const sockaddr_in end = endOf(group, port);
  if (bind(listener, reinterpret_cast<const sockaddr*>(&end), sizeof end) != 0) giveUp("bind");
  const ip_mreq membership{addressOf(group), addressOf(interface)};
  if (setsockopt(listener, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0) {
    giveUp(group.c_str());
  }
  return listener;
}

// The next message that waits, if one does and is whole.
template <typename Message>
std::optional<Message> received(int listener) {
  std::array<char, 1024> bytes{};
  const ssize_t size = recv(listener, bytes.data(), bytes.size(), MSG_DONTWAIT);
  Message message;
  if (size < 0 || !message.ParseFromArray(bytes.data(), static_cast<int>(size))) return std::nullopt;
  return message;
}

template <typename Message>
void sendTo(int sender, const sockaddr_in& end, const Message& message) {
  const std::string bytes = message.SerializeAsString();
  sendto(sender, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&end), sizeof end);
}

// Wheel speeds that lead to a point, with either end of the robot in front.
void driveTo(const simulator::Robot& robot, double x, double y, simulator::Command& command) {
  constexpr double kPi = std::numbers::pi;
  double error = std::remainder(std::atan2(y - robot.y(), x - robot.x()) - robot.orientation(), 2.0 * kPi);
  double speed = kCruise;
  if (std::abs(error) > kPi / 2) {
    error = std::remainder(error + kPi, 2.0 * kPi);
    speed = -kCruise;
  }
  command.set_wheel_left(speed * std::cos(error) - kTurn * error);
  command.set_wheel_right(speed * std::cos(error) + kTurn * error);
}

simulator::Packet commandsFor(const simulator::Environment& seen, bool yellow, bool playing) {
  simulator::Packet packet;
  const double forward = yellow ? -1.0 : 1.0;
  const simulator::Ball& ball = seen.frame().ball();
  for (const simulator::Robot& robot : yellow ? seen.frame().robots_yellow() : seen.frame().robots_blue()) {
    simulator::Command& command = *packet.mutable_cmd()->add_robot_commands();
    command.set_id(robot.robot_id());
    command.set_yellowteam(yellow);
    if (!playing) continue;
    if (robot.robot_id() == 0) {  // the keeper moves along its line
      driveTo(robot, -0.68 * forward, std::clamp(ball.y(), -0.15, 0.15), command);
    } else if ((ball.x() - robot.x()) * forward > 0.05) {  // behind the ball: through it
      driveTo(robot, ball.x() + 0.05 * forward, ball.y(), command);
    } else {  // back behind the ball, around it
      driveTo(robot, ball.x() - 0.2 * forward, ball.y() + (robot.y() > ball.y() ? 0.12 : -0.12), command);
    }
  }
  return packet;
}

// Where the robots wish to stand at a restart; the referee repairs what its rules do not allow.
referee::VSSRef_Placement placement(bool yellow) {
  constexpr std::array<std::array<double, 2>, 3> kPlaces{{{0.68, 0.0}, {0.35, 0.1}, {0.35, -0.25}}};
  referee::VSSRef_Placement message;
  message.mutable_world()->set_teamcolor(yellow ? referee::YELLOW : referee::BLUE);
  std::uint32_t number = 0;
  for (const auto& [x, y] : kPlaces) {
    referee::Robot& robot = *message.mutable_world()->add_robots();
    robot.set_robot_id(number++);
    robot.set_x(yellow ? x : -x);
    robot.set_y(y);
    robot.set_orientation(yellow ? 180.0 : 0.0);
  }
  return message;
}

Options optionsOf(int argc, char** argv) {
  Options options;
  const std::string colour = argc > 1 ? argv[1] : "";
  bool right = (colour == "blue" || colour == "yellow") && argc % 2 == 0;
  options.yellow = colour == "yellow";
  for (int i = 2; right && i < argc; i += 2) {
    const std::string flag = argv[i];
    if (flag == "--host") {
      options.host = argv[i + 1];
    } else if (flag == "--port-base") {
      options.port_base = std::atoi(argv[i + 1]);
    } else if (flag == "--interface") {
      options.interface = argv[i + 1];
    } else {
      right = false;
    }
  }
  if (right) return options;
  std::fprintf(
      stderr, "Usage: chaser_client blue|yellow [--host ADDRESS] [--port-base PORT] [--interface ADDRESS]\n");
  std::exit(2);
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsOf(argc, argv);
  const int vision = listenTo(kVisionGroup, options.port_base, options.interface);
  const int told = listenTo(kRefereeGroup, options.port_base + 1, options.interface);
  const int sender = socket(AF_INET, SOCK_DGRAM, 0);
  const in_addr way = addressOf(options.interface);
  setsockopt(sender, IPPROTO_IP, IP_MULTICAST_IF, &way, sizeof way);
  const sockaddr_in commands = endOf(options.host, options.port_base + 10009);
  const sockaddr_in placements = endOf(kRefereeGroup, options.port_base + 2);
  referee::Foul foul = referee::HALT;
  for (bool played = false; !played || foul != referee::HALT;) {  // after the match comes a halt
    std::array<pollfd, 2> waiting{{{vision, POLLIN, 0}, {told, POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), -1);
    while (const auto command = received<referee::VSSRef_Command>(told)) {
      foul = command->foul();
      played = played || foul == referee::GAME_ON;
      if (foul < referee::STOP) sendTo(sender, placements, placement(options.yellow));
    }
    std::optional<simulator::Environment> newest;  // a client that falls behind skips frames
    while (auto seen = received<simulator::Environment>(vision)) newest = std::move(seen);
    if (newest) sendTo(sender, commands, commandsFor(*newest, options.yellow, foul == referee::GAME_ON));
  }
}
