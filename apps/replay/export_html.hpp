#pragma once

#include <string>

#include "fulbito/detail/values.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay export FILE --html`, which writes a page with the viewer.
struct HtmlExport {
  std::string html;   ///< output file; - for stdout; empty: none
  std::string ghost;  ///< second recording, drawn over the first; empty: none
};

/// Adds --html and --ghost to `export`.
void addHtmlOptions(CLI::App& command, HtmlExport& options);

/// The HTML page of a recording. Errors: as `RecordingReader::open`, with the file's name.
Result<std::string> replayPage(const std::string& file);

/// Writes the page of the recording `file` and returns the exit code.
int replayExportHtml(const std::string& file, const HtmlExport& options);

}  // namespace fulbito::app
