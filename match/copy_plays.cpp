#include "match/copy_plays.hpp"

namespace fulbito {
namespace {

/// The one call that belongs to the play that begins at its tick; all others ended the play before.
bool isOfRestart(const RecordedEvent& event) { return event.clause == "placement"; }

}  // namespace

void PlayCopier::chunkBegins(const RecordedChunk& chunk) {
  events_.insert(events_.end(), chunk.events.begin(), chunk.events.end());
  drawings_.insert(drawings_.end(), chunk.drawings.begin(), chunk.drawings.end());
}

bool PlayCopier::playBegins(const ReplayedPlay& play) {
  RecordedPlay copy = *play.recorded;
  // The first play brings its hash along; after a gap the hash goes on from what is there.
  if (plays_ == 0) hash_ = StateHash(copy.hash);
  copy.hash = hash_.value();
  writer_.beginPlay(copy);
  ++plays_;
  const Tick began = play.recorded->tick;
  shift_ = writer_.tick() - began;
  std::erase_if(events_, [began](const RecordedEvent& e) {
    return e.tick < began || (e.tick == began && !isOfRestart(e));
  });
  std::erase_if(drawings_, [began](const RecordedDrawing& d) { return d.tick <= began; });
  return true;
}

bool PlayCopier::ticked(const ReplayedTick& tick) {
  if (!asRecorded(tick)) {
    differs_ = tick.tick;
    return false;
  }
  hash_.add(tick.world->state());
  writer_.add(
      RecordingTick{&tick.world->state(), tick.commands, hash_.value(), tick.chunk->playing[tick.row] != 0});
  pass(tick.tick);
  return true;
}

void PlayCopier::pass(Tick until) {
  std::erase_if(events_, [&](RecordedEvent& event) {
    // The repairs of the next restart are not of this play.
    if (event.tick > until || (event.tick == until && isOfRestart(event))) return false;
    event.tick += shift_;
    writer_.add(event);
    return true;
  });
  for (; !drawings_.empty() && drawings_.front().tick <= until; drawings_.pop_front()) {
    drawings_.front().tick += shift_;
    writer_.add(drawings_.front());
  }
}

Result<void> PlayCopier::finish(RecordingResult result) {
  result.final_hash = hash_.value();
  return writer_.finish(result);
}

}  // namespace fulbito
