// Everything that the editor can show, one scene for each panel, popup, bar and state.
//
// `build/tests/bin/editor_gallery FOLDER` paints them for people; gallery_test.cc holds them to
// rules that can be computed.
#ifndef COPPICE_TESTS_EDITOR_GALLERY_SCENES_H_
#define COPPICE_TESTS_EDITOR_GALLERY_SCENES_H_

#include <vector>

#include "tests/editor/gallery/stage.h"

namespace coppice::editor {

struct GalleryScene {
  const char* name;
  void (*play)(Stage& stage);
};

/// Files: the canvas at every zoom, panels, editing.
std::vector<GalleryScene> FileScenes();
/// What opens over the tiles: popups and menus.
std::vector<GalleryScene> PopupScenes();
/// Robots and records.
std::vector<GalleryScene> RunScenes();
/// Simulations and tests.
std::vector<GalleryScene> SimulationScenes();

/// All of them.
std::vector<GalleryScene> GalleryScenes();

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_GALLERY_SCENES_H_
