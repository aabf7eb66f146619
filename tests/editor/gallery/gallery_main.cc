// Paints the scenes of the gallery into a folder, to be looked at by people:
//
//   editor_gallery FOLDER [--palette dark|light|colourblind] [--size WIDTHxHEIGHT@SCALE] [SCENE...]
//
// Without options every scene is painted in each palette and on three screens: 1280x800, and
// 2560x1440 with pixels of the same and of half the size. A picture is
// FOLDER/PALETTE_WIDTHxHEIGHT@SCALE/SCENE.png.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/editor/gallery/scenes.h"

namespace coppice::editor {
namespace {

struct Options {
  std::string folder;
  std::vector<PaletteName> palettes = {PaletteName::kDark, PaletteName::kLight,
                                       PaletteName::kColourBlind};
  std::vector<GalleryLook> screens = {{PaletteName::kDark, 1280, 800, 1},
                                      {PaletteName::kDark, 2560, 1440, 1},
                                      {PaletteName::kDark, 2560, 1440, 2}};
  std::vector<std::string> scenes;  // empty: all
};

// False if they cannot be understood.
bool Read(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--palette" && i + 1 < argc) {
      const auto palette = PaletteFromString(argv[++i]);
      if (!palette) return false;
      options.palettes = {*palette};
    } else if (word == "--size" && i + 1 < argc) {
      GalleryLook screen;
      const int read =
          std::sscanf(argv[++i], "%fx%f@%f", &screen.width, &screen.height, &screen.scale);
      if (read != 3) return false;
      options.screens = {screen};
    } else if (word.rfind("--", 0) == 0) {
      return false;
    } else if (options.folder.empty()) {
      options.folder = word;
    } else {
      options.scenes.push_back(word);
    }
  }
  return !options.folder.empty();
}

std::string FolderOf(const Options& options, const GalleryLook& look) {
  char name[96];
  std::snprintf(name, sizeof(name), "%s_%.0fx%.0f@%g", ToString(look.palette), look.width,
                look.height, look.scale);
  return options.folder + "/" + name;
}

// Returns what went wrong, or nothing.
std::string Paint(const GalleryScene& scene, const GalleryLook& look, const std::string& folder) {
  try {
    Stage stage(look);
    scene.play(stage);
    return WritePng(stage.driver().editor.Picture(), folder + "/" + scene.name + ".png").problem();
  } catch (const std::exception& error) {
    return error.what();
  }
}

int PaintAll(const Options& options) {
  int failed = 0;
  for (const PaletteName palette : options.palettes) {
    for (GalleryLook look : options.screens) {
      look.palette = palette;
      const std::string folder = FolderOf(options, look);
      std::filesystem::create_directories(folder);
      for (const GalleryScene& scene : GalleryScenes()) {
        const auto& wanted = options.scenes;
        const bool is_wanted =
            wanted.empty() || std::find(wanted.begin(), wanted.end(), scene.name) != wanted.end();
        if (!is_wanted) continue;
        const std::string error = Paint(scene, look, folder);
        if (error.empty()) continue;
        std::fprintf(stderr, "%s: %s\n", scene.name, error.c_str());
        ++failed;
      }
    }
  }
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace coppice::editor

int main(int argc, char** argv) {
  coppice::editor::Options options;
  if (!coppice::editor::Read(argc, argv, options)) {
    std::fprintf(stderr,
                 "usage: editor_gallery FOLDER [--palette dark|light|colourblind] "
                 "[--size WIDTHxHEIGHT@SCALE] [SCENE...]\n");
    return 2;
  }
  return coppice::editor::PaintAll(options);
}
