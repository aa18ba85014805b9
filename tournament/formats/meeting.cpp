#include "tournament/formats/meeting.hpp"

namespace fulbito {

void MeetingScore::add(const PairResult& pair) {
  points[0] += 2.0 * pair.points();
  points[1] += 2.0 - 2.0 * pair.points();
  goals[0] += pair.goalsOfA();
  goals[1] += pair.goalsOfB();
}

std::optional<std::size_t> MeetingScore::winner() const {
  if (points[0] != points[1]) return points[0] > points[1] ? 0 : 1;
  if (goals[0] != goals[1]) return goals[0] > goals[1] ? 0 : 1;
  return std::nullopt;
}

MeetingFixtures addMeeting(std::vector<Fixture>& fixtures, Fixture first, int pairs) {
  const std::size_t begin = fixtures.size();
  for (int i = 0; i < pairs; ++i) {
    fixtures.push_back(first);
    ++first.start;
  }
  return {begin, fixtures.size()};
}

bool addResults(ResultsView results, MeetingFixtures meeting, MeetingScore& score) {
  bool all = true;
  for (std::size_t i = meeting.begin; i < meeting.end; ++i) {
    if (i < results.size() && results[i]) {
      score.add(*results[i]);
    } else {
      all = false;
    }
  }
  return all;
}

}  // namespace fulbito
