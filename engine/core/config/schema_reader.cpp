#include <algorithm>

#include <fmt/format.h>

#include "engine/core/base/overloaded.hpp"
#include "engine/core/config/schema.hpp"
#include "engine/core/config/suggest.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

std::string inDegrees(const std::string& key) { return key + "_deg"; }

FlawText wrongType(std::string_view wanted, const TomlValue& value) {
  return fmt::format("must be {}, not {}", wanted, typeName(value));
}

std::optional<double> numberOf(const TomlValue& value) {
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
  return std::nullopt;
}

std::optional<Vec2> pointOf(const TomlValue& value) {
  const auto* array = std::get_if<TomlArray>(&value.data);
  if (array == nullptr || array->size() != 2) return std::nullopt;
  const auto x = numberOf((*array)[0]), y = numberOf((*array)[1]);
  return x && y ? std::optional<Vec2>({*x, *y}) : std::nullopt;
}

FlawText readWhole(int& target, const TomlValue& value, const SchemaKey& key) {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  if (whole == nullptr) return wrongType("a whole number", value);
  // Before the cast, since the file's number may not fit the target.
  auto flaw = checkNumber(static_cast<double>(*whole), key.minimum, key.maximum, key.unit);
  if (flaw) return flaw;
  target = static_cast<int>(*whole);
  return std::nullopt;
}

FlawText readPath(std::vector<Vec2>& target, const TomlValue& value, const SchemaKey& key) {
  const auto* array = std::get_if<TomlArray>(&value.data);
  if (array == nullptr) return wrongType("an array of points [x, y]", value);
  std::vector<Vec2> path;
  for (const TomlValue& element : *array) {
    const auto point = pointOf(element);
    if (!point) return fmt::format("[{}] must be a point [x, y] of two numbers", path.size());
    path.push_back(*point);
  }
  target = std::move(path);
  return checkValue(key);
}

FlawText readChoice(const Choice& target, const TomlValue& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) return wrongType("a string", value);
  const auto found = std::find(target.names.begin(), target.names.end(), *text);
  if (found == target.names.end()) {
    return fmt::format("= \"{}\" is not one of {}", printable(*text), fmt::join(target.names, ", "));
  }
  target.set(static_cast<int>(found - target.names.begin()));
  return std::nullopt;
}

/// `Converted` is the converted value; `store` assigns it to the target.
template <typename Converted, typename Store>
FlawText readAs(const std::optional<Converted>& converted, std::string_view wanted, const TomlValue& value,
                const SchemaKey& key, Store store) {
  if (!converted) return wrongType(wanted, value);
  store(*converted);
  return checkValue(key);
}

template <typename T>
std::optional<T> valueOf(const TomlValue& value) {
  const T* found = std::get_if<T>(&value.data);
  return found == nullptr ? std::nullopt : std::optional<T>(*found);
}

FlawText readAngle(const SchemaKey& key, const TomlValue& value, bool degrees) {
  const auto number = numberOf(value);
  if (!number) return wrongType("a number", value);
  const double scale = degrees ? 1.0 : math::kPi / 180.0;
  auto flaw = checkNumber(*number, key.minimum * scale, key.maximum * scale, degrees ? "degrees" : "rad");
  if (flaw) return flaw;
  const double radians = degrees ? *number * math::kPi / 180.0 : *number;
  if (const auto* angle = std::get_if<Angle>(&key.target)) *angle->radians = radians;
  if (const auto* heading = std::get_if<Heading>(&key.target)) *heading->radians = math::wrapAngle(radians);
  if (const auto* heading = std::get_if<OptionalHeading>(&key.target)) {
    *heading->radians = math::wrapAngle(radians);
  }
  return std::nullopt;
}

FlawText readValue(const SchemaKey& key, const TomlValue& value) {
  const auto store = [](auto& target) { return [&target](const auto& v) { target = v; }; };
  return std::visit(
      Overloaded{
          [&](double* v) { return readAs(numberOf(value), "a number", value, key, store(*v)); },
          [&](int* v) { return readWhole(*v, value, key); },
          [&](bool* v) { return readAs(valueOf<bool>(value), "true or false", value, key, store(*v)); },
          [&](std::string* v) {
            return readAs(valueOf<std::string>(value), "a string", value, key, store(*v));
          },
          [&](const Label& v) {
            return readAs(valueOf<std::string>(value), "a string", value, key, store(*v.text));
          },
          [&](Vec2* v) {
            return readAs(pointOf(value), "a point [x, y] of two numbers", value, key, store(*v));
          },
          [&](std::vector<Vec2>* v) { return readPath(*v, value, key); },
          [&](const Choice& v) { return readChoice(v, value); },
          [&](const auto&) { return readAngle(key, value, false); }},
      key.target);
}

const SchemaKey* findKey(const Schema& schema, const std::string& name) {
  for (const SchemaKey& key : schema) {
    if (key.key == name || (isAngle(key) && inDegrees(key.key) == name)) return &key;
  }
  return nullptr;
}

tl::unexpected<Error> badKey(const TablePlace& place, int line, const std::string& key, std::string text) {
  const Flaw flaw{place.table, place.index, printable(key), std::move(text)};
  return fail(ErrorCode::kBadInput, fmt::format("{}:{}: {}", place.origin, line, flaw.message()));
}

tl::unexpected<Error> unknownKey(const TablePlace& place, const TomlEntry& entry, const Schema& schema) {
  std::vector<std::string> names;
  for (const SchemaKey& key : schema) {
    if (isAngle(key)) names.push_back(inDegrees(key.key));
    names.push_back(key.key);
  }
  std::string hint = suggestion(entry.key, names);
  if (hint.empty()) hint = fmt::format(" Its keys: {}.", fmt::join(names, ", "));
  return badKey(place, entry.line, entry.key, fmt::format("is not a key of [{}].{}", place.table, hint));
}

}  // namespace

Result<void> readTable(const TomlTable& table, const TablePlace& place, const Schema& schema) {
  // Unknown keys first: for a misspelt key, "unknown" is a better message than "missing".
  for (const TomlEntry& entry : table.entries) {
    if (findKey(schema, entry.key) == nullptr) return unknownKey(place, entry, schema);
  }
  for (const SchemaKey& key : schema) {
    const TomlEntry* plain = table.find(key.key);
    const TomlEntry* degrees = isAngle(key) ? table.find(inDegrees(key.key)) : nullptr;
    if (plain != nullptr && degrees != nullptr) {
      return badKey(place, degrees->line, degrees->key, fmt::format("and {} are both given", key.key));
    }
    const TomlEntry* entry = plain != nullptr ? plain : degrees;
    if (entry == nullptr) {
      if (key.required) return badKey(place, place.line, key.key, "is missing");
      continue;
    }
    const FlawText flaw =
        degrees != nullptr ? readAngle(key, entry->value, true) : readValue(key, entry->value);
    if (flaw) return badKey(place, entry->line, entry->key, *flaw);
  }
  return {};
}

}  // namespace fulbito
