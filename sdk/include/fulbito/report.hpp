// Reports of experiments that reproduce papers: figures beside the paper's, tables, charts, animated scenes;
// written as text, JSON, CSV and pictures. And the settings, seeds and threads that such an experiment gets.
// Component `experiment`.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fulbito/detail/arc.hpp"
#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/line_chart.hpp"
#include "fulbito/detail/page_scene.hpp"
#include "fulbito/detail/parallel.hpp"
#include "fulbito/detail/parameters.hpp"
#include "fulbito/detail/random.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// The input of an experiment: seed, threads, settings.
struct ExperimentRequest {
  std::uint64_t seed = 1;         ///< seed of all its random streams
  int jobs = 0;                   ///< worker threads; 0: all cores; the report does not depend on it
  std::vector<Setting> settings;  ///< names are checked against `PaperExperiment::settings`
  Progress progress;              ///< may be empty

  /// The value of a setting as given; empty if it was not given.
  std::optional<std::string> find(std::string_view name) const;
};

/// A figure of a paper, and its measured reproduction.
struct PaperFigure {
  std::string id;                    ///< unique in the report, e.g. "table-5-radius-0.3"
  std::string where;                 ///< place in the paper, e.g. "Table 5"
  std::string what;                  ///< the measured quantity
  std::string unit;                  ///< e.g. "m"; empty: none
  int decimals = 2;                  ///< decimals of `paper`, `ours` and the band in texts
  std::optional<double> paper = {};  ///< as printed; empty: the paper gives no number
  double ours = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not measured, which is outside every band
  double low = -std::numeric_limits<double>::infinity();   ///< @{ range in which a reproduction must lie
  double high = std::numeric_limits<double>::infinity();   ///< @}
  std::string reason = {};  ///< reason why `ours` differs from `paper` or is outside the band

  bool inside() const { return ours >= low && ours <= high; }
};

/// A column of a table.
struct ReportColumn {
  std::string name;  ///< also in CSV and JSON, e.g. "time_s"
  int decimals = 3;  ///< decimals of its numbers in texts; CSV and JSON have all digits
};

/// Columns from words such as "time_s:2" (a name and its decimals) or "time_s" (default decimals).
std::vector<ReportColumn> columnsOf(const std::string& words);

/// A number, or a text.
using ReportCell = std::variant<double, std::string>;

/// A table of results, written as NAME.csv too.
struct ReportTable {
  std::string name;                   ///< name of its file, e.g. "table-5"
  std::string title;                  ///< one line
  std::vector<ReportColumn> columns;  ///< at least one
  std::vector<std::vector<ReportCell>> rows;
  std::size_t shown = 40;  ///< rows in texts; CSV and JSON have all
};

/// A chart, written as NAME.png.
struct ReportChart {
  std::string name;
  LineChart chart;
};

/// A line across a scene, e.g. a reference path.
struct ScenePath {
  std::string label;         ///< legend of the picture
  std::vector<Vec2> points;  ///< [m]
  bool dashed = false;
};

/// A moment that stands out in the picture of a whole scene.
struct SceneMoment {
  std::size_t row = 0;  ///< index of a row of the page
  std::string label;    ///< text in the middle of the moving bodies; may be empty
};

/// Colours of bodies by their roles, which may change during the scene, e.g. master and slave.
struct SceneRoles {
  std::vector<std::string> names;               ///< legend, in place of the bodies' labels; empty: none
  std::vector<std::vector<std::uint8_t>> rows;  ///< per row of the page and body: index of `names`
};

/// An animated scene: NAME.png (paths of all bodies, and `paths`), NAME.gif, and one scene of the HTML page.
/// With one row it is a still picture: NAME.png only.
struct ReportScene {
  std::string name;
  std::string caption;  ///< one sentence or more for the picture
  PageScene page;       ///< bodies, rows and drawings; `plays` and `ticks` may be left to `finishScene`
  std::vector<ScenePath> paths;
  std::vector<std::string> labels;  ///< labels of the first bodies, for the legend; may be empty
  SceneRoles roles = {};
  std::vector<SceneMoment> moments = {};  ///< drawn in full in the picture of the whole scene
  /// [s] between faint outlines along the bodies' paths; 0: 24 outlines; negative: none
  double outlines_every = 0.0;
  std::size_t first_trail = 0;  ///< bodies before it leave no trail, e.g. since they would cover each other

  bool isStill() const { return page.rows.size() == 1; }
};

/// Fills in the parts that all scenes with one play share: the play, its ticks, facts about robots and build.
void finishScene(ReportScene& scene);

/// The result of an experiment.
struct ExperimentReport {
  std::string name;                  ///< as `PaperExperiment::name`
  std::string title;                 ///< e.g. "Choi & Lee (2005): capturing a moving object"
  std::vector<PaperFigure> figures;  ///< in the order of the paper
  std::vector<ReportTable> tables;
  std::vector<ReportChart> charts;
  std::vector<ReportScene> scenes;
  std::vector<std::string> notes;  ///< sentences under the tables
};

/// A setting of an experiment.
struct ExperimentSetting {
  std::string name;     ///< as in `--set name=value`
  std::string initial;  ///< default, as text; empty: none
  std::string doc;      ///< one line with its unit
};

/// The settings that parameters describe, with their defaults.
std::vector<ExperimentSetting> settingsOf(const std::vector<ParameterSpec>& parameters);

/// An experiment that reproduces a paper.
struct PaperExperiment {
  std::string name;     ///< as in `fulbito experiment NAME`
  std::string summary;  ///< one line
  std::string paper;    ///< authors, year, title
  std::vector<ExperimentSetting> settings;
  /// Runs it. The same request gives the same report for any number of jobs. Errors: kUsage naming the
  /// setting; kInterrupted.
  Result<ExperimentReport> (*run)(const ExperimentRequest& request) = nullptr;
};

/// The experiment of that name. Errors: kUsage with a suggestion.
Result<const PaperExperiment*> findPaperExperiment(std::span<const PaperExperiment> all,
                                                   const std::string& name);

/// Checks the names of the settings and runs the experiment. Errors: kUsage with a suggestion; those of the
/// experiment.
Result<ExperimentReport> runPaperExperiment(const PaperExperiment& experiment,
                                            const ExperimentRequest& request);

/// The content of a file that a setting names. Errors: kIo naming the file and the reason; kBadInput when it
/// is larger than `max_bytes`; kInterrupted while it waits for a pipe.
Result<std::string> readSettingFile(const std::string& file, std::size_t max_bytes);

/// Figs 1 to 7 of P.-G. Kim et al. (2006) as still pictures, with the paper's lengths. Each shows the result
/// of one part of the navigator `hybrid` at one place. 1: the nearness diagram's walking area; 2, 3: its two
/// situations of low safety; 4: occupancy boxes; 5: the limit cycle; 6, 7: the table of directions, near and
/// farther.
std::vector<ReportScene> hybridPictures();

/// Markdown for people: the figures beside the paper's, the tables, the notes.
std::string experimentText(const ExperimentReport& report);

/// One JSON object with figures, tables and names of files, pretty-printed with a final newline.
std::string experimentJson(const ExperimentReport& report, const ExperimentRequest& request);

/// The whole table as CSV.
std::string tableCsv(const ReportTable& table);

}  // namespace fulbito
