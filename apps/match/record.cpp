#include "apps/match/record.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/league/heard_recorder.hpp"
#include "bridge/wire/wire_client.hpp"
#include "engine/core/base/text_controls.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLook = 0.05;       // [s] between looks for signals while nothing comes
constexpr double kAfterHalt = 0.25;  // [s] without a frame after a halt: the match is over

/// Why a recording ended. Names are those of the JSON.
enum class End { kInterrupted, kSeconds, kHalt, kSilence, kAnew };
constexpr const char* kEndNames[] = {"interrupted", "seconds", "halt", "silence", "anew"};
constexpr const char* kEndWords[] = {"stopped", "as long as asked for", "the referee halted the match",
                                     "vision stopped", "the server began anew"};

double secondsNow() { return static_cast<double>(now()) * 1e-9; }

/// Records until there is a reason to end. Errors: as `HeardRecorder::see`; kIo if nobody sends.
Result<End> recordUntilEnd(wire::WireListener& listener, HeardRecorder& recorder,
                           const RecordCommand& options, std::int64_t& malformed) {
  double heard_at = secondsNow();
  while (!interrupted()) {
    const wire::Heard heard = listener.listen(kLook);
    malformed += heard.malformed;
    const std::int64_t before = recorder.counts().frames;
    std::size_t taken = 0;
    const auto take_until = [&](std::size_t end) {
      for (; taken < end; ++taken) recorder.take(heard.commands[taken]);
    };
    for (const wire::HeardFrame& frame : heard.frames) {
      take_until(frame.commands);
      const auto goes_on = recorder.see(frame.vision, frame.sender, secondsNow());
      if (!goes_on) return tl::unexpected<Error>(goes_on.error());
      if (!*goes_on) return End::kAnew;
      if (options.seconds && recorder.seconds() >= *options.seconds) return End::kSeconds;
    }
    take_until(heard.commands.size());
    if (options.until_halt && recorder.halted()) return End::kHalt;
    const std::int64_t frames = recorder.counts().frames;
    if (frames > before) heard_at = secondsNow();
    const double silent = secondsNow() - heard_at;
    if (frames == 0 && options.wait > 0.0 && silent > options.wait) {
      return fail(ErrorCode::kIo, fmt::format("no vision came within {:g} s; is a server running at these "
                                              "--port-base and --interface?",
                                              options.wait));
    }
    if (frames > 0 && recorder.halted() && silent > kAfterHalt) return End::kHalt;
    if (frames > 0 && silent > options.patience) return End::kSilence;
  }
  return End::kInterrupted;
}

void print(const RecordCommand& options, const HeardRecorder& recorder, End end, std::int64_t malformed) {
  const HeardCounts& counts = recorder.counts();
  const PerTeam<int> score = recorder.score();
  if (!options.json) {
    say("{}: {:.1f} s, {} frames; {}\n", options.file, recorder.seconds(), counts.frames,
        kEndWords[static_cast<int>(end)]);
    say("{} {} : {} {}; commands of the referee {}\n", options.settings.blue, score[0], score[1],
        options.settings.yellow, counts.commands);
    say("gaps {} of {} frames in all; left out: late frames {}, frames with impossible values {}, of another "
        "server {}; unknown robots {}, malformed datagrams {}\n",
        counts.gaps, counts.lost, counts.late, counts.odd, counts.strangers, counts.unknown, malformed);
    return;
  }
  const Json json{{"schema_version", 1},
                  {"file", options.file},
                  {"end", kEndNames[static_cast<int>(end)]},
                  {"seconds", recorder.seconds()},
                  {"frames", counts.frames},
                  {"gaps", counts.gaps},
                  {"lost", counts.lost},
                  {"late", counts.late},
                  {"odd", counts.odd},
                  {"strangers", counts.strangers},
                  {"unknown", counts.unknown},
                  {"malformed", malformed},
                  {"commands", counts.commands},
                  {"halted", recorder.halted()},
                  {"score", {{"blue", score[0]}, {"yellow", score[1]}}}};
  writeOut(escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n");
}

void addServer(CLI::App& command, RecordCommand& options) {
  const auto group = [](CLI::Option* option) { return option->group("Server"); };
  group(wholeNumber(command.add_option("--port-base", options.port_base,
                                       "port of vision; the referee's follows as in fulbito serve"),
                    1, wire::kLargestPortBase))
      ->type_name("N")
      ->capture_default_str();
  group(command.add_option("--interface", options.interface,
                           "address of the interface for multicast (default: the system's choice)"))
      ->type_name("ADDRESS");
  const auto time = [&](const char* flag, double& value, double least, const char* what) {
    group(number(command.add_option(flag, value, what)))
        ->check(CLI::Range(least, 86400.0))
        ->type_name("S")
        ->capture_default_str();
  };
  time("--wait", options.wait, 0.0, "longest wait for the first frame [s]; 0: no limit");
  time("--patience", options.patience, 0.1, "time without vision after which the recording ends [s]");
}

}  // namespace

