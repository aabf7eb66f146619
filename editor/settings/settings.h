// What the user has chosen for the whole editor, and finds again the next time: colours, scale,
// tiles, their sizes, the layout of trees, the size of the window.
//
//   Settings settings = ReadSettings(text, file, diagnostics);
//   Apply(settings, state);
//   WriteFile(file, WriteSettings(SettingsOf(state)), diagnostics);
#ifndef COPPICE_EDITOR_SETTINGS_SETTINGS_H_
#define COPPICE_EDITOR_SETTINGS_SETTINGS_H_

#include <string>

#include "bt_core/base/diagnostic.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

struct Settings {
  PaletteName palette = PaletteName::kDark;
  bool reduce_motion = false;
  float scale = 0;  ///< as ScreenState
  bool wheel_zooms = false;
  bool finds_robots = true;
  LayoutStyle style;
  Tiles tiles;
  Splits splits;
  int width = 1280;  ///< of the window [pixels]
  int height = 800;
};

/// From JSON. What cannot be right is said and is as in a new editor; members that this version
/// does not know are passed over.
Settings ReadSettings(const std::string& text, const std::string& file, Diagnostics& diagnostics);
std::string WriteSettings(const Settings& settings);

/// All but the window, which is not the state's.
void Apply(const Settings& settings, EditorState& state, double now);
Settings SettingsOf(const EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SETTINGS_SETTINGS_H_
