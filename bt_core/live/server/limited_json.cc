#include "bt_core/live/server/limited_json.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace coppice {
namespace {

using Json = nlohmann::json;

// Reads on until something is nested too deep.
class DepthCheck final : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return ++depth_ <= kMaxJsonDepth; }
  bool end_object() override { return --depth_ >= 0; }
  bool start_array(std::size_t) override { return ++depth_ <= kMaxJsonDepth; }
  bool end_array() override { return --depth_ >= 0; }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

 private:
  int depth_ = 0;
};

}  // namespace

Json ParseLimitedJson(std::string_view text) {
  return Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxJsonDepth) throw std::invalid_argument("the JSON is nested too deep");
    return true;
  });
}

Json ReadLimitedMessagePack(std::string_view bytes) {
  DepthCheck check;
  if (!Json::sax_parse(bytes, &check, Json::input_format_t::msgpack)) {
    return Json(Json::value_t::discarded);
  }
  return Json::from_msgpack(bytes, true, false);
}

}  // namespace coppice
