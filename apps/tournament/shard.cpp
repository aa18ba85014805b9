#include "apps/tournament/shard.hpp"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace fulbito::app {
namespace {

constexpr std::size_t kMostShards = 100'000;
constexpr const char* kAuto = "auto";

std::optional<std::size_t> numberOf(std::string_view text) {
  std::size_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::size_t> variable(const char* name) {
  const char* const text = std::getenv(name);
  return text == nullptr ? std::nullopt : numberOf(text);
}

tl::unexpected<Error> wrong(const std::string& text, const std::string& why) {
  return fail(ErrorCode::kUsage, fmt::format("--shard: {}, not '{}'", why, text));
}

/// The shard of a task in a Slurm array. Task numbers may begin anywhere and have any step.
std::optional<Shard> ofSlurm() {
  const auto task = variable("SLURM_ARRAY_TASK_ID"), least = variable("SLURM_ARRAY_TASK_MIN");
  const auto count = variable("SLURM_ARRAY_TASK_COUNT"), most = variable("SLURM_ARRAY_TASK_MAX");
  if (!task || !least || !count || !most || *task < *least || *count == 0) return std::nullopt;
  const std::size_t step = *count > 1 ? (*most - *least) / (*count - 1) : 1;
  return Shard{(*task - *least) / (step == 0 ? 1 : step), *count};
}

Result<Shard> checked(const std::string& text, const Shard& shard) {
  if (shard.count < 1 || shard.count > kMostShards) {
    return wrong(text, fmt::format("the number of shards is 1 ... {}", kMostShards));
  }
  if (shard.index >= shard.count) return wrong(text, fmt::format("there are {} shards", shard.count));
  return shard;
}

Result<Shard> automatic(const std::string& text, std::optional<std::size_t> count) {
  if (const auto slurm = ofSlurm()) {
    if (count && *count != slurm->count) {
      return wrong(text, fmt::format("the Slurm array has {} tasks", slurm->count));
    }
    return checked(text, *slurm);
  }
  const auto index = variable("JOB_COMPLETION_INDEX");
  if (index && count) return checked(text, {*index, *count});
  if (index) {
    return wrong(text,
                 "Kubernetes does not tell the number of shards: want 'auto/N' with the job's completions");
  }
  return wrong(text, "neither SLURM_ARRAY_TASK_ID nor JOB_COMPLETION_INDEX is set: want 'i/N'");
}

}  // namespace

Result<Shard> shardOf(const std::string& text) {
  if (text.empty()) return Shard{};
  if (text == kAuto) return automatic(text, std::nullopt);
  const std::size_t slash = text.find('/');
  const std::string first = text.substr(0, slash);
  const auto count = slash == std::string::npos ? std::nullopt : numberOf(text.substr(slash + 1));
  if (!count) return wrong(text, "want 'i/N' such as 1/3, 'auto' or 'auto/N'");
  if (first == kAuto) return automatic(text, count);
  const auto index = numberOf(first);
  if (!index || *index == 0) return wrong(text, "shards are numbered from 1: want 'i/N' such as 1/3");
  return checked(text, {*index - 1, *count});
}

}  // namespace fulbito::app
