// Prints the goals of a recorded match and the position of the ball at each: read_recording FILE
#include <cstdio>
#include <fulbito/recording.hpp>

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "Usage: read_recording FILE\n"), 2;
  const auto recording = fulbito::RecordingReader::open(arguments[1]);
  if (!recording) return std::fprintf(stderr, "%s\n", recording.error().message.c_str()), 3;
  const auto timeline = fulbito::ReplayTimeline::read(*recording);
  if (!timeline) return std::fprintf(stderr, "%s\n", timeline.error().message.c_str()), 3;

  const fulbito::RecordingHeader& header = timeline->header();
  const int ball = fulbito::countOf(header, fulbito::BodyKind::kRobot);  // robots come first
  std::printf("%s, %.1f s%s\n", arguments[1], timeline->seconds(), recording->finished() ? "" : ", cut");
  for (const fulbito::ReplayGoal& goal : timeline->goals()) {
    const fulbito::ReplayMoment moment = timeline->at(goal.seconds - 0.5);
    const fulbito::Vec2 place = moment.bodies[ball]->position;
    std::printf("%6.1f s: goal for %s; half a second before, the ball was at (%.2f, %.2f) m\n", goal.seconds,
                header.recipe.teams[fulbito::indexOf(goal.team)].c_str(), place.x, place.y);
  }
}
