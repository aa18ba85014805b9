// Private header of apps: not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/core/base/result.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fulbito::app {

/// @{ The one way in which numbers of the command line are read: decimal, also with zeros in front, finite;
/// whole ones from the least to the most.
CLI::Option* wholeNumber(CLI::Option* option, std::uint64_t least = 0,
                         std::uint64_t most = ~std::uint64_t{0});
CLI::Option* number(CLI::Option* option);
/// @}

/// Reads all numbers of the commands so that no `wholeNumber` or `number` has been told of before: by the
/// types of their variables.
void readNumbers(CLI::App& app);

/// Worker threads that may be asked for.
inline constexpr int kMostJobs = 1024;
/// Adds `--jobs`, 0 ... kMostJobs.
CLI::Option* addJobs(CLI::App& command, int& jobs, const std::string& whose);

/// An empty word is nobody's name or number: it comes of a variable that is not set. Gives the error of the
/// first one.
std::optional<Error> emptyWord(std::span<char*> words);

}  // namespace fulbito::app
