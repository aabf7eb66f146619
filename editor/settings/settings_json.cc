#include "editor/settings/settings_json.h"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace coppice::editor {
namespace {

template <class Of, class T>
struct Member {
  const char* name;
  T Of::*member;
};

constexpr Member<Tiles, bool> kTiles[] = {
    {"project", &Tiles::project},   {"outline", &Tiles::outline},
    {"types", &Tiles::types},       {"inspector", &Tiles::inspector},
    {"xml", &Tiles::xml},           {"blackboard", &Tiles::blackboard},
    {"problems", &Tiles::problems}, {"run", &Tiles::run},
    {"timeline", &Tiles::timeline}, {"minimap", &Tiles::minimap},
    {"row", &Tiles::row},
};
constexpr Member<Splits, float> kSplits[] = {
    {"left", &Splits::left},
    {"right", &Splits::right},
    {"bottom", &Splits::bottom},
    {"timeline", &Splits::timeline},
    {"bare_project", &Splits::bare_project},
    {"left_part", &Splits::left_part},
    {"types_part", &Splits::types_part},
    {"right_part", &Splits::right_part},
    {"run_part", &Splits::run_part},
    {"bottom_part", &Splits::bottom_part},
};
template <class Value>
using Name = std::pair<const char*, Value>;
constexpr Member<LayoutStyle, bool> kLayout[] = {
    {"layered", &LayoutStyle::layered},
    {"compact", &LayoutStyle::compact},
    {"stacked", &LayoutStyle::stacked},
    {"wrapped", &LayoutStyle::wrapped},
};
constexpr Name<Growth> kGrowth[] = {
    {"by_itself", Growth::kByItself}, {"down", Growth::kDown}, {"across", Growth::kAcross}};
constexpr Name<ShownPorts> kPorts[] = {
    {"by_itself", ShownPorts::kByItself}, {"all", ShownPorts::kAll}, {"none", ShownPorts::kNone}};
constexpr double kLargest = 4000;

const char* NameOf(Growth growth) { return kGrowth[static_cast<std::size_t>(growth)].first; }
const char* NameOf(ShownPorts ports) { return kPorts[static_cast<std::size_t>(ports)].first; }

// False: the text is none of the names.
template <class Value, std::size_t count>
bool FromName(const std::string& text, const Name<Value> (&names)[count], Value& taken) {
  for (const auto& [name, value] : names) {
    if (text != name) continue;
    taken = value;
    return true;
  }
  return false;
}

std::optional<double> NumberIn(const JsonValue& value, double low, double high) {
  const double number = std::strtod(value.text.c_str(), nullptr);
  const bool fits = value.is(JsonValue::Kind::kNumber) && number >= low && number <= high;
  return fits ? std::optional(number) : std::nullopt;
}

}  // namespace

void SettingsReader::Wrong(const JsonValue& value, const std::string& expected) {
  diagnostics_.Error(value.where, "\"" + value.key + "\" is not " + expected);
}

void SettingsReader::Take(const JsonValue& json, const char* name, bool& value) {
  const JsonValue* const found = json.Find(name);
  if (!found) return;
  if (!found->is(JsonValue::Kind::kBool)) return Wrong(*found, "true or false");
  value = found->text == "true";
}

void SettingsReader::Take(const JsonValue& json, const char* name, std::string& value) {
  const JsonValue* const found = json.Find(name);
  if (!found) return;
  if (!found->is(JsonValue::Kind::kString)) return Wrong(*found, "a text");
  value = found->text;
}

void SettingsReader::Take(const JsonValue& json, const char* name, double low, double high,
                          float& value) {
  const JsonValue* const found = json.Find(name);
  if (!found) return;
  const std::optional<double> number = NumberIn(*found, low, high);
  if (!number) return Wrong(*found, "a number of pixels, or a part, that can be");
  value = static_cast<float>(*number);
}

void SettingsReader::Take(const JsonValue& json, const char* name, double low, double high,
                          int& value) {
  auto number = static_cast<float>(value);
  Take(json, name, low, high, number);
  value = static_cast<int>(number);
}

void SettingsReader::Take(const JsonValue& json, const char* name, Tiles& tiles) {
  for (const auto& tile : kTiles) Take(PartOf(json, name), tile.name, tiles.*tile.member);
}

void SettingsReader::Take(const JsonValue& json, const char* name, Splits& splits) {
  const JsonValue& sizes = PartOf(json, name);
  for (const auto& one : kSplits) Take(sizes, one.name, 0, kLargest, splits.*one.member);
}

void SettingsReader::Take(const JsonValue& json, const char* name, LayoutStyle& style) {
  const JsonValue& layout = PartOf(json, name);
  for (const auto& part : kLayout) Take(layout, part.name, style.*part.member);
  const JsonValue* const growth = layout.Find("growth");
  if (growth && !FromName(growth->text, kGrowth, style.growth)) {
    Wrong(*growth, "by_itself, down or across");
  }
  const JsonValue* const ports = layout.Find("ports");
  if (ports && !FromName(ports->text, kPorts, style.ports)) {
    Wrong(*ports, "by_itself, all or none");
  }
}

const JsonValue& PartOf(const JsonValue& json, const char* name) {
  static const JsonValue none;
  const JsonValue* const part = json.Find(name);
  return part ? *part : none;
}

JsonValue MakeJson(JsonValue::Kind kind, std::string key, std::string text) {
  JsonValue json;
  json.kind = kind;
  json.key = std::move(key);
  json.text = std::move(text);
  return json;
}

JsonValue MakeJson(std::string key, bool value) {
  return MakeJson(JsonValue::Kind::kBool, std::move(key), value ? "true" : "false");
}

JsonValue MakeJson(std::string key, double value) {
  std::string text = std::to_string(std::lround(value * 1000) / 1000.0);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return MakeJson(JsonValue::Kind::kNumber, std::move(key), std::move(text));
}

JsonValue MakeJson(std::string key, const Tiles& tiles) {
  JsonValue json = MakeJson(JsonValue::Kind::kObject, std::move(key));
  for (const auto& tile : kTiles) json.children.push_back(MakeJson(tile.name, tiles.*tile.member));
  return json;
}

JsonValue MakeJson(std::string key, const Splits& splits) {
  JsonValue json = MakeJson(JsonValue::Kind::kObject, std::move(key));
  for (const auto& one : kSplits) {
    json.children.push_back(MakeJson(one.name, static_cast<double>(splits.*one.member)));
  }
  return json;
}

JsonValue MakeJson(std::string key, const LayoutStyle& style) {
  JsonValue json = MakeJson(JsonValue::Kind::kObject, std::move(key));
  json.children.push_back(MakeText("growth", NameOf(style.growth)));
  for (const auto& part : kLayout) {
    json.children.push_back(MakeJson(part.name, style.*part.member));
  }
  json.children.push_back(MakeText("ports", NameOf(style.ports)));
  return json;
}

JsonValue MakeText(std::string key, std::string text) {
  return MakeJson(JsonValue::Kind::kString, std::move(key), std::move(text));
}

}  // namespace coppice::editor
