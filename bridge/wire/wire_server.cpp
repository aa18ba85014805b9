#include "bridge/wire/wire_server.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "bridge/wire/referee_words.hpp"
#include "engine/core/system/stop_request.hpp"

namespace fulbito::wire {
namespace {

constexpr double kLongestPoll = 0.05;      // [s] until a request to stop is seen
constexpr double kBehindMost = 0.25;       // [s] that frames catch up after a pause; beyond, they begin anew
constexpr double kMoreCommands = 0.002;    // [s] after the first command for further robots
constexpr int kMorePlaces = 3;             // frames after a placement for a better one
constexpr std::int64_t kRepeatAfter = 15;  // frames until a command of the referee is sent again
constexpr int kHalts = 3;                  // at the end
constexpr int kMostOfSender = 64;          // datagrams per frame
constexpr std::size_t kMostSenders = 64;   // per frame
constexpr int kMostAtOnce = 4096;          // datagrams per look at a socket, so that a flood does not hold us

/// Where commands come to. Loopback alone is for clients of this machine alone.
std::string localOf(const WireSettings& settings) {
  return settings.interface.starts_with("127.") ? settings.interface : "";
}

}  // namespace

WireServer::WireServer(const WireSettings& settings, WireClock clock, WireLog log, UdpSender vision,
                       UdpSender referee, UdpReceiver commands)
    : settings_(settings),
      clock_(std::move(clock)),
      log_(std::move(log)),
      oddities_(clock_, log_),
      vision_(std::move(vision)),
      referee_(std::move(referee)),
      commands_(std::move(commands)),
      board_(0, settings.lock) {}

Result<std::unique_ptr<WireServer>> WireServer::open(const WireSettings& settings, WireClock clock,
                                                     WireLog log, std::vector<Descriptor> sockets) {
  const int base = settings.port_base;
  const std::string& interface = settings.interface;
  sockets.resize(kSockets);
  auto vision = UdpSender::open({kVisionGroup, base + kVisionOffset}, interface, std::move(sockets[0]));
  if (!vision) return tl::unexpected<Error>(vision.error());
  auto referee = UdpSender::open({kRefereeGroup, base + kRefereeOffset}, interface, std::move(sockets[1]));
  if (!referee) return tl::unexpected<Error>(referee.error());
  auto commands =
      UdpReceiver::open({localOf(settings), base + kCommandOffset}, interface, std::move(sockets[2]));
  if (!commands) return tl::unexpected<Error>(commands.error());
  std::unique_ptr<WireServer> server(new WireServer(settings, std::move(clock), std::move(log),
                                                    std::move(*vision), std::move(*referee),
                                                    std::move(*commands)));
  if (auto listening = server->listen(sockets); !listening) return tl::unexpected<Error>(listening.error());
  return server;
}

/// Opens the ports that not every server has.
Result<void> WireServer::listen(std::vector<Descriptor>& sockets) {
  const int base = settings_.port_base;
  const std::string& interface = settings_.interface;
  sockets_ = {commands_.number()};
  if (settings_.referee) {
    auto port = UdpReceiver::open({kRefereeGroup, base + kPlacementOffset}, interface, std::move(sockets[3]));
    if (!port) return tl::unexpected<Error>(port.error());
    sockets_.push_back(port->number());
    placements_ = std::move(*port);
  }
  if (!settings_.team_ports) return {};
  for (const auto& [colour, offset] :
       {std::pair{TeamId::kYellow, kYellowOffset}, {TeamId::kBlue, kBlueOffset}}) {
    auto port = UdpReceiver::open({localOf(settings_), settings_.port_base + offset}, settings_.interface);
    if (!port) return tl::unexpected<Error>(port.error());
    sockets_.push_back(port->number());
    team_ports_.emplace_back(colour, std::move(*port));
  }
  return {};
}

void WireServer::look() {
  if (alive_ && !ended_) ended_ = !alive_();
}

bool WireServer::goesOn() const { return !stopRequested() && !ended_; }

bool WireServer::claim(TeamId colour) { return !std::exchange(claimed_[indexOf(colour)], true); }

void WireServer::begin(int team_size, double period) {
  team_size_ = team_size;
  board_ = CommandBoard(team_size, settings_.lock);
  period_ = period;
  began_ = frame_end_ = now();
}

void WireServer::send(UdpSender& to, std::string_view datagram) {
  if (!to.send(datagram)) oddities_.note(Oddity::kUnsent, fmt::format("{} bytes", datagram.size()));
}

void WireServer::show(Vision vision) {
  receive();  // what belongs to the last frame
  look();
  const auto milliseconds = static_cast<std::uint32_t>(period_ * 1000.0);
  vision.step = step_ += milliseconds;
  send(vision_, datagramOf(vision));
  ++frames_;
  board_.beginFrame();
  senders_.clear();
  const double time = now();
  // Frames of lockstep end before their time, which must not add up to a pause at the next restart.
  if (settings_.lockstep || time - frame_end_ > kBehindMost) frame_end_ = time;
  frame_end_ += period_ / settings_.speed;
}

void WireServer::showTick(Tick tick, const Vision& vision) {
  if (tick == shown_tick_) return;
  shown_tick_ = tick;
  show(vision);
}

void WireServer::receiveFor(double seconds) {
  waitForAny(sockets_, std::min(seconds, kLongestPoll));
  receive();
  look();
}

void WireServer::finishFrame() {
  receive();
  for (double left = frame_end_ - now(); left > 0.0 && goesOn(); left = frame_end_ - now()) {
    receiveFor(left);
  }
}

bool WireServer::awaitCommands(TeamId colour, std::uint32_t robots, double seconds) {
  receive();
  double end = now() + seconds;
  bool any = false;
  while (!board_.answered(colour, robots) && goesOn()) {
    if (!any && board_.answering(colour)) {
      any = true;
      end = std::min(end, now() + kMoreCommands);
    }
    const double left = end - now();
    if (left <= 0.0) break;
    receiveFor(left);
  }
  return board_.answering(colour);
}

bool WireServer::silent(TeamId colour) const {
  return settings_.wait > 0.0 && now() - heard_[indexOf(colour)].value_or(began_) > settings_.wait;
}

bool WireServer::awaitClient(TeamId colour, const RefereeCommand& command, const Vision& vision) {
  const auto& heard = heard_[indexOf(colour)];
  if (heard) return true;
  if (log_ && !std::exchange(awaited_[indexOf(colour)], true)) {
    log_(fmt::format("waiting for a client of {}: vision on {}:{}, commands to port {}", nameOf(colour),
                     kVisionGroup, settings_.port_base + kVisionOffset,
                     settings_.port_base + kCommandOffset));
  }
  while (!heard && goesOn() && !silent(colour)) {
    say(command);
    show(vision);
    finishFrame();
  }
  return heard.has_value();
}

std::optional<TeamPlaces> WireServer::awaitPlaces(TeamId colour, const RefereeCommand& command,
                                                  const Vision& vision) {
  say(command);
  const auto& places = places_[indexOf(colour)];
  const double end = now() + settings_.placing / settings_.speed;
  int more = kMorePlaces;
  while (goesOn() && (places ? --more >= 0 : now() < end)) {
    show(vision);
    finishFrame();
    if (!places) say(command);
  }
  return places;
}

void WireServer::say(const RefereeCommand& command) {
  const bool same = said_ && sameCommand(*said_, command);
  if (same && frames_ - said_at_ < kRepeatAfter) return;
  if (!same && isRestart(command.foul)) places_ = {};
  said_ = command;
  said_at_ = frames_;
  send(referee_, datagramOf(command));
}

void WireServer::sayHalt(const RefereeCommand& last) {
  if (said_ && said_->foul == Foul::kHalt) return;
  said_ = last;
  for (int i = 0; i < kHalts; ++i) send(referee_, datagramOf(last));
}

bool WireServer::flooding(Sender sender) {
  const auto known = std::find_if(senders_.begin(), senders_.end(),
                                  [&](const auto& entry) { return entry.first == sender; });
  if (known != senders_.end()) return ++known->second > kMostOfSender;
  if (senders_.size() >= kMostSenders) return true;
  senders_.emplace_back(sender, 1);
  return false;
}

void WireServer::receiveFrom(UdpReceiver& socket, const std::function<void(std::string_view, Sender)>& take) {
  std::array<char, kLongestMessage> room{};
  for (int i = 0; i < kMostAtOnce; ++i) {
    const auto datagram = socket.receive(room);
    if (!datagram) return;
    if (flooding(datagram->sender)) {
      oddities_.note(Oddity::kFlood, fmt::format("more than {} per frame", kMostOfSender));
    } else if (datagram->size > room.size()) {
      oddities_.note(Oddity::kMalformed, fmt::format("{} bytes", datagram->size));
    } else {
      take({room.data(), datagram->size}, datagram->sender);
    }
  }
}

void WireServer::receive() {
  const auto packets = [this](std::optional<TeamId> port) {
    return [this, port](std::string_view bytes, Sender sender) { takePacket(bytes, sender, port); };
  };
  receiveFrom(commands_, packets(std::nullopt));
  for (auto& [colour, socket] : team_ports_) receiveFrom(socket, packets(colour));
  if (placements_) receiveFrom(*placements_, [this](std::string_view bytes, Sender) { takePlaces(bytes); });
}

void WireServer::hear(TeamId colour) { heard_[indexOf(colour)] = now(); }

void WireServer::takePacket(std::string_view datagram, Sender sender, std::optional<TeamId> port) {
  auto packet = readPacket(datagram);
  if (!packet) return oddities_.note(Oddity::kMalformed, packet.error().message);
  if (port) {
    for (WheelCommand& command : packet->commands) command.team = *port;
  }
  board_.take(*packet, sender, oddities_);
  if (packet->ball || !packet->robots.empty()) {
    if (replacer_ && !port) {
      replacer_(*packet);
    } else {
      oddities_.note(Oddity::kReplacement, "ball or robots");
    }
  }
  for (const TeamId colour : kTeams) {
    if (board_.answering(colour)) hear(colour);
  }
}

void WireServer::takePlaces(std::string_view datagram) {
  auto places = readTeamPlaces(datagram);
  if (!places) return oddities_.note(Oddity::kMalformed, places.error().message);
  std::erase_if(places->robots, [&](const PlacedRobot& robot) {
    const bool unknown = robot.number >= static_cast<std::uint32_t>(team_size_);
    const bool odd = !isFinite(robot.pose.position) || !std::isfinite(robot.pose.heading);
    if (unknown || odd) {
      oddities_.note(unknown ? Oddity::kUnknown : Oddity::kNotFinite,
                     fmt::format("placement of {} robot {}", nameOf(places->team), robot.number));
    }
    return unknown || odd;
  });
  hear(places->team);
  places_[indexOf(places->team)] = std::move(*places);
}

}  // namespace fulbito::wire
