#include "patrol_leaves/leaves.h"

#include <iostream>

#include "bt_core/nodes/leaf.h"

namespace patrol {
namespace {

class Say : public coppice::SyncAction {
 public:
  static constexpr const char* kDescription = "Says something.";
  coppice::Input<std::string> text{this, "text", "what"};

  coppice::Status Run() override {
    std::cout << *text << "\n";
    return coppice::Status::kSuccess;
  }
};

}  // namespace

void RegisterLeaves(coppice::Registry& registry) { registry.Register<Say>("Say"); }

}  // namespace patrol
