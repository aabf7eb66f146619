// An editor that is brought into a state worth looking at. Positions are asked for by path, so a
// scene plays the same on a small and on a large screen.
#ifndef COPPICE_TESTS_EDITOR_GALLERY_STAGE_H_
#define COPPICE_TESTS_EDITOR_GALLERY_STAGE_H_

#include <memory>
#include <string>

#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {

/// How a scene is shown.
struct GalleryLook {
  PaletteName palette = PaletteName::kDark;
  float width = 1280;  ///< pixels
  float height = 800;
  float scale = 1;  ///< of the screen
};

class Stage {
 public:
  explicit Stage(const GalleryLook& look) : look_(look) { Restart(); }

  Driver& driver() { return *driver_; }
  EditorState& state() { return driver_->editor.state(); }

  /// Ends the editor and begins it anew, as a user does after a crash.
  void Restart();

  /// A file of the scene's folder.
  std::string Write(const std::string& name, const std::string& text) const;
  /// Writes and opens it, and lets the picture come to rest. Throws if it does not open.
  void Open(const std::string& name, const std::string& text);
  /// Opens what cannot be shown.
  void OpenBroken(const std::string& name, const std::string& text);

  /// Each throws std::logic_error if there is no such item: the scene is out of date.
  void Click(const std::string& path);
  void Hover(const std::string& path);
  /// Presses the button there and moves to the other, without letting go.
  void DragOnto(const std::string& from, const std::string& to);
  /// The same, to the right side of the other.
  void DragBehind(const std::string& from, const std::string& to);
  void Select(const std::string& node_path);
  void Run(const std::string& command);

  /// A run of RobotTrees() that was ticked so often; shown next.
  ExecutedSource& AddRobot(const std::string& name, int ticks, bool is_robot = true);
  /// Waits until notices are gone and nothing moves.
  void Rest() { driver_->Frames(230); }

 private:
  Box BoxOf(const std::string& path) const;
  void DragTo(const std::string& from, Point to);

  const GalleryLook look_;
  const TemporaryFile folder_{"unused", ""};
  std::unique_ptr<Driver> driver_;
};

/// A robot that patrols and recharges, with scripts, keys and SubTrees.
const std::string& RobotTrees();
/// Lets it drive, find a door closed, try again.
void TickPatrol(ExecutedSource& robot, int ticks);

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_GALLERY_STAGE_H_
