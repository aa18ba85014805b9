#pragma once

#include <string>
#include <vector>

#include "experiments/papers/localization/random_rooms.hpp"
#include "experiments/papers/localization/wrong_figures.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// Runs of all schemes on the same tasks of one kind.
struct Ground {
  std::string name;                                                  ///< name in tables, e.g. "random rooms"
  std::vector<CleaningTask> tasks;                                   ///< equal for all schemes
  std::array<std::vector<CleaningResult>, kSchemes.size()> results;  ///< per scheme, in the order of `tasks`

  const std::vector<CleaningResult>& of(Scheme scheme) const {
    return results[static_cast<std::size_t>(scheme)];
  }
};

/// Size of the experiment.
struct BatchSize {
  std::size_t rooms = 200;  ///< number of random rooms
  std::size_t fields = 40;  ///< number of poses on each form of the soccer field
  std::size_t wrong = 0;    ///< number of random rooms per wrong value; 0: none
  SensorSpread spread;
};

/// All runs of the experiment.
struct Batch {
  std::vector<std::string> refused_rooms;  ///< one reason per refused room
  std::vector<Ground> grounds;             ///< random rooms first, then fields
  Ground example;                          ///< one run per scheme in one room, with moments
  Ground field_example;                    ///< the same on the soccer field
  std::vector<WrongRuns> wrong;            ///< by case and scheme; may be empty
};

/// Runs everything. The result does not depend on the number of jobs. Errors: kInterrupted.
Result<Batch> runBatch(const BatchSize& size, std::uint64_t seed, int jobs, const WorkWatcher& watcher);

}  // namespace fulbito::localization
