#include "replays/verify/cut.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "replays/verify/copy_plays.hpp"

namespace fulbito {
namespace {

Result<std::vector<RecordedPlay>> playsOf(const RecordingReader& recording) {
  std::vector<RecordedPlay> plays;
  for (std::size_t i = 0; i < recording.chunkCount(); ++i) {
    auto chunk = recording.chunk(i);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    std::move(chunk->plays.begin(), chunk->plays.end(), std::back_inserter(plays));
  }
  return plays;
}

RecordingHeader headerOf(const RecordingReader& recording, const std::vector<RecordedPlay>& plays,
                         const PlayRange& range) {
  RecordingHeader header = recording.header();
  auto& more = header.recipe.more;
  // A cut of a cut gives its position in the recording that it was cut from, not in the first original.
  std::erase_if(more, [](const auto& entry) { return entry.first.starts_with("cut_"); });
  const double begin =
      static_cast<double>(plays[static_cast<std::size_t>(range.first)].tick) / header.control_rate;
  more.emplace_back("cut_plays", fmt::format("{}-{} of {}", range.first + 1, range.last + 1, plays.size()));
  more.emplace_back("cut_from_s", fmt::format("{:.3f}", begin));
  if (recording.result()) {
    more.emplace_back("cut_of_hash", fmt::format("{:016x}", recording.result()->final_hash));
  }
  return header;
}

/// The result at the end of the last play, as far as the recording contains it.
RecordingResult endOf(const RecordingReader& recording, const std::vector<RecordedPlay>& plays,
                      const PlayRange& range) {
  const auto next = static_cast<std::size_t>(range.last) + 1;
  RecordingResult end;
  end.complete = false;
  if (next < plays.size()) {
    end.score = plays[next].score;
  } else if (recording.result()) {
    end = *recording.result();
  }
  return end;
}

}  // namespace

Result<PlayRange> playsBetween(const RecordingReader& recording, double from, double to) {
  const auto plays = playsOf(recording);
  if (!plays) return tl::unexpected<Error>(plays.error());
  const double rate = recording.header().control_rate;
  PlayRange range{-1, -1};
  for (std::size_t i = 0; i < plays->size(); ++i) {
    const Tick end = i + 1 < plays->size() ? (*plays)[i + 1].tick : recording.ticks();
    const double begins = static_cast<double>((*plays)[i].tick) / rate,
                 ends = static_cast<double>(end) / rate;
    if (!(begins < to && ends > from)) continue;
    if (range.first < 0) range.first = static_cast<std::int64_t>(i);
    range.last = static_cast<std::int64_t>(i);
  }
  if (range.first < 0) {
    return fail(ErrorCode::kUsage,
                fmt::format("no play overlaps {:g} ... {:g} s; the recording lasts {:.3f} s", from, to,
                            static_cast<double>(recording.ticks()) / rate));
  }
  return range;
}

Result<std::string> cutPlays(const RecordingReader& recording, const PlayRange& range) {
  const auto plays = playsOf(recording);
  if (!plays) return tl::unexpected<Error>(plays.error());
  const auto count = static_cast<std::int64_t>(plays->size());
  if (range.first < 0 || range.last < range.first || range.last >= count) {
    return fail(ErrorCode::kUsage,
                fmt::format("plays {}-{} are not within 1 ... {}", range.first + 1, range.last + 1, count));
  }
  std::string bytes;
  auto writer = RecordingWriter::create(
      [&bytes](std::string_view more) -> Result<void> {
        bytes.append(more);
        return {};
      },
      headerOf(recording, *plays, range));
  if (!writer) return tl::unexpected<Error>(writer.error());
  PlayCopier copier(std::move(*writer));
  if (auto played = resimulate(recording, range, copier); !played)
    return tl::unexpected<Error>(played.error());
  if (copier.differs()) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: simulated again, it differs from tick {} on: see fulbito replay verify",
                            recording.origin(), *copier.differs()));
  }
  if (auto finished = copier.finish(endOf(recording, *plays, range)); !finished) {
    return tl::unexpected<Error>(finished.error());
  }
  return bytes;
}

}  // namespace fulbito
