#pragma once

#include <string>
#include <vector>

#include "apps/common/outputs.hpp"
#include "apps/replay/replay.hpp"
#include "fulbito/picture.hpp"
#include "fulbito/recording.hpp"
#include "replays/export/frames.hpp"

namespace fulbito::app {

/// The recording and the checked options, shared by all products.
struct ExportRequest {
  const ReplayExportCommand* options = nullptr;
  ReplayTimeline timeline;
  MatchPictureSpec spec;  ///< theme and, if given, size
  bool sized = false;     ///< whether --size was given
  OverlayChoice overlays;
  ReplayRange whole;                  ///< the time range --from ... --to
  std::vector<RecordedEvent> events;  ///< events selected by --around or --highlights, within `whole`
  int jobs = 1;

  /// The picture spec for a product. `width` [px] is used unless --size was given.
  MatchPictureSpec specOf(int width) const;
  /// The ranges to show: `whole`, or 5 s around each event.
  std::vector<ReplayRange> ranges() const;
};

/// Opens the recording, simulates it again if it has no samples, and checks all flags against it. Errors: as
/// `RecordingReader::open` and `expanded`; kUsage naming the flag and its range.
Result<ExportRequest> readRequest(const ReplayExportCommand& options);

/// A product, and the file name given for it; empty: none was given.
struct ProductName {
  const char* flag = "";
  OutputKind kind{};
  std::string given;
};

/// The file name of a product: the given one, or the recording's name with `ending` ("-trails.png"). Errors:
/// of `mayWrite`.
Result<std::string> outputFile(const ExportRequest& request, const ProductName& product,
                               const std::string& ending);

/// Writes a complete file or nothing; "-" means stdout. Prints the file's name on stderr. Errors: kIo.
Result<void> deliver(const std::string& file, const std::string& content);
/// A size as text, e.g. "71.2 kB".
std::string sizeText(std::size_t bytes);
/// Prints the name of the written file on stderr, unless the output went to stdout.
void announce(const std::string& file, const std::string& what);

/// @{ Write the products. Errors: kUsage, kIo, kInterrupted.
Result<void> exportPng(const ExportRequest& request);
Result<void> exportContactSheet(const ExportRequest& request);
Result<void> exportTrails(const ExportRequest& request);
Result<void> exportHeatMap(const ExportRequest& request);
Result<void> exportSvg(const ExportRequest& request);
Result<void> exportGif(const ExportRequest& request);
Result<void> exportMp4(const ExportRequest& request);
Result<void> exportWebm(const ExportRequest& request);
Result<void> exportCsv(const ExportRequest& request);
Result<void> exportJsonLines(const ExportRequest& request);
/// @}

}  // namespace fulbito::app
