#include "python/environments/episodes.hpp"

namespace fulbito {

Result<void> EpisodeSource::record(const std::string&) {
  return fail(ErrorCode::kUsage, "this environment has no recordings");
}

Result<Canvas> EpisodeSource::picture(int) {
  return fail(ErrorCode::kUsage, "this environment has no pictures");
}

}  // namespace fulbito
