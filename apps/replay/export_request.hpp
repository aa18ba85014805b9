#pragma once

#include <string>
#include <vector>

#include "apps/common/outputs.hpp"
#include "apps/replay/replay.hpp"
#include "fulbito/picture.hpp"
#include "fulbito/recording.hpp"
#include "replays/export/frames.hpp"

namespace fulbito::app {

/// The recording and the checked options that every product needs.
struct ExportRequest {
  const ReplayExportCommand* options = nullptr;
  ReplayTimeline timeline;
  MatchPictureSpec spec;  ///< theme and, if given, size
  bool sized = false;     ///< --size was given
  OverlayChoice overlays;
  ReplayRange whole;                  ///< --from ... --to
  std::vector<RecordedEvent> events;  ///< named by --around or --highlights, within `whole`
  int jobs = 1;

  /// The spec for a product; `width` [px] applies unless --size was given.
  MatchPictureSpec specOf(int width) const;
  /// `whole`, or 5 s around each event.
  std::vector<ReplayRange> ranges() const;
};

/// Opens the recording, simulates it again if it has no samples, and checks all flags against it.
/// Errors: as RecordingReader::open and `expanded`; kUsage naming the flag and its range.
Result<ExportRequest> readRequest(const ReplayExportCommand& options);

/// A product and the name that was given for its file; empty: none.
struct ProductName {
  const char* flag = "";
  OutputKind kind{};
  std::string given;
};

/// The name of a product: the given one, or the recording's with `ending` ("-trails.png"). Errors: of
/// `mayWrite`.
Result<std::string> outputFile(const ExportRequest& request, const ProductName& product,
                               const std::string& ending);

/// Writes the whole file or nothing; "-" is stdout. Names the file on stderr. Errors: kIo.
Result<void> deliver(const std::string& file, const std::string& content);
/// E.g. "71.2 kB".
std::string sizeText(std::size_t bytes);
/// Names the written file on stderr, unless it went to stdout.
void announce(const std::string& file, const std::string& what);

/// @{ The products. Errors: kUsage, kIo, kInterrupted.
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
