#include "bt_core/analysis/json_writer.h"

#include <cstdio>

namespace coppice {
namespace {

// Length of the UTF-8 sequence at the start of a text, or 0 if there is none (RFC 3629).
std::size_t SequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  if (byte(0) < 0x80) return 1;
  if (byte(0) >= 0xc2 && byte(0) < 0xe0) return continues(1) ? 2 : 0;
  if (byte(0) >= 0xe0 && byte(0) < 0xf0) {
    const bool overlong = byte(0) == 0xe0 && byte(1) < 0xa0;
    const bool surrogate = byte(0) == 0xed && byte(1) >= 0xa0;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (byte(0) >= 0xf0 && byte(0) < 0xf5) {
    const bool overlong = byte(0) == 0xf0 && byte(1) < 0x90;
    const bool too_large = byte(0) == 0xf4 && byte(1) >= 0x90;
    return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

void AppendCharacter(std::string& json, std::string_view character) {
  const char c = character[0];
  if (c == '"' || c == '\\') {
    json += '\\';
    json += c;
  } else if (c == '\n') {
    json += "\\n";
  } else if (character.size() == 1 && static_cast<unsigned char>(c) < 0x20) {
    char escape[8];
    std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
    json += escape;
  } else {
    json += character;
  }
}

}  // namespace

std::string JsonText(std::string_view text) {
  std::string json = "\"";
  while (!text.empty()) {
    const std::size_t length = SequenceLength(text);
    AppendCharacter(json, length > 0 ? text.substr(0, length) : "\xEF\xBF\xBD");
    text.remove_prefix(length > 0 ? length : 1);
  }
  return json + "\"";
}

std::string JsonSeconds(Duration time) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.9f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

JsonObject& JsonObject::Add(std::string_view key, const std::string& json) {
  text_ += (text_.size() > 1 ? "," : "") + JsonText(key) + ":" + json;
  return *this;
}

JsonObject& JsonObject::Add(std::string_view key, std::uint64_t number) {
  return Add(key, std::to_string(number));
}

JsonObject& JsonObject::AddText(std::string_view key, std::string_view text) {
  return Add(key, JsonText(text));
}

}  // namespace coppice
