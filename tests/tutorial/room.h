// What the chapters of docs/tutorial.md share: a room with a lamp, two leaves for it, and the
// loading of a tree. The lines between `// [name]` and `// [name end]` are shown there.
#ifndef COPPICE_TESTS_TUTORIAL_ROOM_H_
#define COPPICE_TESTS_TUTORIAL_ROOM_H_

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/engine/program.h"
#include "bt_core/nodes/leaf.h"

namespace coppice {

// [switch_on]
struct Lamp {
  bool is_on = false;
};

class SwitchOn : public SyncAction {
 public:
  static constexpr const char* kDescription = "Switches the lamp on.";
  explicit SwitchOn(Lamp& lamp) : lamp_(lamp) {}

  Status Run() override {
    lamp_.is_on = true;
    return Status::kSuccess;
  }

 private:
  Lamp& lamp_;
};
// [switch_on end]

// [is_dark]
class IsDark : public Condition {
 public:
  static constexpr const char* kDescription = "Is it too dark for the camera?";
  Input<double> lux{this, "lux", "brightness [lx]"};
  Input<double> limit{this, "limit", "dark below this [lx]", 10.0};

  bool Check() override { return *lux < *limit; }
};
// [is_dark end]

// [load]
inline std::shared_ptr<const Program> Load(const std::string& xml,
                                           std::shared_ptr<const Registry> registry) {
  Diagnostics diagnostics;
  std::optional<Project> project = Project::FromText(xml, "room.xml", diagnostics);
  std::shared_ptr<const Program> program;
  if (project) {
    program = Compile(std::make_shared<Project>(std::move(*project)), registry, diagnostics);
  }
  if (!program) throw std::runtime_error(diagnostics.ToString());
  return program;
}
// [load end]

}  // namespace coppice

#endif  // COPPICE_TESTS_TUTORIAL_ROOM_H_
