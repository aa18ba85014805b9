#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/page_scene.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// How the scenes of a page relate to each other.
enum class PageKind : std::uint8_t {
  kReplay,  ///< one scene
  kGhost,   ///< two scenes with the same bodies: the second is drawn faintly over the first
  kRaces    ///< any number of races to choose from
};

struct Page {
  PageKind kind = PageKind::kReplay;
  std::string title;
  std::vector<PageScene> scenes;
};

/// The viewer with these scenes as one self-contained HTML file. The same page gives the same bytes. Errors:
/// kUsage for a page without a scene, or a ghost with different bodies.
Result<std::string> htmlPage(const Page& page);

}  // namespace fulbito
