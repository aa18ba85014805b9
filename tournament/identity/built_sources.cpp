#include "tournament/identity/built_sources.hpp"

#include <algorithm>

#include "engine/core/base/wide_hash.hpp"
#include "fulbito/detail/build_info.hpp"
#include "tournament/identity/identity.hpp"

namespace fulbito {

std::string_view sourcesOf(std::string_view group) {
  const auto all = builtSources();
  const auto at = std::find_if(all.begin(), all.end(), [&](const SourceHash& s) { return s.group == group; });
  return at == all.end() ? std::string_view{} : at->hash;
}

std::string engineIdentity() {
  WideHash hash;
  hash.add(sourcesOf("engine"));
  hash.add(buildInfo().box2d);
  return hexText(hash.value());
}

}  // namespace fulbito
