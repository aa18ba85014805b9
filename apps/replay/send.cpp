#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/league/heard_events.hpp"
#include "apps/league/told_recording.hpp"
#include "apps/replay/replay.hpp"
#include "bridge/wire/udp.hpp"
#include "engine/core/base/text_controls.hpp"
#include "engine/core/system/error_text.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLook = 0.05;             // [s] between looks for signals
constexpr double kBehindMost = 0.25;       // [s] that frames catch up after a pause
constexpr std::int64_t kRepeatAfter = 15;  // frames until a command is sent again, against loss
constexpr int kTimes = 3;                  // that a new command is sent, likewise

/// The frames to send, by their ticks.
struct Range {
  Tick first = 1;
  Tick last = 1;
};

/// Sends frames at their times.
class Sender {
 public:
  struct Counts {
    std::int64_t frames = 0, lost = 0, commands = 0, unsent = 0, rounds = 0;
  };

  Sender(wire::UdpSender vision, wire::UdpSender referee, const ToldRecording& told, double speed)
      : vision_(std::move(vision)),
        referee_(std::move(referee)),
        told_(told),
        period_(1.0 / (told.controlRate() * speed)),
        due_(secondsNow()) {}

  /// Sends a range once. Ends early at a signal.
  void send(const Range& range) {
    ++counts_.rounds;
    const auto& commands = told_.commands();
    auto next = std::find_if(commands.begin(), commands.end(),
                             [&](const ToldCommand& told) { return told.frame >= range.first; });
    if (next != commands.begin()) say(std::prev(next)->command);
    for (Tick tick = range.first; tick <= range.last && !interrupted(); ++tick) {
      for (; next != commands.end() && next->frame <= tick; ++next) say(next->command);
      if (said_ && counts_.frames + counts_.lost - said_at_ >= kRepeatAfter) repeat();
      show(tick);
      wait();
    }
    if (range.last < told_.ticks() || interrupted()) return;
    for (; next != commands.end(); ++next) say(next->command);
  }
  const Counts& counts() const { return counts_; }

 private:
  static double secondsNow() { return static_cast<double>(now()) * 1e-9; }
  void out(wire::UdpSender& to, const std::string& datagram) { counts_.unsent += to.send(datagram) ? 0 : 1; }
  void say(const wire::RefereeCommand& command) {
    said_ = command;
    ++counts_.commands;
    for (int i = 0; i < kTimes; ++i) repeat();
  }
  void repeat() {
    said_at_ = counts_.frames + counts_.lost;
    out(referee_, datagramOf(*said_));
  }
  void show(Tick tick) {
    step_ += frameMilliseconds(told_.controlRate());
    auto vision = told_.frame(tick);
    ++(vision ? counts_.frames : counts_.lost);
    if (!vision) return;
    vision->step = step_;
    out(vision_, datagramOf(*vision));
  }
  void wait() {
    const double time = secondsNow();
    if (time - due_ > kBehindMost) due_ = time;
    due_ += period_;
    for (double left = due_ - time; left > 0.0 && !interrupted(); left = due_ - secondsNow()) {
      wire::waitForAny({}, std::min(left, kLook));
    }
  }

  wire::UdpSender vision_, referee_;
  const ToldRecording& told_;
  double period_;           ///< [s] of a frame
  double due_;              ///< [s] of the next frame
  std::uint32_t step_ = 0;  ///< [ms] of the last frame; goes on in each round
  std::optional<wire::RefereeCommand> said_;
  std::int64_t said_at_ = 0;  ///< frames before it
  Counts counts_;
};

Result<Range> rangeOf(const ReplaySendCommand& options, const ToldRecording& told) {
  const double rate = told.controlRate(), length = static_cast<double>(told.ticks()) / rate;
  const double from = options.from.value_or(0.0), to = options.to.value_or(length);
  for (const auto& [flag, time] : {std::pair{"--from", from}, std::pair{"--to", to}}) {
    if (time >= 0.0 && time <= length + 1e-9) continue;
    return fail(ErrorCode::kUsage,
                fmt::format("{} {}: the recording lasts from 0 to {:.2f} s", flag, time, length));
  }
  const Range range{std::lround(from * rate) + 1, std::lround(to * rate)};
  if (range.first <= range.last) return range;
  return fail(ErrorCode::kUsage, fmt::format("there is no frame from --from {} to --to {} s", from, to));
}

