#pragma once

#include <string>

#include "fulbito/detail/values.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// `fulbito replay export FILE --html`: a page with the viewer in it.
struct HtmlExport {
  std::string html;   ///< output file; - for stdout; empty: none
  std::string ghost;  ///< second recording, drawn over the first; empty: none
};

/// Adds --html and --ghost to `export`.
void addHtmlOptions(CLI::App& command, HtmlExport& options);

/// The page of a recording. Errors: as RecordingReader::open, with the file's name.
Result<std::string> replayPage(const std::string& file);

/// Writes the page of the recording `file` and returns the exit code.
int replayExportHtml(const std::string& file, const HtmlExport& options);

}  // namespace fulbito::app
