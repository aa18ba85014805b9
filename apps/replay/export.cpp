#include <algorithm>

#include <CLI/CLI.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/option_values.hpp"
#include "apps/replay/export_flags.hpp"
#include "apps/replay/export_request.hpp"
#include "apps/replay/replay.hpp"

namespace fulbito::app {
namespace {

/// A product and whether it was asked for.
struct Product {
  bool wanted;
  const std::string* file;  ///< null: has more than a file
  Result<void> (*make)(const ExportRequest&);
};

const std::string* nameIn(const std::optional<std::string>& file) { return file ? &*file : nullptr; }

std::vector<Product> productsOf(const ReplayExportCommand& options) {
  const std::string* heat = options.heatmap.size() > 1 ? &options.heatmap[1] : nullptr;
  return {{options.png.has_value(), nameIn(options.png), exportPng},
          {options.contact_sheet.has_value(), nameIn(options.contact_sheet), exportContactSheet},
          {options.trails.has_value(), nameIn(options.trails), exportTrails},
          {!options.heatmap.empty(), heat, exportHeatMap},
          {options.svg.has_value(), nameIn(options.svg), exportSvg},
          {options.gif.has_value(), nameIn(options.gif), exportGif},
          {options.mp4.has_value(), nameIn(options.mp4), exportMp4},
          {options.webm.has_value(), nameIn(options.webm), exportWebm},
          {options.csv.has_value(), nameIn(options.csv), exportCsv},
          {options.jsonl.has_value(), nameIn(options.jsonl), exportJsonLines}};
}

/// An option that may stand alone: the product is then named after the recording.
void addProduct(CLI::App& command, const char* flag, std::optional<std::string>& file, const char* what) {
  command
      .add_option_function<std::vector<std::string>>(
          flag, [&file](const std::vector<std::string>& words) { file = words.empty() ? "" : words.front(); },
          what)
      ->expected(0, 1)
      ->type_name("[OUT]")
      ->group("What to make (OUT: a file, - for stdout; default: named after the recording)");
}

void addProducts(CLI::App& command, ReplayExportCommand& options) {
  addProduct(command, "--png", options.png,
             "stills at the times --at, at the events --around, or every 1/--fps s from --from to --to; "
             "otherwise the last frame");
  addProduct(command, "--contact-sheet", options.contact_sheet,
             "twelve small pictures in one, or one an event");
  addProduct(command, "--trails", options.trails, "the ways of all over the field");
  command.add_option("--heatmap", options.heatmap, "heat map of ball, blue, yellow or one robot (blue:1)")
      ->expected(1, 2)
      ->type_name("WHO [OUT]")
      ->group("What to make (OUT: a file, - for stdout; default: named after the recording)");
  addProduct(command, "--svg", options.svg, "one moment as a drawing of any size");
  addProduct(command, "--gif", options.gif, "an animation (480 wide, 12.5 frames a second)");
  addProduct(command, "--mp4", options.mp4, "a video, by ffmpeg (900 wide, 30 frames a second)");
  addProduct(command, "--webm", options.webm, "the same for the web");
  addProduct(command, "--csv", options.csv, "a line a sample: clock, score, every pose");
  addProduct(command, "--jsonl", options.jsonl, "the same and all events as JSON, an object a line");
}

void addWhen(CLI::App& command, ReplayExportCommand& options) {
  command.add_option("--at", options.at, "seconds of the recording")->group("When");
  command
      .add_option(
          "--around", options.around,
          "events: goals, penalty, free-ball, half ..., or one of them: goals:1; films show 5 s around each")
      ->group("When");
  command.add_flag("--highlights", options.highlights, "the same as --around goals")->group("When");
  command.add_option("--from", options.from, "seconds (default: the beginning)")->group("When");
  command.add_option("--to", options.to, "seconds (default: the end)")->group("When");
  command.add_option("--fps", options.fps, "frames a second, 0.01 ... 240")->group("When");
  command
      .add_option(
          "--speed", options.speed,
          "playback speed of films: 1 = real time (default: 1 with --around or --highlights and up to "
          "30 s, else 4)")
      ->group("When");
}

void addLook(CLI::App& command, ReplayExportCommand& options) {
  command.add_option("--size", options.size, "W or WxH, pixels")->type_name("SIZE")->group("How");
  command.add_option("--theme", options.theme, "dark or light")->capture_default_str()->group("How");
  command.add_option("--trail", options.trail_seconds, "seconds of trails, 0 ... 60")
      ->capture_default_str()
      ->group("How");
  command.add_flag("--no-banner", options.no_banner, "without the referee's calls")->group("How");
  command.add_flag("--no-drawings", options.no_drawings, "without what the teams drew")->group("How");
  command.add_option("--quality", options.quality, "of videos, 0 (best) ... 51")
      ->capture_default_str()
      ->group("How");
  addJobs(command, options.jobs, "threads that draw")->group("How");
  command.add_flag("--force", options.force, "replace files that exist")->group("How");
}

Result<void> checkProducts(const std::vector<Product>& products, const HtmlExport& html) {
  int wanted = html.html.empty() ? 0 : 1, to_stdout = html.html == "-" ? 1 : 0;
  for (const Product& product : products) {
    wanted += product.wanted ? 1 : 0;
    to_stdout += product.wanted && product.file != nullptr && *product.file == "-" ? 1 : 0;
  }
  if (wanted == 0) {
    return fail(
        ErrorCode::kUsage,
        "export: say what to make: --png, --gif, --mp4, --html, --csv ... See fulbito replay export --help.");
  }
  if (to_stdout > 1) return fail(ErrorCode::kUsage, "export: only one product can go to stdout");
  return {};
}

}  // namespace

CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options) {
  CLI::App* command = replay.add_subcommand("export", "make pictures, films and tables of a recording");
  command->footer(
      "Examples:\n"
      "  fulbito replay export game.fbr --png shot.png --at 83.2\n"
      "  fulbito replay export game.fbr --png goal.png --around goals     goal-0001.png ...\n"
      "  fulbito replay export game.fbr --gif goal.gif --around goals:1   the first goal, as fast as it was\n"
      "  fulbito replay export game.fbr --gif goals.gif --highlights\n"
      "  fulbito replay export game.fbr --html game.html                  a page to look at it\n"
      "  fulbito replay export game.fbr --html both.html --ghost other.fbr\n"
      "  fulbito replay export game.fbr --mp4 game.mp4                    the whole match, 4 times as fast\n"
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
    if (const int code = replayExportHtml(options.file, options.html, options.force); code != kOk)
      return code;
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
