#include "editor/settings/settings.h"

#include <iterator>
#include <optional>
#include <utility>

#include "editor/settings/settings_json.h"
#include "editor/theme/scale.h"

namespace coppice::editor {

Settings ReadSettings(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  Settings settings;
  const std::optional<JsonValue> json = ParseJson(text, file, diagnostics);
  if (!json) return settings;
  SettingsReader reader(diagnostics);
  if (const JsonValue* palette = json->Find("palette")) {
    const auto known = PaletteFromString(palette->text);
    if (known) settings.palette = *known;
    if (!known) reader.Wrong(*palette, "dark, light or colourblind");
  }
  reader.Take(*json, "reduce_motion", settings.reduce_motion);
  reader.Take(*json, "wheel_zooms", settings.wheel_zooms);
  reader.Take(*json, "finds_robots", settings.finds_robots);
  reader.Take(*json, "scale", 0, kScales[std::size(kScales) - 1], settings.scale);
  settings.scale = NearestScale(settings.scale);
  reader.Take(*json, "tiles", settings.tiles);
  reader.Take(*json, "sizes", settings.splits);
  reader.Take(*json, "layout", settings.style);
  const JsonValue& window = PartOf(*json, "window");
  reader.Take(window, "width", 320, 16384, settings.width);
  reader.Take(window, "height", 240, 16384, settings.height);
  return settings;
}

std::string WriteSettings(const Settings& settings) {
  JsonValue window = MakeJson(JsonValue::Kind::kObject, "window");
  window.children = {MakeJson("width", static_cast<double>(settings.width)),
                     MakeJson("height", static_cast<double>(settings.height))};
  JsonValue json = MakeJson(JsonValue::Kind::kObject, "");
  json.children = {MakeText("palette", ToString(settings.palette)),
                   MakeJson("reduce_motion", settings.reduce_motion),
                   MakeJson("wheel_zooms", settings.wheel_zooms),
                   MakeJson("finds_robots", settings.finds_robots),
                   MakeJson("scale", static_cast<double>(settings.scale)),
                   MakeJson("layout", settings.style),
                   MakeJson("tiles", settings.tiles),
                   MakeJson("sizes", settings.splits),
                   std::move(window)};
  return PrintJson(json) + "\n";
}

void Apply(const Settings& settings, EditorState& state, double now) {
  state.screen.palette = settings.palette;
  state.screen.reduce_motion = settings.reduce_motion;
  state.screen.scale = settings.scale;
  state.screen.wheel_zooms = settings.wheel_zooms;
  state.screen.finds_robots = settings.finds_robots;
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
  settings.finds_robots = state.screen.finds_robots;
  settings.tiles = state.screen.tiles;
  settings.splits = state.screen.splits;
  settings.style = state.workspace.style();
  return settings;
}

}  // namespace coppice::editor
