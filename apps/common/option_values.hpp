#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "fulbito/detail/values.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fulbito::app {

/// @{ Defines how numbers on the command line are read: decimal, with or without leading zeros, and finite.
/// Whole numbers must be between `least` and `most`.
CLI::Option* wholeNumber(CLI::Option* option, std::uint64_t least = 0,
                         std::uint64_t most = ~std::uint64_t{0});
CLI::Option* number(CLI::Option* option);
/// @}

/// Applies `wholeNumber` or `number` to all numeric options without either, by the types of their variables.
void readNumbers(CLI::App& app);

/// The largest number of worker threads.
inline constexpr int kMostJobs = 1024;
/// Adds `--jobs`, 0 ... kMostJobs.
CLI::Option* addJobs(CLI::App& command, int& jobs, const std::string& whose);

/// Adds `--seed`. @param whose  what the seed determines, such as "layout, sensor noise"
CLI::Option* addSeed(CLI::App& command, std::uint64_t& seed, const std::string& whose);
/// Adds `--robot` and `--physics`.
void addModels(CLI::App& command, std::string& robot, std::string& physics);

/// An error for the first empty argument. Such an argument usually comes from a shell variable that is not
/// set.
std::optional<Error> emptyWord(std::span<char*> words);

}  // namespace fulbito::app
