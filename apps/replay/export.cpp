#include <algorithm>

#include <CLI/CLI.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/option_values.hpp"
#include "apps/replay/export_flags.hpp"
#include "apps/replay/export_request.hpp"
#include "apps/replay/replay.hpp"

namespace fulbito::app {
namespace {

/// A product and whether the user wants it.
struct Product {
  bool wanted;
  const std::string* file;  ///< null: not given
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

/// An option whose file name may be omitted: the product is then named after the recording.
void addProduct(CLI::App& command, const char* flag, std::optional<std::string>& file, const char* what) {
  command
      .add_option_function<std::vector<std::string>>(
          flag, [&file](const std::vector<std::string>& words) { file = words.empty() ? "" : words.front(); },
          what)
      ->expected(0, 1)
      ->type_name("[OUT]")
      ->group("Products (OUT: a file, - for stdout; default: named after the recording)");
}

void addProducts(CLI::App& command, ReplayExportCommand& options) {
  addProduct(command, "--png", options.png,
             "stills at --at or --around, at --fps from --from to --to, or of the last frame");
  addProduct(command, "--contact-sheet", options.contact_sheet,
             "twelve small pictures in one, or one per event");
  addProduct(command, "--trails", options.trails, "paths of all bodies over the field");
  command
      .add_option("--heatmap", options.heatmap, "heat map of the ball, blue, yellow or one robot (blue:1)")
      ->expected(1, 2)
      ->type_name("WHO [OUT]")
      ->group("Products (OUT: a file, - for stdout; default: named after the recording)");
  addProduct(command, "--svg", options.svg, "one moment as a scalable drawing");
  addProduct(command, "--gif", options.gif, "an animation (480 px wide, 12.5 frames per second)");
  addProduct(command, "--mp4", options.mp4, "a video (900 px wide, 30 frames per second; needs ffmpeg)");
  addProduct(command, "--webm", options.webm, "the same video for web pages");
  addProduct(command, "--csv", options.csv, "a table with one line per sample: clock, score, all poses");
  addProduct(command, "--jsonl", options.jsonl, "the same and all events, one JSON object per line");
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
  command.add_flag("--force", options.force, "replace existing files")->group("How");
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
        "export: needs a product: --png, --gif, --mp4, --html, --csv ... See fulbito replay export --help.");
  }
  if (to_stdout > 1) return fail(ErrorCode::kUsage, "export: only one product can go to stdout");
  return {};
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
