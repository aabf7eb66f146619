// Wait: lets time pass.
#ifndef COPPICE_BT_NODES_BASICS_WAIT_H_
#define COPPICE_BT_NODES_BASICS_WAIT_H_

#include "bt_core/nodes/leaf.h"

namespace coppice::leaves {

class Wait : public Action {
 public:
  static constexpr const char* kDescription =
      "Waits for some time of the tree's clock, then succeeds.";
  Input<double> seconds{this, "seconds", "how long [s]; 0 or less: not at all"};

  Status OnStart() override;
  Status OnRunning() override;
  void OnHalted() override {}

 private:
  Time end_{};
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_BASICS_WAIT_H_
