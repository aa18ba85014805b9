#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bridge/wire/command_board.hpp"
#include "bridge/wire/messages.hpp"
#include "bridge/wire/oddities.hpp"
#include "bridge/wire/udp.hpp"
#include "bridge/wire/wire_settings.hpp"

namespace fulbito::wire {

/// The simulator and the referee of the league as clients see them: sends vision and the referee's commands,
/// takes commands and placements. One match has one for the teams of the same ports.
///
/// Time passes here, not in the match: between two frames the server waits for the end of the first one, and
/// reads what comes meanwhile.
class WireServer {
 public:
  /// @param sockets  `kSockets` of another network; empty: of this one
  /// Errors: as `UdpSender::open` and `UdpReceiver::open`.
  static Result<std::unique_ptr<WireServer>> open(const WireSettings& settings, WireClock clock, WireLog log,
                                                  std::vector<Descriptor> sockets = {});
  static constexpr int kSockets = 6;
  /// Sets what looks at a client that this server has for itself, at least once per frame. Once it says
  /// false, the client has ended, and nothing waits any more.
  void watch(std::function<bool()> alive) { alive_ = std::move(alive); }
  /// Whether it has.
  bool clientEnded() const { return ended_; }

  /// Takes a colour for one team. False if it is taken.
  bool claim(TeamId colour);
  void release(TeamId colour) { claimed_[indexOf(colour)] = false; }
  /// A match begins. @param period  [s] of a frame
  void begin(int team_size, double period);
  /// Who moves robots and ball: gets each packet with replacements, once its commands are in force. Without
  /// it such packets are odd.
  void onReplacement(std::function<void(const Packet&)> replacer) { replacer_ = std::move(replacer); }

  /// Sends a frame, which begins now.
  void show(Vision vision);
  /// The same for a tick of the match, unless its frame is out: teams of both colours see the same one.
  void showTick(Tick tick, const Vision& vision);
  /// Waits until the frame's time is over.
  void finishFrame();
  /// Waits until commands for these robots (bit by number) have come since the frame, or a little after the
  /// first of them: clients may command fewer. At most `seconds`. True if any came.
  bool awaitCommands(TeamId colour, std::uint32_t robots, double seconds);
  /// Shows the frame until there is a client of that colour. False if there is none for too long.
  bool awaitClient(TeamId colour, const RefereeCommand& command, const Vision& vision);
  /// Shows the frame until a placement of that colour has come since the command began, and a little longer
  /// for a better one. Empty if none comes in time.
  std::optional<TeamPlaces> awaitPlaces(TeamId colour, const RefereeCommand& command, const Vision& vision);
  /// Sends a command of the referee. The same one as before is sent again only now and then, against loss.
  void say(const RefereeCommand& command);
  /// Says that the match is over, more than once against loss.
  void sayHalt(const RefereeCommand& last);

  /// The wheel speeds in force [rad/s].
  WheelSpeeds wheels(TeamId colour, std::size_t number) const { return board_.wheels(colour, number); }
  /// As `CommandBoard::forget`.
  void forget(TeamId colour, std::size_t number) { board_.forget(colour, number); }
  /// Whether a client of that colour has ever said anything.
  bool heard(TeamId colour) const { return heard_[indexOf(colour)].has_value(); }
  /// Whether the client of that colour has said nothing for `WireSettings::wait`, or never came.
  bool silent(TeamId colour) const;
  OddityLog& oddities() { return oddities_; }
  const OddityLog& oddities() const { return oddities_; }
  const WireSettings& settings() const { return settings_; }
  std::int64_t frames() const { return frames_; }           ///< sent
  std::int64_t commands() const { return board_.taken(); }  ///< for one robot each, that came into force

 private:
  WireServer(const WireSettings& settings, WireClock clock, WireLog log, UdpSender vision, UdpSender referee,
             UdpReceiver commands);
  Result<void> listen(std::vector<Descriptor>& sockets);
  double now() const { return static_cast<double>(clock_()) * 1e-9; }
  void receive();
  void receiveFrom(UdpReceiver& socket, const std::function<void(std::string_view, Sender)>& take);
  void receiveFor(double seconds);
  void look();
  /// Whether waiting makes sense: nobody wants to stop, and the client is there.
  bool goesOn() const;
  bool flooding(Sender sender);
  void takePacket(std::string_view datagram, Sender sender, std::optional<TeamId> port);
  void takePlaces(std::string_view datagram);
  void hear(TeamId colour);
  void send(UdpSender& to, std::string_view datagram);

  WireSettings settings_;
  WireClock clock_;
  WireLog log_;
  OddityLog oddities_;
  UdpSender vision_, referee_;
  UdpReceiver commands_;
  std::optional<UdpReceiver> placements_;                     ///< empty: not the referee
  std::vector<std::pair<TeamId, UdpReceiver>> team_ports_{};  ///< the colour whose commands come there
  std::vector<int> sockets_{};                                ///< of all receivers
  std::function<void(const Packet&)> replacer_;
  CommandBoard board_;
  PerTeam<bool> claimed_{};
  int team_size_ = 0;
  double period_ = 0.0;      ///< [s] of a frame at real time
  double frame_end_ = 0.0;   ///< [s] by the clock
  double began_ = 0.0;       ///< [s] by the clock
  std::uint32_t step_ = 0;   ///< [ms] of the last frame
  Tick shown_tick_ = -1;     ///< the last of `showTick`
  std::int64_t frames_ = 0;  ///< sent
  std::optional<RefereeCommand> said_;
  std::int64_t said_at_ = 0;  ///< frames before it
  PerTeam<std::optional<TeamPlaces>> places_;
  PerTeam<bool> awaited_{};                        ///< the log says that a client is waited for
  PerTeam<std::optional<double>> heard_;           ///< [s] by the clock
  std::vector<std::pair<Sender, int>> senders_{};  ///< and their datagrams since the frame began
  std::function<bool()> alive_;                    ///< see `watch`
  bool ended_ = false;                             ///< the client, as `alive_` says
};

}  // namespace fulbito::wire
