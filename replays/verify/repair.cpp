#include "replays/verify/repair.hpp"

#include <fmt/format.h>

#include "replays/verify/copy_plays.hpp"

namespace fulbito {
namespace {

/// Counts the gaps between the chunks of a salvage.
int gapsOf(const Salvage& salvage) {
  int gaps = 0;
  Tick expected = 0;
  for (const RecordedChunk& chunk : salvage.chunks) {
    if (chunk.first_tick != expected) ++gaps;
    expected = chunk.first_tick + chunk.ticks;
  }
  return gaps;
}

RecordingResult endOf(const Salvage& salvage) {
  if (salvage.result) return *salvage.result;
  RecordingResult end;
  end.complete = false;
  for (const RecordedChunk& chunk : salvage.chunks) {
    if (!chunk.plays.empty()) end.score = chunk.plays.back().score;
  }
  return end;
}

}  // namespace

Result<Repair> repair(const Salvage& salvage) {
  Repair repaired;
  RecordingHeader header = salvage.header;
  header.recipe.more.emplace_back("repaired", "true");
  auto writer = RecordingWriter::create(
      [&repaired](std::string_view more) -> Result<void> {
        repaired.bytes.append(more);
        return {};
      },
      header);
  if (!writer) return tl::unexpected<Error>(writer.error());
  PlayCopier copier(std::move(*writer));
  const auto chunks = [&, i = std::size_t{0}]() mutable -> Result<std::optional<RecordedChunk>> {
    if (i == salvage.chunks.size()) return std::nullopt;
    return std::optional<RecordedChunk>(salvage.chunks[i++]);
  };
  if (auto played = resimulate(salvage.header, chunks, PlayRange{}, copier); !played) {
    return tl::unexpected<Error>(played.error());
  }
  if (copier.differs()) {
    return fail(ErrorCode::kBadInput,
                fmt::format("simulated again, it differs from tick {} on", *copier.differs()));
  }
  repaired.plays = copier.plays();
  repaired.ticks = copier.ticks();
  if (repaired.plays == 0) return fail(ErrorCode::kBadInput, "no play can be read");
  repaired.gaps = gapsOf(salvage);
  repaired.end_lost = !salvage.result;
  const Tick seen = salvage.chunks.back().first_tick + salvage.chunks.back().ticks;
  const Tick all = salvage.result ? salvage.result->ticks : seen;
  repaired.lost_ticks = all - repaired.ticks;
  if (auto finished = copier.finish(endOf(salvage)); !finished)
    return tl::unexpected<Error>(finished.error());
  return repaired;
}

}  // namespace fulbito
