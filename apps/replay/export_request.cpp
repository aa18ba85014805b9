#include "apps/replay/export_request.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "apps/common/console.hpp"
#include "engine/core/system/error_text.hpp"
#include "engine/core/system/output_file.hpp"
#include "engine/core/system/worker_threads.hpp"
#include "replays/verify/expand.hpp"

namespace fulbito::app {
namespace {

constexpr double kAround = 5.0;  // [s] before and after an event
constexpr int kLeastSide = 160, kMostSide = 16384;
constexpr std::size_t kMostDrawers = 256;  // largest number of threads, since each has its own canvas
constexpr std::size_t kShownCalls = 20;

tl::unexpected<Error> usage(std::string message) { return fail(ErrorCode::kUsage, std::move(message)); }

Result<ReplayTimeline> readTimeline(const std::string& file) {
  auto recording = RecordingReader::open(file);
  if (!recording) return tl::unexpected<Error>(recording.error());
  if (recording->header().level != RecordingLevel::kFull) {
    auto full = expanded(*recording);
    if (!full) return inFile(file, full.error());
    recording = std::move(full);
  }
  auto timeline = ReplayTimeline::read(*recording);
  if (!timeline) return inFile(file, timeline.error());
  return timeline;
}

Result<void> checkTime(const char* flag, double seconds, const ReplayTimeline& timeline) {
  if (seconds >= 0.0 && seconds <= timeline.seconds() + 1e-9) return {};
  return usage(
      fmt::format("{} {}: the recording lasts from 0 to {:.2f} s", flag, seconds, timeline.seconds()));
}

Result<void> setRange(const ReplayExportCommand& options, ExportRequest& request) {
  const ReplayTimeline& timeline = request.timeline;
  request.whole = {options.from.value_or(0.0), options.to.value_or(timeline.seconds())};
  if (auto good = checkTime("--from", request.whole.from, timeline); !good) return good;
  if (auto good = checkTime("--to", request.whole.to, timeline); !good) return good;
  for (const double at : options.at) {
    if (auto good = checkTime("--at", at, timeline); !good) return good;
  }
  if (request.whole.from <= request.whole.to) return {};
  return usage(fmt::format("--from {} is after --to {}", request.whole.from, request.whole.to));
}

/// Whether the event name `name` covers a clause: "penalty" covers all penalties, "goals" means "goal".
bool means(std::string name, const std::string& clause) {
  if (name == clause || clause.starts_with(name + ".")) return true;
  if (!name.ends_with('s')) return false;
  name.pop_back();
  return name == clause || clause.starts_with(name + ".");
}

/// The events that --around selects: all with a name, or only one of them, as in "goals:2".
struct EventChoice {
  std::string name;
  std::optional<std::size_t> number;  ///< number of the event, from 1; empty: all
};

Result<EventChoice> eventChoice(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return EventChoice{text, {}};
  std::size_t number = 0;
  const char *begin = text.data() + colon + 1, *end = text.data() + text.size();
  const auto [stop, wrong] = std::from_chars(begin, end, number);
  if (wrong == std::errc() && stop == end && number > 0) return EventChoice{text.substr(0, colon), number};
  return usage(fmt::format("--around {}: the number after the colon must be 1 or more, as in goals:1", text));
}

Result<void> findEvents(const EventChoice& choice, const char* flag, ExportRequest& request) {
  const std::string& name = choice.name;
  std::set<std::string> known;
  for (const RecordedEvent& event : request.timeline.events()) {
    const double seconds = request.timeline.secondsAt(event.tick);
    const bool within = seconds >= request.whole.from && seconds <= request.whole.to;
    if (event.clause != "placement" && within) known.insert(event.clause);
    if (within && means(name, event.clause)) request.events.push_back(event);
  }
  if (choice.number && !request.events.empty()) {
    if (*choice.number > request.events.size()) {
      return usage(fmt::format("{} {}:{}: there are {} from {:.2f} to {:.2f} s", flag, name, *choice.number,
                               request.events.size(), request.whole.from, request.whole.to));
    }
    request.events = {request.events[*choice.number - 1]};
  }
  if (!request.events.empty()) return {};
  std::vector<std::string> shown(known.begin(), known.end());
  if (shown.size() > kShownCalls) {
    shown.resize(kShownCalls);
    shown.push_back(fmt::format("{} more", known.size() - kShownCalls));
  }
  return usage(fmt::format("{}: there is no '{}' from {:.2f} to {:.2f} s. Recorded events: {}", flag, name,
                           request.whole.from, request.whole.to,
                           shown.empty() ? "none" : fmt::format("{}", fmt::join(shown, ", "))));
}

std::optional<int> sideOf(std::string_view text) {
  int side = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (wrong != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return side >= kLeastSide && side <= kMostSide ? std::optional(side) : std::nullopt;
}

Result<void> setSize(const std::string& size, ExportRequest& request) {
  if (size.empty()) return {};
  const std::size_t x = size.find('x');
  const auto width = sideOf(std::string_view(size).substr(0, x));
  const auto height =
      x == std::string::npos ? std::optional(0) : sideOf(std::string_view(size).substr(x + 1));
  if (!width || !height) {
    return usage(fmt::format("--size '{}': must be a width, or WIDTHxHEIGHT, of {} to {} pixels", size,
                             kLeastSide, kMostSide));
  }
  request.spec.width = *width;
  request.spec.height = *height;
  request.sized = true;
  return {};
}

Result<void> checkNumbers(const ReplayExportCommand& options) {
  const auto within = [](const char* flag, double value, double low, double high) -> Result<void> {
    if (value >= low && value <= high) return {};
    return usage(fmt::format("{} {}: must be {} to {}", flag, value, low, high));
  };
  if (auto good = within("--fps", options.fps.value_or(30.0), 0.01, 240.0); !good) return good;
  if (auto good = within("--speed", options.speed.value_or(1.0), 0.01, 1000.0); !good) return good;
  if (auto good = within("--trail", options.trail_seconds, 0.0, 60.0); !good) return good;
  if (auto good = within("--quality", options.quality, 0, 51); !good) return good;
  if (options.theme == "dark" || options.theme == "light") return {};
  return usage(fmt::format("--theme '{}': must be dark or light", options.theme));
}

}  // namespace

MatchPictureSpec ExportRequest::specOf(int width) const {
  MatchPictureSpec own = spec;
  if (!sized) own.width = width;
  if (own.height == 0) own.height = matchPictureHeight(own.field, own.width);
  return own;
}

std::vector<ReplayRange> ExportRequest::ranges() const {
  if (events.empty()) return {whole};
  std::vector<Tick> ticks;
  ticks.reserve(events.size());
  for (const RecordedEvent& event : events) ticks.push_back(event.tick);
  return rangesAround(timeline, ticks, kAround, kAround);
}

Result<ExportRequest> readRequest(const ReplayExportCommand& options) {
  if (auto good = checkNumbers(options); !good) return tl::unexpected<Error>(good.error());
  auto timeline = readTimeline(options.file);
  if (!timeline) return tl::unexpected<Error>(timeline.error());
  auto spec = pictureSpecOf(*timeline);
  if (!spec) return inFile(options.file, spec.error());
  ExportRequest request{&options, std::move(*timeline), std::move(*spec), false, {}, {}, {}, 1};
  request.spec.theme = options.theme == "light" ? PictureTheme::kLight : PictureTheme::kDark;
  request.overlays = {!options.no_banner, !options.no_drawings, options.trail_seconds};
  request.jobs = threadsFor(options.jobs, kMostDrawers);
  if (auto good = setSize(options.size, request); !good) return tl::unexpected<Error>(good.error());
  if (auto good = setRange(options, request); !good) return tl::unexpected<Error>(good.error());
  if (options.highlights || !options.around.empty()) {
    const bool around = !options.around.empty();
    const auto choice = eventChoice(around ? options.around : "goal");
    if (!choice) return tl::unexpected<Error>(choice.error());
    auto found = findEvents(*choice, around ? "--around" : "--highlights", request);
    if (!found) return tl::unexpected<Error>(found.error());
  }
  return request;
}

Result<std::string> outputFile(const ExportRequest& request, const ProductName& product,
                               const std::string& ending) {
  const std::filesystem::path recording(request.options->file);
  std::string file = product.given.empty() ? recording.stem().string() + ending : product.given;
  auto may = mayWrite({product.flag, file, {product.kind, Dash::kStdout}});
  if (!may) return tl::unexpected<Error>(may.error());
  return file;
}

std::string sizeText(std::size_t bytes) {
  return fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1000.0);
}

void announce(const std::string& file, const std::string& what) {
  if (file != "-") note("{}: {}\n", file, what);
}

Result<void> deliver(const std::string& file, const std::string& content) {
  if (file == "-") {
    writeOut(content);  // `finishOutput` reports failures
    return {};
  }
  if (auto written = writeFile(file, content); !written) return written;
  announce(file, sizeText(content.size()));
  return {};
}

}  // namespace fulbito::app