void print(const ReplaySendCommand& options, const ToldRecording& told, const Range& range,
           const Sender::Counts& counts) {
  const double rate = told.controlRate();
  const double from = static_cast<double>(range.first - 1) / rate,
               to = static_cast<double>(range.last) / rate;
  if (!options.json) {
    say("{}: {:.2f} to {:.2f} s; rounds {}, frames {}, missing in the recording {}\n", options.file, from, to,
        counts.rounds, counts.frames, counts.lost);
    say("commands of the referee {}; datagrams not sent {}\n", counts.commands, counts.unsent);
    return;
  }
  const Json json{{"schema_version", 1},
                  {"file", options.file},
                  {"from_s", from},
                  {"to_s", to},
                  {"speed", options.speed},
                  {"rounds", counts.rounds},
                  {"frames", counts.frames},
                  {"lost", counts.lost},
                  {"commands", counts.commands},
                  {"exact", told.exact()},
                  {"unsent", counts.unsent}};
  writeOut(escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n");
}

}  // namespace

CLI::App* addReplaySend(CLI::App& replay, ReplaySendCommand& options) {
  CLI::App* command =
      replay.add_subcommand("send", "send a recorded match to clients of the league, as a server does");
  command->footer(
      "Sends vision and the referee's commands, and takes no commands. More: docs/league.md.\n"
      "Examples:\n"
      "  fulbito replay send game.fbr                              at the league's addresses, in real time\n"
      "  fulbito replay send game.fbr --from 40 --to 50 --loop     the same ten seconds until Ctrl-C\n"
      "  fulbito replay send game.fbr --speed 4 --port-base 11000 --interface 127.0.0.1");
  command->add_option("file", options.file, "recording of a match (.fbr)")->required();
  number(command->add_option("--speed", options.speed, "pace over real time"))
      ->check(CLI::Range(0.1, 20.0))
      ->type_name("NUMBER")
      ->capture_default_str();
  number(command->add_option("--from", options.from, "start [s] (default: the beginning)"))->type_name("S");
  number(command->add_option("--to", options.to, "end [s] (default: the end)"))->type_name("S");
  command->add_flag("--loop", options.loop, "start again at the end, until Ctrl-C");
  wholeNumber(command->add_option("--port-base", options.port_base,
                                  "port of vision; the referee's follows as in fulbito serve"),
              1, wire::kLargestPortBase)
      ->type_name("PORT")
      ->capture_default_str();
  command
      ->add_option("--interface", options.interface,
                   "address of the interface for multicast (default: the system's choice)")
      ->type_name("ADDRESS");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int replaySend(const ReplaySendCommand& options) {
  const auto recording = RecordingReader::open(options.file);
  if (!recording) return report(recording.error());
  const auto told = ToldRecording::read(*recording);
  if (!told) return report(inFile(options.file, told.error()).value());
  const auto range = rangeOf(options, *told);
  if (!range) return report(range.error());
  auto vision =
      wire::UdpSender::open({wire::kVisionGroup, options.port_base + wire::kVisionOffset}, options.interface);
  if (!vision) return report(vision.error());
  auto referee = wire::UdpSender::open({wire::kRefereeGroup, options.port_base + wire::kRefereeOffset},
                                       options.interface);
  if (!referee) return report(referee.error());
  Sender sender(std::move(*vision), std::move(*referee), *told, options.speed);
  do {
    sender.send(*range);
  } while (options.loop && !interrupted());
  print(options, *told, *range, sender.counts());
  return interrupted() ? interruptedCode() : kOk;
}

}  // namespace fulbito::app
