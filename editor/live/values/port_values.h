// What the keys in the ports of a shown tree hold at the shown tick of its run.
//
//   values.Look(run, scene);        // once a frame
//   values.Of(port)                 // "0.75"
#ifndef COPPICE_EDITOR_LIVE_VALUES_PORT_VALUES_H_
#define COPPICE_EDITOR_LIVE_VALUES_PORT_VALUES_H_

#include <memory>
#include <string>
#include <vector>

#include "editor/live/run_view.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

class PortValues {
 public:
  /// The nodes of the scene must have their numbers in the run (NumberNodes()). What is shown is
  /// that of the run's last Update.
  void Look(const RunView& run, const std::shared_ptr<const Scene>& scene);

  /// Of a port of Scene::ports: the beginning of the value, in one line; empty if the port has no
  /// key, or the key no value.
  std::string Of(std::uint32_t port) const;

 private:
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const TreeDescription> tree_;
  std::vector<SlotIndex> slots_;                      // by port; kNoSlot: none
  const std::vector<std::string>* values_ = nullptr;  // by slot
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_VALUES_PORT_VALUES_H_
