#include "tests/structure/public_headers.hpp"

#include <algorithm>

namespace fulbito::test {
namespace {

const std::vector<PublicHeader> kPublicHeaders = {
    {"fulbito/models.hpp", "engine/core/models"},
    {"fulbito/world.hpp", "engine/sim"},
    {"fulbito/navigation.hpp", "navigation/interface"},
    {"fulbito/strategy.hpp", "strategies/interface"},
    {"fulbito/team.h", "navigation/library"},
    {"fulbito/team.hpp", "bridge"},
    {"fulbito/referee.hpp", "referee/rules"},
    {"fulbito/match.hpp", "match/config"},
    {"fulbito/statistics.hpp", "match/report"},
    {"fulbito/recording.hpp", "replays/recording"},
    {"fulbito/recorder.hpp", "match/record"},
    {"fulbito/picture.hpp", "replays/render/field"},
    {"fulbito/experiment.hpp", "experiments/trials"},
    {"fulbito/report.hpp", "experiments/paper_report"},
    {"fulbito/sensors.hpp", "engine/sim"},
    {"fulbito/team_program.hpp", "bridge/lines"},
    {"fulbito/detail/lines/json_reader.hpp", "bridge/lines"},
    {"fulbito/detail/lines/json_text.hpp", "bridge/lines"},
    {"fulbito/detail/lines/utf8.hpp", "bridge/lines"},
    {"fulbito/detail/lines/read_values.hpp", "bridge/lines"},
    {"fulbito/detail/lines/write_answers.hpp", "bridge/lines"},
    {"fulbito/detail/lines/conversation.hpp", "bridge/lines"},
    {"fulbito/detail/lines/pipes.hpp", "bridge/lines"},
    {"fulbito/outside.hpp", "bridge/outside"},
    {"fulbito/detail/child_limits.hpp", "bridge/process"},
    {"fulbito/detail/decision_time.hpp", "referee/rules"},
    {"fulbito/detail/values.hpp", "engine/core/base"},
    {"fulbito/detail/vec2.hpp", "engine/core/base"},
    {"fulbito/detail/state_hash.hpp", "engine/core/base"},
    {"fulbito/detail/build_info.hpp", "engine/core/base"},
    {"fulbito/detail/math.hpp", "engine/core/math"},
    {"fulbito/detail/interval.hpp", "engine/core/math"},
    {"fulbito/detail/field_geometry.hpp", "engine/core/models"},
    {"fulbito/detail/layout.hpp", "engine/core/models"},
    {"fulbito/detail/detector_rules.hpp", "referee/rules"},
    {"fulbito/detail/period_rules.hpp", "referee/rules"},
    {"fulbito/detail/restart_rules.hpp", "referee/rules"},
    {"fulbito/detail/trial_score.hpp", "referee/trial"},
    {"fulbito/detail/canvas.hpp", "replays/render/canvas"},
    {"fulbito/detail/arc.hpp", "navigation/geometry"},
    {"fulbito/detail/echo_scene.hpp", "engine/core/models"},
    {"fulbito/detail/sonar_model.hpp", "engine/core/models"},
    {"fulbito/detail/line_chart.hpp", "replays/render/field"},
    {"fulbito/detail/page_scene.hpp", "replays/html"},
    {"fulbito/detail/parallel.hpp", "engine/core/system"},
    {"fulbito/detail/parameters.hpp", "navigation/interface"},
    {"fulbito/detail/random.hpp", "engine/core/math"},
};

}  // namespace

std::span<const PublicHeader> publicHeaders() { return kPublicHeaders; }

std::string ownerOf(std::string_view path) {
  if (path.starts_with(kPublicFolder)) path.remove_prefix(kPublicFolder.size());
  const auto header = std::find_if(kPublicHeaders.begin(), kPublicHeaders.end(),
                                   [&](const PublicHeader& h) { return h.name == path; });
  if (header != kPublicHeaders.end()) return std::string(header->folder);
  return std::string(path.substr(0, path.rfind('/') == std::string_view::npos ? 0 : path.rfind('/')));
}

}  // namespace fulbito::test
