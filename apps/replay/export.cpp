#include <algorithm>

#include <CLI/CLI.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/replay/export_flags.hpp"
#include "apps/replay/export_request.hpp"
#include "apps/replay/replay.hpp"

namespace fulbito::app {
namespace {

/// An output of the command, and whether the user wants it.
struct Product {
  bool wanted;
  Result<void> (*make)(const ExportRequest&);
};

std::vector<Product> productsOf(const ReplayExportCommand& options) {
  return {{options.png.has_value(), exportPng},       {options.contact_sheet.has_value(), exportContactSheet},
          {options.trails.has_value(), exportTrails}, {!options.heatmap.empty(), exportHeatMap},
          {options.svg.has_value(), exportSvg},       {options.gif.has_value(), exportGif},
          {options.mp4.has_value(), exportMp4},       {options.webm.has_value(), exportWebm},
          {options.csv.has_value(), exportCsv},       {options.jsonl.has_value(), exportJsonLines}};
}

constexpr const char* kProducts = "Products (OUT: a file, - for stdout; default: named after the recording)";

/// Adds an option with an optional file name. Without one, the product is named after the recording.
void addProduct(CLI::App& command, const char* flag, std::optional<std::string>& file, OutputKind kind,
                const char* what, Existing existing = Existing::kRefused) {
  CLI::Option* option = command.add_option_function<std::vector<std::string>>(
      flag, [&file](const std::vector<std::string>& words) { file = words.empty() ? "" : words.front(); },
      what);
  option->expected(0, 1)->type_name("[OUT]")->group(kProducts);
  markOutput(option, {kind, Dash::kStdout, existing});
}

void addProducts(CLI::App& command, ReplayExportCommand& options) {
  addProduct(command, "--png", options.png, OutputKind::kPng,
             "stills at --at or --around, at --fps from --from to --to, or of the last frame",
             Existing::kLater);
  addProduct(command, "--contact-sheet", options.contact_sheet, OutputKind::kPng,
             "twelve small pictures in one, or one per event");
  addProduct(command, "--trails", options.trails, OutputKind::kPng, "paths of all bodies over the field",
             Existing::kLater);
  markOutput(command
                 .add_option("--heatmap", options.heatmap,
                             "heat map of the ball, blue, yellow or one robot (blue:1)")
                 ->expected(1, 2)
                 ->type_name("WHO [OUT]")
                 ->group(kProducts),
             {OutputKind::kPng, Dash::kStdout, Existing::kRefused, 1});
  addProduct(command, "--svg", options.svg, OutputKind::kSvg, "one moment as a scalable drawing",
             Existing::kLater);
  addProduct(command, "--gif", options.gif, OutputKind::kGif,
             "an animation (480 px wide, 12.5 frames per second)");
  addProduct(command, "--mp4", options.mp4, OutputKind::kMp4,
             "a video (900 px wide, 30 frames per second; needs ffmpeg)");
  addProduct(command, "--webm", options.webm, OutputKind::kWebm, "the same video for web pages");
  addProduct(command, "--csv", options.csv, OutputKind::kCsv,
             "a table with one line per sample: clock, score, all poses");
  addProduct(command, "--jsonl", options.jsonl, OutputKind::kJsonLines,
             "the same and all events, one JSON object per line");
}

void addWhen(CLI::App& command, ReplayExportCommand& options) {
  command.add_option("--at", options.at, "times of stills [s], one or more")->group("When");
  command
      .add_option("--around", options.around,
                  "events: goals, penalty, half ..., or one of them: goals:1; films show 5 s around it")
      ->group("When");
  command.add_flag("--highlights", options.highlights, "the same as --around goals")->group("When");
  command.add_option("--from", options.from, "start [s] (default: the beginning)")->group("When");
  command.add_option("--to", options.to, "end [s] (default: the end)")->group("When");
  command.add_option("--fps", options.fps, "frames per second, 0.01 ... 240")->group("When");
  command
      .add_option("--speed", options.speed,
                  "speed of films, 1 = real time (default: 1 for events and up to 30 s, else 4)")
      ->group("When");
}

void addLook(CLI::App& command, ReplayExportCommand& options) {
  command.add_option("--size", options.size, "width, or width x height [px]")
      ->type_name("SIZE")
      ->group("How");
  command.add_option("--theme", options.theme, "colour theme: dark or light")
      ->capture_default_str()
      ->group("How");
  command.add_option("--trail", options.trail_seconds, "length of the trails [s], 0 ... 60")
      ->capture_default_str()
      ->group("How");
  command.add_flag("--no-banner", options.no_banner, "do not show the referee's calls")->group("How");
  command.add_flag("--no-drawings", options.no_drawings, "do not show what the teams drew")->group("How");
  command.add_option("--quality", options.quality, "quality of videos, 0 (best) ... 51 (smallest)")
      ->capture_default_str()
      ->group("How");
  addJobs(command, options.jobs, "drawing threads")->group("How");
  addForce(command, "replace existing files")->group("How");
}

Result<void> checkProducts(const std::vector<Product>& products, const HtmlExport& html) {
  const bool wanted = !html.html.empty() || std::any_of(products.begin(), products.end(),
                                                        [](const Product& p) { return p.wanted; });
  if (wanted) return {};
  return fail(
      ErrorCode::kUsage,
      "export: needs a product: --png, --gif, --mp4, --html, --csv ... See fulbito replay export --help.");
}

}  // namespace

CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options) {
  CLI::App* command = replay.add_subcommand("export", "make pictures, films and tables from a recording");
  command->footer(
      "Examples:\n"
      "  fulbito replay export game.fbr --png shot.png --at 83.2\n"
      "  fulbito replay export game.fbr --png goal.png --around goals     goal-0001.png ...\n"
      "  fulbito replay export game.fbr --gif goal.gif --around goals:1   the first goal in real time\n"
      "  fulbito replay export game.fbr --gif goals.gif --highlights\n"
      "  fulbito replay export game.fbr --html game.html                  an HTML page with a viewer\n"
      "  fulbito replay export game.fbr --html both.html --ghost other.fbr\n"
      "  fulbito replay export game.fbr --mp4 game.mp4                    the whole match, 4 x real time\n"
      "  fulbito replay export game.fbr --heatmap ball --theme light --size 1920\n"
      "  fulbito replay export game.fbr --csv - --from 60 --to 90 | head\n"
      "More: docs/pictures.md.");
  options.command = command;
  command->add_option("file", options.file, "recording (.fbr)")->required();
  addProducts(*command, options);
  addHtmlOptions(*command, options.html);
  addWhen(*command, options);
  addLook(*command, options);
  return command;
}

int replayExport(const ReplayExportCommand& options) {
  const std::vector<Product> products = productsOf(options);
  if (auto good = checkProducts(products, options.html); !good) return report(good.error());
  if (auto good = checkExportFlags(options); !good) return report(good.error());
  if (!options.html.html.empty()) {
    if (const int code = replayExportHtml(options.file, options.html); code != kOk) return code;
  }
  if (std::none_of(products.begin(), products.end(), [](const Product& p) { return p.wanted; })) return kOk;
  const auto request = readRequest(options);
  if (!request) return report(request.error());
  for (const Product& product : products) {
    if (!product.wanted) continue;
    if (auto made = product.make(*request); !made) return report(made.error());
    if (interrupted()) return interruptedCode();
  }
  return kOk;
}

}  // namespace fulbito::app
