#pragma once

#include <string>

namespace fulbito::app {

/// `fulbito replay export FILE --html`.
struct HtmlExport {
  std::string file;   ///< recording
  std::string html;   ///< to be written; - for stdout
  std::string ghost;  ///< second recording, drawn over the first; empty: none
};

/// Returns the exit code.
int replayExportHtml(const HtmlExport& options);

}  // namespace fulbito::app
