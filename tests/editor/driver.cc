#include "tests/editor/driver.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace coppice::editor {
namespace {

bool IsNear(Color a, Color b, int tolerance) {
  for (const int shift : {0, 8, 16}) {
    const int x = static_cast<int>((a >> shift) & 0xFF);
    const int y = static_cast<int>((b >> shift) & 0xFF);
    if (std::abs(x - y) > tolerance) return false;
  }
  return true;
}

}  // namespace

void Driver::MoveTo(Point at) {
  input.events.push_back(MouseMove{at.x, at.y});
  Frames();
}

void Driver::ClickAt(Point at, int button) {
  MoveTo(at);
  input.events.push_back(MouseButton{button, true});
  input.events.push_back(MouseButton{button, false});
  Frames(4);
}

bool Driver::Click(const std::string& path) {
  if (!Has(path)) return false;
  ClickAt(BoxOf(path).center());
  return true;
}

void Driver::Drag(Point from, Point to, int button) {
  MoveTo(from);
  input.events.push_back(MouseButton{button, true});
  Frames(1);
  input.events.push_back(MouseMove{(from.x + to.x) / 2, (from.y + to.y) / 2});
  Frames(1);
  input.events.push_back(MouseMove{to.x, to.y});
  Frames(1);
  input.events.push_back(MouseButton{button, false});
  Frames(2);
}

void Driver::Carry(Point from, Point to) {
  MoveTo(from);
  input.events.push_back(MouseButton{0, true});
  Frames(1);
  MoveTo(from + Point{20, 0});
  MoveTo(to);
}

void Driver::Press(Key key, int modifiers) {
  input.events.push_back(KeyEvent{key, true, modifiers});
  input.events.push_back(KeyEvent{key, false, kNoModifier});
  Frames();
}

void Driver::Hold(int modifiers) {
  constexpr Key kLeftShift = 340;
  input.events.push_back(KeyEvent{kLeftShift, (modifiers & kShift) != 0, modifiers});
  Frames();
}

void Driver::Wheel(float up, float left) {
  input.events.push_back(MouseWheel{left, up});
  Frames();
}

void Driver::Zoom(float up) {
  Hold(kCtrl);
  Wheel(up);
  Hold(kNoModifier);
}

void Driver::Type(const std::string& text) {
  input.events.push_back(TypedText{text});
  Frames();
}

ScriptedRobot* Driver::AddRobot(const std::string& endpoint, const std::string& xml) {
  auto robot = std::make_unique<ScriptedRobot>(endpoint, xml);
  ScriptedRobot* added = robot.get();
  editor.AddRun(std::move(robot));
  Frames();
  return added;
}

int Driver::CountColor(const Box& box, Color color, int tolerance) const {
  const Image image = editor.Picture();
  int count = 0;
  for (int y = std::max(0, static_cast<int>(box.min.y)); y < std::min<int>(image.height, box.max.y);
       ++y) {
    for (int x = std::max(0, static_cast<int>(box.min.x));
         x < std::min<int>(image.width, box.max.x); ++x) {
      count += IsNear(image.At(x, y), color, tolerance);
    }
  }
  return count;
}

void Driver::Picture(const std::string& name) const {
  if (const char* folder = std::getenv("COPPICE_PICTURES")) {
    const Outcome written = WritePng(editor.Picture(), std::string(folder) + "/" + name + ".png");
    if (!written) throw std::runtime_error(written.problem());
  }
}

void Driver::Frames(int count) {
  for (int i = 0; i < count; ++i) {
    editor.Frame(input);
    input.events.clear();
  }
}

}  // namespace coppice::editor
