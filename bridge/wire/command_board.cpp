#include "bridge/wire/command_board.hpp"

#include <cmath>

#include <fmt/format.h>

namespace fulbito::wire {

bool CommandBoard::mayCommand(TeamId team, Sender sender) {
  std::optional<Sender>& first = first_[indexOf(team)];
  if (!first) first = sender;
  return !lock_ || *first == sender;
}

void CommandBoard::take(const Packet& packet, Sender sender, OddityLog& oddities) {
  for (const WheelCommand& command : packet.commands) {
    const auto name = [&] { return fmt::format("{} robot {}", nameOf(command.team), command.number); };
    if (command.number >= static_cast<std::uint32_t>(team_size_)) {
      oddities.note(Oddity::kUnknown, name());
      continue;
    }
    if (!mayCommand(command.team, sender)) {
      oddities.note(Oddity::kOtherSender, name());
      continue;
    }
    answered_[indexOf(command.team)] |= 1U << command.number;
    if (!std::isfinite(command.wheels.left) || !std::isfinite(command.wheels.right)) {
      oddities.note(Oddity::kNotFinite, name());
      continue;
    }
    wheels_[indexOf(command.team)][command.number] = command.wheels;
    ++taken_;
  }
}

}  // namespace fulbito::wire