CLI::App* addRecord(CLI::App& app, RecordCommand& options) {
  options.settings.blue = nameOf(TeamId::kBlue);
  options.settings.yellow = nameOf(TeamId::kYellow);
  options.settings.robot = "firasim";
  CLI::App* command = app.add_subcommand(
      "record", "record what the league's simulator or fulbito serve sends to its clients");
  command->footer(
      "Examples:\n"
      "  fulbito record game.fbr                                     then: fulbito view game.fbr\n"
      "  fulbito record game.fbr --blue GER --yellow NeonFC --seconds 60\n"
      "  fulbito record game.fbr --port-base 11000 --interface 127.0.0.1 --wait 30 --json\n"
      "It ends with the match of fulbito serve, once vision has stopped, or with Ctrl-C.\n"
      "fulbito replay send plays it back. More: docs/league.md.");
  markOutput(command->add_option("file", options.file, "recording to write (.fbr)")->required(),
             {OutputKind::kRecording});
  command->add_option("--blue", options.settings.blue, "name of the blue team")->capture_default_str();
  command->add_option("--yellow", options.settings.yellow, "name of the yellow team")->capture_default_str();
  number(command->add_option("--seconds", options.seconds, "length after which the recording ends [s]"))
      ->check(CLI::PositiveNumber)
      ->type_name("S");
  command->add_flag("--until-halt", options.until_halt, "end at HALT even if vision goes on");
  addServer(*command, options);
  command->add_option("--rules", options.settings.rules, "rules profile or TOML file, for field and teams")
      ->capture_default_str();
  command
      ->add_option("--physics", options.settings.physics, "physics profile or TOML file, for the frame rate")
      ->capture_default_str();
  command->add_option("--robot", options.settings.robot, "robots of the server, a preset or TOML file")
      ->capture_default_str();
  addForce(*command, "replace an existing file");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int record(const RecordCommand& options) {
  auto config = configWithoutTeams(options.settings);
  if (!config) return report(config.error());
  config->teams[0].text = options.settings.blue;
  config->teams[1].text = options.settings.yellow;
  auto listener = wire::WireListener::open(options.port_base, options.interface);
  if (!listener) return report(listener.error());
  HeardRecorder recorder(*config, [&](const RecordingHeader& header) {
    note("recording {}\n", options.file);
    // What exists may be replaced by now, or the command would have been refused.
    return RecordingWriter::create(options.file, header);
  });
  note("waiting for vision on {}:{}\n", wire::kVisionGroup, options.port_base + wire::kVisionOffset);
  std::int64_t malformed = 0;
  const auto end = recordUntilEnd(*listener, recorder, options, malformed);
  if (!end) return report(end.error());
  if (recorder.counts().frames == 0) {
    note("no vision came; nothing was written\n");
    return interruptedCode();
  }
  if (auto written = recorder.finish(); !written) return report(written.error());
  print(options, recorder, *end, malformed);
  return interrupted() ? interruptedCode() : kOk;
}

}  // namespace fulbito::app
