#include "match/record/recorded_values.hpp"

#include "strategies/interface/team_frame.hpp"

namespace fulbito {

void describe(const GameEvent& event, RecordedEvent& recorded) {
  recorded.tick = event.tick;
  recorded.play_time = event.play_time;
  recorded.period = event.period;
  recorded.clause.assign(event.clause);
  recorded.law.assign(event.law);
  recorded.team = event.team;
  recorded.robot = event.robot;
  recorded.place = event.place;
  recorded.value = event.value;
  recorded.threshold = event.threshold;
  recorded.margin = event.margin;
}

void describe(const DebugDrawing& drawing, Tick tick, TeamId team, Side side, RecordedDrawing& recorded) {
  recorded.tick = tick;
  recorded.team = team;
  recorded.kind = static_cast<RecordedDrawing::Kind>(drawing.kind);
  recorded.from = inTeamFrame(side, drawing.from);
  recorded.to = inTeamFrame(side, drawing.to);
  recorded.radius = drawing.radius;
  recorded.text.assign(drawing.text);
}

}  // namespace fulbito
