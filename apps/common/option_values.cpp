#include "apps/common/option_values.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace fulbito::app {
namespace {

std::string_view digitsOf(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  return text;
}

bool isWhole(std::string_view text) {
  const std::string_view digits = digitsOf(text);
  return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Removes leading zeros, which CLI11 reads as an octal prefix.
std::string decimal(std::string_view text) {
  std::string_view digits = digitsOf(text);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return (text.front() == '-' ? "-" : "") + std::string(digits);
}

std::string wholeNumberError(std::string& text) {
  if (!isWhole(text)) return fmt::format("'{}' is not a whole number", text);
  text = decimal(text);
  return {};
}

std::string limitedNumberError(std::string& text, std::uint64_t least, std::uint64_t most) {
  std::uint64_t value = 0;
  const bool whole = isWhole(text) && text.front() != '-';
  const std::string digits = whole ? decimal(text) : text;
  const char* const end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, value);
  if (!whole || read.ec != std::errc() || read.ptr != end || value < least || value > most) {
    return fmt::format("'{}' is not a whole number in {} ... {}", text, least, most);
  }
  text = digits;
  return {};
}

std::string numberError(std::string& text) {
  const char* const end = text.data() + text.size();
  double value = 0.0;
  const auto read = std::from_chars(text.data() + (text.starts_with('+') ? 1 : 0), end, value);
  if (read.ec == std::errc() && read.ptr == end && std::isfinite(value)) return {};
  return fmt::format("'{}' is not a number", text);
}

constexpr const char* kValidator = "number";

CLI::Option* read(CLI::Option* option, std::function<std::string(std::string&)> validate) {
  return option->transform(CLI::Validator(std::move(validate), "", kValidator));
}

bool isRead(CLI::Option& option) {
  try {
    return option.get_validator(kValidator) != nullptr;
  } catch (const CLI::OptionNotFound&) {
    return false;
  }
}

}  // namespace

CLI::Option* wholeNumber(CLI::Option* option, std::uint64_t least, std::uint64_t most) {
  return read(option, [least, most](std::string& text) { return limitedNumberError(text, least, most); });
}

CLI::Option* number(CLI::Option* option) { return read(option, numberError); }

void readNumbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    if (isRead(*option)) continue;
    if (type.starts_with("INT") || type.starts_with("UINT")) read(option, wholeNumberError);
    if (type.starts_with("FLOAT")) number(option);
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) readNumbers(*command);
}

CLI::Option* addJobs(CLI::App& command, int& jobs, const std::string& whose) {
  return wholeNumber(command.add_option("--jobs", jobs, whose + " (default: all cores)"), 0, kMostJobs);
}

CLI::Option* addSeed(CLI::App& command, std::uint64_t& seed, const std::string& whose) {
  const std::string what = whose.empty() ? "random seed" : fmt::format("random seed ({})", whose);
  return wholeNumber(command.add_option("--seed", seed, what))->capture_default_str();
}

void addModels(CLI::App& command, std::string& robot, std::string& physics) {
  command.add_option("--robot", robot, "robot preset or TOML file")->capture_default_str();
  command.add_option("--physics", physics, "physics profile or TOML file")->capture_default_str();
}

std::optional<Error> emptyWord(std::span<char*> words) {
  std::string_view before;
  for (const std::string_view word : words) {
    const bool cut = word.starts_with("--") && word.ends_with('=');
    if (word.empty() || cut) {
      const std::string_view flag = cut ? word.substr(0, word.size() - 1) : before;
      return Error{ErrorCode::kUsage, flag.starts_with('-') ? fmt::format("{}: the value is empty", flag)
                                                            : std::string("an argument is empty")};
    }
    before = word;
  }
  return std::nullopt;
}

}  // namespace fulbito::app
