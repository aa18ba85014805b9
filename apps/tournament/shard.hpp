#pragma once

#include <string>

#include "tournament/runner/runner.hpp"

namespace fulbito::app {

/// Parses the flag of a shard: "2/7"; "auto": from the variables of a Slurm array; "auto/7": also from those
/// of an indexed Kubernetes job (docs/tournaments.md). Empty: the whole tournament. Errors: kUsage.
Result<Shard> shardOf(const std::string& text);

}  // namespace fulbito::app
