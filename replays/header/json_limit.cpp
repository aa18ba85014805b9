#include "replays/header/json_limit.hpp"

#include <nlohmann/json.hpp>

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

/// Counts keys and values, and stops parsing when there are too many.
class ItemCounter final : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return count(); }
  bool key(string_t&) override { return count(); }
  bool start_object(std::size_t) override { return count(); }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return count(); }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  bool count() { return ++items_ <= kMaxJsonItems; }

  std::size_t items_ = 0;
};

}  // namespace

bool isSmallJson(std::string_view text) {
  ItemCounter counter;
  return Json::sax_parse(text, &counter);
}

}  // namespace fulbito
