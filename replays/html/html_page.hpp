#pragma once

#include <string>
#include <vector>

#include "engine/core/base/result.hpp"
#include "replays/html/page_scene.hpp"

namespace fulbito {

/// How the scenes of a page belong together.
enum class PageKind : std::uint8_t {
  kReplay,  ///< one scene
  kGhost,   ///< two of the same bodies: the second is drawn over the first, faintly
  kRaces    ///< any number of races to choose from
};

struct Page {
  PageKind kind = PageKind::kReplay;
  std::string title;
  std::vector<PageScene> scenes;
};

/// The viewer with these scenes as one HTML file that needs no network, no server and nothing else. The same
/// page gives the same bytes. Errors: kUsage for a page without a scene or a ghost that is not of the same
/// bodies.
Result<std::string> htmlPage(const Page& page);

}  // namespace fulbito
