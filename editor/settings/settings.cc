#include "editor/settings/settings.h"

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "bt_core/base/json.h"
#include "editor/theme/scale.h"

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

class SettingsReader {
 public:
  explicit SettingsReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  Settings Read(const JsonValue& json) {
    Settings settings;
    if (const JsonValue* palette = json.Find("palette")) {
      const auto known = PaletteFromString(palette->text);
      if (known) settings.palette = *known;
      if (!known) Wrong(*palette, "dark, light or colourblind");
    }
    Take(json, "reduce_motion", settings.reduce_motion);
    Take(json, "wheel_zooms", settings.wheel_zooms);
    Take(json, "scale", 0, kScales[std::size(kScales) - 1], settings.scale);
    settings.scale = NearestScale(settings.scale);
    const JsonValue& tiles = Part(json, "tiles");
    for (const auto& tile : kTiles) Take(tiles, tile.name, settings.tiles.*tile.member);
    const JsonValue& sizes = Part(json, "sizes");
    for (const auto& one : kSplits) Take(sizes, one.name, 0, kLargest, settings.splits.*one.member);
    const JsonValue& layout = Part(json, "layout");
    for (const auto& part : kLayout) Take(layout, part.name, settings.style.*part.member);
    TakeName(layout, "growth", kGrowth, "by_itself, down or across", settings.style.growth);
    TakeName(layout, "ports", kPorts, "by_itself, all or none", settings.style.ports);
    const JsonValue& window = Part(json, "window");
    Take(window, "width", 320, 16384, settings.width);
    Take(window, "height", 240, 16384, settings.height);
    return settings;
  }

 private:
  static const JsonValue& Part(const JsonValue& json, const char* name) {
    static const JsonValue none;
    const JsonValue* const part = json.Find(name);
    return part ? *part : none;
  }

  void Wrong(const JsonValue& value, const std::string& expected) {
    diagnostics_.Error(value.where, "\"" + value.key + "\" is not " + expected);
  }

  template <class Value, std::size_t count>
  void TakeName(const JsonValue& json, const char* key, const Name<Value> (&names)[count],
                const char* expected, Value& taken) {
    const JsonValue* const found = json.Find(key);
    if (!found) return;
    for (const auto& [name, value] : names) {
      if (found->text == name) taken = value;
    }
    if (found->text != NameOf(taken)) Wrong(*found, expected);
  }

  void Take(const JsonValue& json, const char* name, bool& value) {
    const JsonValue* const found = json.Find(name);
    if (!found) return;
    if (!found->is(JsonValue::Kind::kBool)) return Wrong(*found, "true or false");
    value = found->text == "true";
  }

  template <class Number>
  void Take(const JsonValue& json, const char* name, double low, double high, Number& value) {
    const JsonValue* const found = json.Find(name);
    if (!found) return;
    const double number = std::strtod(found->text.c_str(), nullptr);
    if (!found->is(JsonValue::Kind::kNumber) || !(number >= low && number <= high)) {
      return Wrong(*found, "a number of pixels, or a part, that can be");
    }
    value = static_cast<Number>(number);
  }

  Diagnostics& diagnostics_;
};

JsonValue Make(JsonValue::Kind kind, std::string key, std::string text = {}) {
  JsonValue json;
  json.kind = kind;
  json.key = std::move(key);
  json.text = std::move(text);
  return json;
}

JsonValue MakeBool(std::string key, bool value) {
  return Make(JsonValue::Kind::kBool, std::move(key), value ? "true" : "false");
}

JsonValue MakeNumber(std::string key, double value) {
  std::string text = std::to_string(std::lround(value * 1000) / 1000.0);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return Make(JsonValue::Kind::kNumber, std::move(key), std::move(text));
}

}  // namespace

Settings ReadSettings(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  const std::optional<JsonValue> json = ParseJson(text, file, diagnostics);
  return json ? SettingsReader(diagnostics).Read(*json) : Settings();
}

std::string WriteSettings(const Settings& settings) {
  const auto object = [](const char* key) { return Make(JsonValue::Kind::kObject, key); };
  JsonValue tiles = object("tiles"), sizes = object("sizes");
  for (const auto& tile : kTiles) {
    tiles.children.push_back(MakeBool(tile.name, settings.tiles.*tile.member));
  }
  for (const auto& split : kSplits) {
    sizes.children.push_back(MakeNumber(split.name, settings.splits.*split.member));
  }
  JsonValue layout = object("layout"), window = object("window"), json = object("");
  const char* const growth = NameOf(settings.style.growth);
  layout.children.push_back(Make(JsonValue::Kind::kString, "growth", growth));
  for (const auto& part : kLayout) {
    layout.children.push_back(MakeBool(part.name, settings.style.*part.member));
  }
  const char* const ports = NameOf(settings.style.ports);
  layout.children.push_back(Make(JsonValue::Kind::kString, "ports", ports));
  window.children = {MakeNumber("width", settings.width), MakeNumber("height", settings.height)};
  json.children = {Make(JsonValue::Kind::kString, "palette", ToString(settings.palette)),
                   MakeBool("reduce_motion", settings.reduce_motion),
                   MakeBool("wheel_zooms", settings.wheel_zooms),
                   MakeNumber("scale", settings.scale),
                   std::move(layout),
                   std::move(tiles),
                   std::move(sizes),
                   std::move(window)};
  return PrintJson(json) + "\n";
}

void Apply(const Settings& settings, EditorState& state, double now) {
  state.screen.palette = settings.palette;
  state.screen.reduce_motion = settings.reduce_motion;
  state.screen.scale = settings.scale;
  state.screen.wheel_zooms = settings.wheel_zooms;
  state.screen.tiles = settings.tiles;
  state.screen.splits = settings.splits;
  state.workspace.SetStyle(settings.style, now);
}

Settings SettingsOf(const EditorState& state) {
  Settings settings;
  settings.palette = state.screen.palette;
  settings.reduce_motion = state.screen.reduce_motion;
  settings.scale = state.screen.scale;
  settings.wheel_zooms = state.screen.wheel_zooms;
  settings.tiles = state.screen.tiles;
  settings.splits = state.screen.splits;
  settings.style = state.workspace.style();
  return settings;
}

}  // namespace coppice::editor
